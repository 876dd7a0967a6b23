#include "paddle_control.h"

#include <utility>

namespace ping_pong_sim
{
PaddleControl::PaddleControl(ros::NodeHandle& nh, const ping_pong::World& world, std::size_t body,
                             CommandMailbox::FrameNames frames, double timeout, Rejections& rejections)
    : body_(body),
      name_(world.body(body).name),
      timeout_(timeout),
      rejections_(rejections),
      mailbox_(nh, name_, std::move(frames), rejections)
{
}

void PaddleControl::update(ping_pong::World& world, double now)
{
  if (const std::optional<Order> order = mailbox_.take())
  {
    obey(world, *order, now);
  }
  else if (active_ && now - *obeyed_at_ >= timeout_)
  {
    active_.reset();
    world.command(body_, {});
  }
  else if (active_ && active_->turns_along)
  {
    send(world, *active_);
  }
}

void PaddleControl::forget()
{
  mailbox_.take();
  active_.reset();
  obeyed_at_.reset();
}

double PaddleControl::commandAge(double now) const
{
  return obeyed_at_ ? now - *obeyed_at_ : -1.0;
}

void PaddleControl::obey(ping_pong::World& world, const Order& order, double now)
{
  try
  {
    send(world, order);
    active_ = order;
    obeyed_at_ = now;
  }
  catch (const InputError& error)
  {
    rejections_.add(name_ + "/command", error.what());
  }
}

void PaddleControl::send(ping_pong::World& world, const Order& order)
{
  const ping_pong::Refusal refusal = world.command(body_, commandInWorld(framePose(world, order.frame), order.command));
  if (refusal) throw InputError(refusal.reason);
}
}  // namespace ping_pong_sim
