#include "pacer.h"

#include <algorithm>

namespace ping_pong_sim
{
namespace
{
WallClock::duration fromSeconds(double seconds)
{
  return std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>(seconds));
}
}  // namespace

Pacer::Pacer(double period) : period_(period), start_(WallClock::now()) {}

void Pacer::restart(WallClock::time_point now)
{
  start_ = now;
  ticks_ = 0;
}

WallClock::time_point Pacer::next(WallClock::time_point now)
{
  ++ticks_;
  const WallClock::time_point deadline = start_ + fromSeconds(static_cast<double>(ticks_) * period_);
  if (now - deadline > fromSeconds(kMaxLag)) restart(now);
  return deadline;
}

RateGate::RateGate(double rate) : interval_(fromSeconds(1.0 / rate)), due_(WallClock::now()) {}

bool RateGate::open(WallClock::time_point now, double busy)
{
  // Half a millisecond early counts as due: else a tick rate equal to the gate's would pass every second time only.
  if (now + std::chrono::microseconds(500) < due_) return false;
  due_ = std::max(due_ + std::max(interval_, fromSeconds(busy)), now);
  return true;
}
}  // namespace ping_pong_sim
