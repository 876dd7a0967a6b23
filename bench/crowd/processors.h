// Which thread runs where.
#pragma once

namespace ping_pong::bench
{
/// Gives each thread of this process a processor of its own, from now on; if there are too few, some share one. Left to the
/// system, threads may share one for many ticks while another has nothing to do.
/// @throw std::runtime_error if the system refuses
void giveProcessors();
}  // namespace ping_pong::bench
