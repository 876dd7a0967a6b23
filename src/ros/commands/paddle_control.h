// From mailbox to world: what a paddle obeys now, and for how long.
#pragma once

#include <optional>
#include <string>

#include "command_mailbox.h"

namespace ping_pong_sim
{
class PaddleControl
{
public:
  /// @param body     index in the world
  /// @param timeout  simulated time after which a paddle without commands holds still [s]
  PaddleControl(ros::NodeHandle& nh, const ping_pong::World& world, std::size_t body, CommandMailbox::FrameNames frames,
                double timeout, Rejections& rejections);

  /// Before each tick. @param now  simulated time that only grows [s]
  void update(ping_pong::World& world, double now);
  /// Forgets its command: after a jump or a reset. The world has given up the command, too.
  void forget();

  /// Until a command has come that no tick has obeyed yet, or this instant. True: it has.
  bool waitForCommand(std::chrono::steady_clock::time_point deadline) { return mailbox_.wait(deadline); }
  const std::string& name() const { return name_; }
  std::size_t body() const { return body_; }
  double commandAge(double now) const;  ///< [s]; -1: none since start, jump or reset

private:
  void obey(ping_pong::World& world, const Order& order, double now);
  void send(ping_pong::World& world, const Order& order);

  std::size_t body_;
  std::string name_;
  double timeout_;  ///< [s]
  Rejections& rejections_;
  std::optional<Order> active_;
  std::optional<double> obeyed_at_;  ///< [s]
  CommandMailbox mailbox_;
};
}  // namespace ping_pong_sim
