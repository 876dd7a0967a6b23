// One number for the state of a world: equal bits, equal number.
#pragma once

#include <cstdint>

#include "ping_pong_sim/world.h"

namespace ping_pong
{
/// 64-bit hash over the bits of the world's time and of every ball in the order of ids: id, position, orientation, velocity,
/// spin. Two runs agree in it if they agree in every bit; a difference anywhere shows, but for a chance of about 1 in 1e19.
/// FNV-1a (Fowler, Noll, Vo) taken over words of 64 bits, each word mixed with the last step of splitmix64, so that the
/// upper bits of a number reach the lower ones of the hash. A ball takes some 0.1 us; the world's bodies do not count.
std::uint64_t stateHash(const World& world);
}  // namespace ping_pong
