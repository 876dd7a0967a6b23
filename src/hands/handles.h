// Handles in RViz: what is in the world can be dragged, thrown, and has a menu.
#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "paddle_drag.h"
#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/PaddleStates.h"
#include "sim_link.h"

namespace ping_pong_sim
{
class Handles
{
public:
  Handles(const std::string& simulator, std::shared_ptr<tf2_ros::Buffer> frames);

  /// Some ten times a second, in the thread that serves the global queue.
  void update();

private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedback;
  using BallJob = std::function<void(const BallState&)>;

  struct Handle
  {
    FramePose shown;
    bool grasped = false;  ///< the mouse button is down on it
    bool dragged = false;  ///< and it was moved since
  };

  void buildMenus();
  void sync(const SimStatus& status);
  void insert(const std::string& name, const FramePose& pose, const SimStatus& status);
  void showWhereThingsAre();
  void holdDraggedBalls();
  void offerThrows(bool paused);
  void onBalls(const BallStates& balls);
  void withBall(std::uint32_t id, BallJob job);

  void onFeedback(const Feedback::ConstPtr& feedback);
  void drag(const std::string& name, const FramePose& pose);
  void release(const std::string& name);
  void throwBall(std::uint32_t id, const FramePose& tip);
  void spinBall(const std::string& name, const Eigen::Vector3d& spin_along_flight);
  void warn(const std::string& refusal);

  ros::NodeHandle nh_;
  SimLink link_;
  interactive_markers::InteractiveMarkerServer server_;
  interactive_markers::MenuHandler body_menu_;
  interactive_markers::MenuHandler ball_menu_;
  ros::Publisher listeners_;  ///< the server's own topic: does anybody look?
  ros::Subscriber paddles_topic_;
  ros::Subscriber balls_topic_;
  std::map<std::string, Handle> handles_;
  std::map<std::string, std::unique_ptr<PaddleDrag>> paddles_;
  std::map<std::uint32_t, BallState> paused_balls_;  ///< those with a throwing handle
};
}  // namespace ping_pong_sim
