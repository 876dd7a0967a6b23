// A paddle that is dragged: it moves after the hand with a velocity, so that it hits what is in its way.
#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <string>

#include "follow.h"
#include "ping_pong_sim/PaddleState.h"
#include "sim_link.h"

namespace ping_pong_sim
{
class PaddleDrag
{
public:
  PaddleDrag(ros::NodeHandle& nh, const std::string& paddle);

  /// Where the hand is now.
  void pull(const FramePose& target) { target_ = target; }
  /// Lets go at once: after a jump.
  void drop();
  /// With every state. @param time  simulated [s]
  void follow(const PaddleState& state, double time);

  bool active() const { return target_.has_value(); }

private:
  void send(bool hold);

  ros::Publisher command_;
  std::optional<FramePose> target_;
  std::optional<ping_pong::Followed> followed_;
  double time_ = 0.0;  ///< simulated [s]
};
}  // namespace ping_pong_sim
