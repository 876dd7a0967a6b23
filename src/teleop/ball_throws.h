// Beads that throw the balls of a paused world: a ball's velocity is drawn from it like an arrow.
#pragma once

#include <interactive_markers/interactive_marker_server.h>

#include <map>

#include "ping_pong_sim/BallStates.h"
#include "sim_link.h"

namespace ping_pong_sim
{
constexpr std::size_t kMostHandledBalls = 20;  ///< with handles and beads: more would hide the scene

class BallThrows
{
public:
  BallThrows(const ros::NodeHandle& nh, SimLink& link, interactive_markers::InteractiveMarkerServer& server);
  BallThrows(const BallThrows&) = delete;
  BallThrows& operator=(const BallThrows&) = delete;

  /// Now and then: shows the beads while the world is paused, and only then.
  void offer(bool paused);

private:
  void onBalls(const BallStates& balls);
  void throwBall(std::uint32_t id, const Eigen::Vector3d& bead_W);

  ros::NodeHandle nh_;
  SimLink& link_;
  interactive_markers::InteractiveMarkerServer& server_;
  ros::Subscriber balls_topic_;
  std::map<std::uint32_t, BallState> balls_;  ///< those with a bead
};
}  // namespace ping_pong_sim
