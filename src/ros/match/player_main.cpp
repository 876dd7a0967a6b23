// A computer player: rosrun ping_pong_sim player _scene:=PATH _paddle:=paddle_b _level:=3
#include <ros/callback_queue.h>
#include <ros/init.h>

#include <exception>

#include "player_node.h"
#include "ros/base/param_reader.h"
#include "ros/base/scene_path.h"

namespace
{
using namespace ping_pong_sim;

PlayerNodeParams readParams(ros::NodeHandle& private_nh)
{
  ParamReader reader(private_nh);
  PlayerNodeParams p;
  p.scene_path = scenePath(reader.text("scene_directory", ""), reader.text("scene", "match"));
  p.paddle = reader.text("paddle", p.paddle);
  p.umpire = reader.text("umpire", p.umpire);
  const auto pause = [](double t) { return t >= 0.0 && t <= 60.0; };
  p.serve_after = reader.number("serve_after", p.serve_after, pause, "0 to 60 [s]");
  const auto level = [](double n) { return n >= 1.0 && n <= 5.0 && n == static_cast<int>(n); };
  p.level = static_cast<int>(reader.number("level", p.level, level, "a level from 1 to 5"));
  const auto seed = [](double n) { return n >= 0.0 && n <= 1e9 && n == static_cast<int>(n); };
  p.seed = static_cast<std::uint64_t>(reader.number("seed", 1.0, seed, "a whole number, 0 to 1e9"));
  p.style = ping_pong::play::styleFromName(reader.text("style", "mixed"));
  p.show_plan = reader.flag("show_plan", p.show_plan);
  for (const std::string& name : reader.unread()) ROS_WARN_STREAM("parameter " << name << " is not known; ignored");
  return p;
}
}  // namespace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "player");
  ros::NodeHandle nh, private_nh("~");
  try
  {
    PlayerNode player(nh, private_nh, readParams(private_nh));
    while (ros::ok())
    {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
      player.update();
    }
  }
  catch (const std::exception& error)
  {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
  return 0;
}
