// Real-time factor and contact rate over the last second or so of wall time.
#pragma once

#include <cstdint>
#include <deque>

#include "pacer.h"

namespace ping_pong_sim
{
class RateMeter
{
public:
  void clear() { samples_.clear(); }

  /// @param simulated  simulated time so far, never going back [s]
  /// @param contacts   impacts so far; going back (reset) clears
  void add(WallClock::time_point now, double simulated, std::uint64_t contacts)
  {
    if (!samples_.empty() && contacts < samples_.back().contacts) clear();
    samples_.push_back({now, simulated, contacts});
    while (samples_.size() > 2 && now - samples_[1].wall >= std::chrono::seconds(1)) samples_.pop_front();
  }

  /// Simulated per wall second; 0 if unknown.
  double realTimeFactor() const { return ratio(simulated(), wall()); }
  /// Impacts per simulated second; 0 if unknown [1/s].
  double contactRate() const
  {
    return samples_.empty() ? 0.0 : ratio(double(samples_.back().contacts - samples_.front().contacts), simulated());
  }
  double wall() const  ///< length of the window [s]
  {
    if (samples_.empty()) return 0.0;
    return std::chrono::duration<double>(samples_.back().wall - samples_.front().wall).count();
  }

private:
  struct Sample
  {
    WallClock::time_point wall;
    double simulated;
    std::uint64_t contacts;
  };
  static double ratio(double a, double b) { return b > 0.0 ? a / b : 0.0; }
  double simulated() const { return samples_.empty() ? 0.0 : samples_.back().simulated - samples_.front().simulated; }

  std::deque<Sample> samples_;
};
}  // namespace ping_pong_sim
