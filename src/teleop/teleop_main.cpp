// The keys in a terminal: rosrun ping_pong_sim teleop
#include <ros/init.h>
#include <ros/spinner.h>
#include <tf2_ros/transform_listener.h>

#include <cstdio>
#include <exception>

#include "operator.h"
#include "ros/base/param_reader.h"
#include "terminal.h"

namespace
{
using namespace ping_pong_sim;

OperatorParams readParams(ParamReader& reader)
{
  const auto positive = [](double value) { return value > 0.0 && value < 1e6; };
  const auto orZero = [](double value) { return value >= 0.0 && value < 1e6; };
  OperatorParams p;
  ping_pong::GlideParams& g = p.glide;
  g.acceleration = reader.number("acceleration", g.acceleration, positive, "above 0 [m/s^2]");
  g.angular_acceleration = reader.number("angular_acceleration", g.angular_acceleration, positive, "above 0 [rad/s^2]");
  g.damping = reader.number("damping", g.damping, orZero, "0 or more [1/s]");
  g.speed = reader.number("speed", g.speed, positive, "above 0 [m/s]");
  g.angular_speed = reader.number("angular_speed", g.angular_speed, positive, "above 0 [rad/s]");
  ping_pong::Reach& reach = p.reach;
  reach.limited = reader.flag("reach", reach.limited);
  reach.behind = reader.number("reach_behind", reach.behind, positive, "above 0 [m]");
  reach.over = reader.number("reach_over", reach.over, orZero, "0 or more [m]");
  reach.side = reader.number("reach_side", reach.side, positive, "above 0 [m]");
  reach.below = reader.number("reach_below", reach.below, orZero, "0 or more [m]");
  reach.above = reader.number("reach_above", reach.above, positive, "above 0 [m]");
  p.shot = reader.text("shot", p.shot);
  p.step = reader.number("step", p.step, positive, "above 0 [s]");
  return p;
}

void show(const HandsState& state)
{
  if (state.help) std::printf("\n%s", ping_pong::keyHelp().c_str());
  std::printf("\r\033[K%s%s%s ", state.selected.empty() ? "nothing selected" : state.selected.c_str(),
              state.note.empty() ? "" : ": ", state.note.c_str());
  std::fflush(stdout);
}

void run()
{
  ros::NodeHandle private_nh("~");
  ParamReader reader(private_nh);
  const OperatorParams params = readParams(reader);
  NodeNames names;
  names.simulator = reader.text("simulator", names.simulator);
  names.umpire = reader.text("umpire", names.umpire);
  const auto isPlayer = [](double n) { return n == -1.0 || n == 0.0 || n == 1.0; };
  const int player = static_cast<int>(reader.number("player", 0.0, isPlayer, "0 or 1, or -1 (only looks on)"));
  for (const std::string& name : reader.unread()) ROS_WARN_STREAM("parameter " << name << " is not known; ignored");

  const auto frames = std::make_shared<tf2_ros::Buffer>();
  tf2_ros::TransformListener listener(*frames);
  Operator hands(names, player, frames, ping_pong::terminalHold(), {show, {}});
  hands.setParams(params);
  ping_pong::Terminal terminal;
  std::printf("H shows the keys, Ctrl-C ends. You stand behind the -x end of the table.\n");
  while (ros::ok() && terminal.open())
  {
    if (const std::optional<ping_pong::Key> key = terminal.read(0.1)) hands.press(*key);
  }
  std::printf("\n");
}
}  // namespace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "teleop");
  ros::start();
  try
  {
    run();
  }
  catch (const std::exception& error)
  {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
  return 0;
}
