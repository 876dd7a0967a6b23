// Work in other processes: what hangs or crashes is reported and does not take the rest with it.
#pragma once

#include <cstdint>
#include <functional>

#include "verdict.h"

namespace ping_pong::stability
{
struct Watch
{
  std::uint64_t first = 0, count = 0;
  unsigned processes = 1;
  double patience = 10.0;  ///< for one verdict [s]
};

/// Calls work(index) for each index, and told(index, verdict) here, in any order. Check::Hung and Check::Crashed come
/// from here.
void watched(const Watch& watch, const std::function<Verdict(std::uint64_t)>& work,
             const std::function<void(std::uint64_t, const Verdict&)>& told);
}  // namespace ping_pong::stability
