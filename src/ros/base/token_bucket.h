// How many of something may be done: so many per wall second, and after a pause as many at once.
#pragma once

#include <algorithm>

#include "pacer.h"

namespace ping_pong_sim
{
class TokenBucket
{
public:
  /// @param rate  [1/s], > 0
  explicit TokenBucket(double rate) : rate_(rate), tokens_(rate) {}

  /// How many of `wanted` may be done now; they count as done.
  std::size_t take(std::size_t wanted, WallClock::time_point now)
  {
    tokens_ = std::min(rate_, tokens_ + rate_ * std::chrono::duration<double>(now - last_).count());
    last_ = now;
    const std::size_t granted = std::min(wanted, static_cast<std::size_t>(tokens_));
    tokens_ -= static_cast<double>(granted);
    return granted;
  }

private:
  double rate_;
  double tokens_;
  WallClock::time_point last_ = WallClock::now();
};
}  // namespace ping_pong_sim
