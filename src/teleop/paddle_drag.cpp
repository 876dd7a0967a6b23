#include "paddle_drag.h"

#include "messages.h"
#include "ping_pong_sim/PaddleCommand.h"

namespace ping_pong_sim
{
namespace
{
constexpr double kRate = 25.0;        ///< [1/s]: 40 ms behind the hand; a jump of 0.3 m is a stroke of 2.8 m/s
constexpr double kLongestTick = 0.1;  ///< [s]; what is longer is a jump of time
}  // namespace

PaddleDrag::PaddleDrag(ros::NodeHandle& nh, const std::string& paddle)
    : command_(nh.advertise<PaddleCommand>(paddle + "/command", 1))
{
}

void PaddleDrag::drop()
{
  target_.reset();
  followed_.reset();
}

void PaddleDrag::follow(const PaddleState& state, double time)
{
  const double dt = time - time_;
  time_ = time;
  if (!target_) return;
  if (!followed_ || dt <= 0.0 || dt > kLongestTick)
  {
    const FramePose pose = fromMessage(state.pose);
    followed_ = {pose.p, pose.q, fromMessage(state.twist.linear), fromMessage(state.twist.angular)};
    return;
  }
  followed_ = ping_pong::follow(*followed_, target_->p, target_->q, kRate, dt);
  const bool there = ping_pong::arrived(*followed_, target_->p, target_->q);
  send(there);
  if (there) drop();
}

void PaddleDrag::send(bool hold)
{
  PaddleCommand command;
  command.mode = hold ? PaddleCommand::HOLD : PaddleCommand::POSE;
  command.pose = toMessage(FramePose{followed_->p, followed_->q});
  command.twist.linear = toVectorMessage(followed_->v);
  command.twist.angular = toVectorMessage(followed_->w);
  command_.publish(command);
}
}  // namespace ping_pong_sim
