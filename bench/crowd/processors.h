// Which thread runs where.
#pragma once

#include <cstddef>

namespace ping_pong::bench
{
/// Gives each thread of this process a processor of its own, from now on; if there are too few, some share one. Left to the
/// system, threads may share one for many ticks while another has nothing to do.
/// @throw std::runtime_error if the system refuses
void giveProcessors();
/// Each thread may run anywhere again where the first one could when the process began.
void takeProcessorsBack();
/// How many this process may use.
std::size_t processors();
}  // namespace ping_pong::bench
