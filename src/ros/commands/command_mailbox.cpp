#include "command_mailbox.h"

#include <utility>

namespace ping_pong_sim
{
CommandMailbox::CommandMailbox(ros::NodeHandle& nh, const std::string& paddle, FrameNames frames,
                               Rejections& rejections)
    : paddle_(paddle), frames_(std::move(frames)), rejections_(rejections)
{
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  command_ = nh.subscribe(paddle + "/command", 1, &CommandMailbox::onCommand, this, hints);
  twist_ = nh.subscribe(paddle + "/cmd_vel", 1, &CommandMailbox::onTwist, this, hints);
}

std::optional<Order> CommandMailbox::take()
{
  std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(order_, std::nullopt);
}

bool CommandMailbox::wait(std::chrono::steady_clock::time_point deadline)
{
  std::unique_lock<std::mutex> lock(mutex_);
  return arrived_.wait_until(lock, deadline, [this] { return order_.has_value(); });
}

void CommandMailbox::onCommand(const PaddleCommand::ConstPtr& message)
{
  try
  {
    const std::string& frame = message->header.frame_id;
    if (!isWorldFrame(frame) && frames_->count(frame) == 0)
    {
      throw InputError("frame_id: " + frame + ": expected world or the name of a body");
    }
    put({fromCommand(*message), frame, false});
  }
  catch (const InputError& error)
  {
    rejections_.add(paddle_ + "/command", error.what());
  }
}

void CommandMailbox::onTwist(const geometry_msgs::Twist::ConstPtr& message)
{
  try
  {
    Order order;
    order.command.mode = ping_pong::PaddleCommand::Mode::Velocity;
    order.command.twist = fromTwist(*message, "twist");
    order.frame = paddle_;
    order.turns_along = true;
    put(order);
  }
  catch (const InputError& error)
  {
    rejections_.add(paddle_ + "/cmd_vel", error.what());
  }
}

void CommandMailbox::put(const Order& order)
{
  std::lock_guard<std::mutex> lock(mutex_);
  order_ = order;
  arrived_.notify_all();
}
}  // namespace ping_pong_sim
