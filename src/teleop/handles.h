// Handles in RViz: what is in the world can be dragged, thrown, and has a menu.
#pragma once

#include <interactive_markers/interactive_marker_server.h>

#include <map>
#include <memory>
#include <string>

#include "ball_throws.h"
#include "handle_menus.h"
#include "paddle_drag.h"
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

  struct Handle
  {
    FramePose shown;
    bool grasped = false;  ///< the mouse button is down on it
    bool dragged = false;  ///< and it was moved since
  };

  void sync(const SimStatus& status);
  void insert(const std::string& name, const FramePose& pose, const SimStatus& status);
  void showWhereThingsAre();
  void holdDraggedBalls();

  void onFeedback(const Feedback::ConstPtr& feedback);
  void drag(const std::string& name, const FramePose& pose);
  void release(const std::string& name);

  ros::NodeHandle nh_;
  SimLink link_;
  interactive_markers::InteractiveMarkerServer server_;
  HandleMenus menus_;
  BallThrows throws_;
  ros::Publisher listeners_;  ///< the server's own topic: does anybody look?
  ros::Subscriber paddles_topic_;
  std::map<std::string, Handle> handles_;
  std::map<std::string, std::unique_ptr<PaddleDrag>> paddles_;
};
}  // namespace ping_pong_sim
