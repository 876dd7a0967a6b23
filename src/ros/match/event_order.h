// What came on two topics, back in the order of time: contacts and states of balls travel over connections of their own.
#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "ping_pong_sim/contact.h"
#include "ping_pong_sim/world.h"

namespace ping_pong_sim
{
/// A ball at the end of a tick.
struct SeenBall
{
  ping_pong::BallId id = 0;
  double radius = ping_pong::kBallRadius;  ///< [m]
  ping_pong::BallState state;              ///< in the world frame
};

/// All balls at the end of a tick.
struct TickEnd
{
  double time = 0.0;  ///< world time [s]
  std::vector<SeenBall> balls;
};

/// Each topic is in order by itself. An event is handed on as soon as the other topic has told what comes after it, or when it has
/// waited for `patience`: then there is nothing to come, or it comes too late to be waited for.
class EventOrder
{
public:
  explicit EventOrder(double patience = 0.05) : patience_(patience) {}  ///< [s of `now`]

  /// @param now  monotonic wall time [s], as in release()
  void add(const ping_pong::Contact& contact, double now) { contacts_.push_back({now, contact}); }
  void add(TickEnd tick, double now) { ticks_.push_back({now, std::move(tick)}); }

  /// Hands on what is in order by now.
  void release(double now, const std::function<void(const ping_pong::Contact&)>& contact,
               const std::function<void(const TickEnd&)>& tick);
  void clear();

private:
  template <typename Event>
  struct Arrived
  {
    double at;
    Event event;
  };
  template <typename Event>
  bool waited(const std::deque<Arrived<Event>>& queue, double now) const
  {
    return now - queue.front().at >= patience_;
  }

  double patience_;
  std::deque<Arrived<ping_pong::Contact>> contacts_;
  std::deque<Arrived<TickEnd>> ticks_;
};
}  // namespace ping_pong_sim
