// The simulator's clock: what stamps and /clock say.
#pragma once

#include <ros/time.h>

#include <cmath>

namespace ping_pong_sim
{
/// It only runs forward (tf2 refuses time that jumps back) and is never zero (ROS takes zero for "no time yet").
/// Time is base + ticks * tick, not a running sum.
class SimClock
{
public:
  /// @param start  first stamp, > 0
  /// @param tick   [s]
  SimClock(ros::Time start, double tick) : start_(start), base_(start), tick_(tick) {}

  ros::Time now() const { return after(static_cast<double>(ticks_) * tick_); }
  double tick() const { return tick_; }

  void addTick() { ++ticks_; }
  /// An odd amount: the last tick of a ~step [s].
  void add(double seconds) { setBase(after(static_cast<double>(ticks_) * tick_ + seconds)); }
  /// A jump of the state (reset, set state, ...) takes a microsecond: tf2 ignores a second transform with an old stamp.
  void addJump() { setBase(now() + ros::Duration(0, 1000)); }
  /// Forward to `time`, if that is later.
  void catchUp(const ros::Time& time)
  {
    if (time > now()) setBase(time);
  }
  /// Back to the first stamp; for those who ask for it.
  void rewind() { setBase(start_); }

private:
  ros::Time after(double seconds) const
  {
    ros::Time time;
    return time.fromNSec(base_.toNSec() + static_cast<uint64_t>(std::llround(seconds * 1e9)));
  }
  void setBase(const ros::Time& time)
  {
    base_ = time;
    ticks_ = 0;
  }

  ros::Time start_;
  ros::Time base_;
  double tick_;
  uint64_t ticks_ = 0;
};
}  // namespace ping_pong_sim
