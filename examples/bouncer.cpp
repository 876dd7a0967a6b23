// A controller node: keeps the first ball bouncing on a paddle that lies flat at z = 1 m, half a metre high.
//   roslaunch ping_pong_sim sim.launch scene:=$(rospack find ping_pong_sim)/examples/bouncer.yaml
//   rosrun ping_pong_sim bouncer
#include <ros/ros.h>

#include <algorithm>
#include <cmath>

#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/PaddleCommand.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "bouncer");
  ros::NodeHandle nh;
  ros::Publisher commands = nh.advertise<ping_pong_sim::PaddleCommand>("paddle/command", 1);

  const boost::function<void(const ping_pong_sim::BallStates::ConstPtr&)> follow = [&](const auto& balls)
  {
    if (balls->balls.empty()) return;
    const auto& ball = balls->balls[0];
    // Mirror law (Buehler, Koditschek, Kindlmann 1994): the paddle mirrors the ball's height, scaled down, and so meets
    // it with gain times its speed. (1 - e) / (1 + e) = 0.11 makes up for the loss at e = 0.8; more of it while too
    // low.
    const double speed = ball.twist.linear.z;                                // [m/s]
    const double top = ball.pose.position.z + speed * speed / (2.0 * 9.81);  // [m], where it will be highest
    const double gain = std::clamp(0.11 + 0.1 * (1.5 - top), 0.0, 0.2);
    ping_pong_sim::PaddleCommand command;
    command.header.frame_id = "world";
    command.mode = ping_pong_sim::PaddleCommand::POSE;
    command.pose.position.x = ball.pose.position.x;  // stay below the ball [m]
    command.pose.position.y = ball.pose.position.y;
    command.pose.position.z = 1.0 - gain * (ball.pose.position.z - 1.0);
    command.pose.orientation.y = -std::sqrt(0.5);  // forehand up
    command.pose.orientation.w = std::sqrt(0.5);
    command.twist.linear.x = ball.twist.linear.x;
    command.twist.linear.y = ball.twist.linear.y;
    command.twist.linear.z = -gain * speed;
    commands.publish(command);
  };
  const ros::Subscriber balls = nh.subscribe<ping_pong_sim::BallStates>("balls", 1, follow, ros::VoidConstPtr(),
                                                                        ros::TransportHints().tcpNoDelay());
  ros::spin();
}
