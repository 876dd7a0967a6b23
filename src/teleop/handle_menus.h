// The menus of the handles, under the right mouse button.
#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>

#include <functional>
#include <string>

#include "ping_pong_sim/BallStates.h"
#include "sim_link.h"

namespace ping_pong_sim
{
class HandleMenus
{
public:
  HandleMenus(const ros::NodeHandle& nh, SimLink& link);
  HandleMenus(const HandleMenus&) = delete;
  HandleMenus& operator=(const HandleMenus&) = delete;

  /// Gives a new handle its menu.
  void apply(interactive_markers::InteractiveMarkerServer& server, const std::string& name);

private:
  void fillBallMenu();
  void withBall(std::uint32_t id, std::function<void(const BallState&)> job);
  void spinBall(const std::string& name, const Eigen::Vector3d& spin_along_flight);

  ros::NodeHandle nh_;
  SimLink& link_;
  interactive_markers::MenuHandler body_menu_;
  interactive_markers::MenuHandler ball_menu_;
};
}  // namespace ping_pong_sim
