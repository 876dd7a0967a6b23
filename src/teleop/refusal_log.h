// What a service refused, for the log: once a second at most, for a drag asks thirty times a second.
#pragma once

#include <ros/console.h>

#include <string>

namespace ping_pong_sim
{
inline void warn(const std::string& refusal)
{
  if (!refusal.empty()) ROS_WARN_STREAM_THROTTLE(1.0, "handles: " << refusal);
}
}  // namespace ping_pong_sim
