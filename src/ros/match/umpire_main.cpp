// The umpire of a match: rosrun ping_pong_sim umpire _scene:=PATH
#include <ros/callback_queue.h>
#include <ros/init.h>

#include <exception>

#include "ros/base/param_reader.h"
#include "ros/base/scene_path.h"
#include "umpire_node.h"

namespace
{
using namespace ping_pong_sim;

UmpireParams readParams(ros::NodeHandle& private_nh)
{
  ParamReader reader(private_nh);
  UmpireParams p;
  p.scene_path = scenePath(reader.text("scene_directory", ""), reader.text("scene", "match"));
  p.simulator = reader.text("simulator", p.simulator);
  p.rules = reader.text("rules", p.rules);
  const auto odd = [](double n)
  { return n >= 0.0 && n <= 99.0 && (n == 0.0 || static_cast<int>(n) % 2 == 1) && n == static_cast<int>(n); };
  p.best_of = static_cast<int>(reader.number("best_of", 0, odd, "an odd number of games, or 0 for that of the rules"));
  const auto time = [](double t) { return t >= 0.0 && t <= 3600.0; };
  p.serve_within = reader.number("serve_within", p.serve_within, time, "0 (nobody is hurried) to 3600 [s]");
  p.change_ends = reader.flag("change_ends", p.change_ends);
  p.result_file = reader.text("result_file", p.result_file);
  p.players = {reader.text("player_a", p.players[0]), reader.text("player_b", p.players[1])};
  for (const std::string& name : reader.unread()) ROS_WARN_STREAM("parameter " << name << " is not known; ignored");
  return p;
}
}  // namespace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "umpire");
  ros::NodeHandle nh, private_nh("~");
  try
  {
    UmpireNode umpire(nh, private_nh, readParams(private_nh));
    while (ros::ok())
    {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
      umpire.update();
    }
  }
  catch (const std::exception& error)
  {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
  return 0;
}
