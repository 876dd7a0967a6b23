// The last good command that arrived for one paddle.
#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "ros/base/conversions.h"
#include "ros/base/rejections.h"

namespace ping_pong_sim
{
/// A command as it came: the vectors named _W in it are still expressed in `frame`.
struct Order
{
  ping_pong::PaddleCommand command;
  std::string frame;
  bool turns_along = false;  ///< cmd_vel: stays fixed in the paddle's frame while the paddle turns
};

/// Subscribes to NAME/command and NAME/cmd_vel. Callbacks run in the thread of commands, take() in the simulation loop:
/// a command never waits for a tick, and a tick never waits for a command.
class CommandMailbox
{
public:
  using FrameNames = std::shared_ptr<const std::set<std::string>>;

  /// @param frames  bodies of the scene, in whose frames commands may be given
  CommandMailbox(ros::NodeHandle& nh, const std::string& paddle, FrameNames frames, Rejections& rejections);

  /// The newest command since the last call.
  std::optional<Order> take();
  /// Until there is a command to take, or this instant. True: there is one.
  bool wait(std::chrono::steady_clock::time_point deadline);

private:
  void onCommand(const PaddleCommand::ConstPtr& message);
  void onTwist(const geometry_msgs::Twist::ConstPtr& message);
  void put(const Order& order);

  std::string paddle_;
  FrameNames frames_;
  Rejections& rejections_;
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::optional<Order> order_;
  ros::Subscriber command_;  // last: no callback may outlive what it uses
  ros::Subscriber twist_;
};
}  // namespace ping_pong_sim
