#include "rejections.h"

#include <ros/console.h>

namespace ping_pong_sim
{
void Rejections::add(const std::string& what, const std::string& reason)
{
  std::lock_guard<std::mutex> lock(mutex_);
  ++count_;
  last_ = what + ": " + reason;
  if (mayWarn()) ROS_WARN_STREAM("refused " << last_ << " (" << count_ << " refused so far)");
}

std::uint64_t Rejections::count() const
{
  std::lock_guard<std::mutex> lock(mutex_);
  return count_;
}

std::string Rejections::last() const
{
  std::lock_guard<std::mutex> lock(mutex_);
  return last_;
}

// Once a second of wall time. ROS_WARN_THROTTLE counts in ROS time, which stands still while paused and races when flat
// out.
bool Rejections::mayWarn()
{
  const auto now = std::chrono::steady_clock::now();
  if (warned_ && now - warned_at_ < std::chrono::seconds(1)) return false;
  warned_ = true;
  warned_at_ = now;
  return true;
}
}  // namespace ping_pong_sim
