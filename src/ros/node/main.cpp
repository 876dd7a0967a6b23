#include <ros/console.h>
#include <ros/init.h>

#include <csignal>
#include <exception>

#include "sim_node.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "ping_pong_sim");
  ros::start();                                               // now, so that the log works and /use_sim_time is known
  std::signal(SIGTERM, [](int) { ros::requestShutdown(); });  // as for SIGINT, which roscpp looks after
  try
  {
    ping_pong_sim::SimNode node;
    node.run();
  }
  catch (const std::exception& error)
  {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
  return 0;
}
