// The keys in a terminal: rosrun ping_pong_sim teleop
#include <ros/init.h>
#include <ros/spinner.h>
#include <tf2_ros/transform_listener.h>

#include <cstdio>
#include <exception>

#include "operator.h"
#include "ros/param_reader.h"
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
  const std::string simulator = reader.text("simulator", "ping_pong_sim");
  for (const std::string& name : reader.unread()) ROS_WARN_STREAM("parameter " << name << " is not known; ignored");

  const auto frames = std::make_shared<tf2_ros::Buffer>();
  tf2_ros::TransformListener listener(*frames);
  Operator hands(simulator, frames, ping_pong::terminalHold(), {show, {}});
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
