// Wall time: when the next tick is due, and how often something may be done at most.
#pragma once

#include <chrono>

namespace ping_pong_sim
{
using WallClock = std::chrono::steady_clock;

/// Deadlines start + k * period: absolute, so that a late tick does not delay all that follow.
class Pacer
{
public:
  /// @param period  wall time per tick [s]
  explicit Pacer(double period);

  void restart(WallClock::time_point now);
  /// Deadline of the tick that was just done. After a lag of more than kMaxLag the lost time is given up.
  WallClock::time_point next(WallClock::time_point now);

private:
  static constexpr double kMaxLag = 0.1;  ///< [s]
  double period_;                         ///< [s]
  WallClock::time_point start_;
  long long ticks_ = 0;
};

/// True at most once per interval.
class RateGate
{
public:
  /// @param rate  [1/s], > 0
  explicit RateGate(double rate);
  /// @param busy  wall time that must pass before it opens again, if that is longer than the interval [s]
  bool open(WallClock::time_point now, double busy = 0.0);

private:
  WallClock::duration interval_;
  WallClock::time_point due_;
};
}  // namespace ping_pong_sim
