// Drag handles for RViz: rosrun ping_pong_sim handles
#include <ros/callback_queue.h>
#include <ros/init.h>
#include <tf2_ros/transform_listener.h>

#include "handles.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "handles");
  ros::NodeHandle private_nh("~");
  const auto frames = std::make_shared<tf2_ros::Buffer>();
  tf2_ros::TransformListener listener(*frames);
  ping_pong_sim::Handles handles(private_nh.param<std::string>("simulator", "ping_pong_sim"), frames);
  const double period = 0.066;  // of handles that follow what moves [s]
  double due = 0.0;
  while (ros::ok())
  {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
    if (ping_pong_sim::wallSeconds() < due) continue;
    due = ping_pong_sim::wallSeconds() + period;
    handles.update();
  }
  return 0;
}
