#include "ball_feed.h"

#include <algorithm>
#include <exception>

#include "launching.h"

namespace ping_pong_sim
{
namespace
{
constexpr double kRounding = 1e-9;  // [s]; ticks and periods meet up to rounding
}  // namespace

void BallFeed::update(ping_pong::World& world, Rejections& rejections)
{
  if (params_.period == 0.0) return;
  if (world.time() + kRounding < static_cast<double>(due_ + 1) * params_.period) return;
  try
  {
    feed(world);
  }
  catch (const std::exception& error)
  {
    rejections.add("feed", error.what());
  }
  ++due_;
}

void BallFeed::restart()
{
  due_ = 0;
  balls_.clear();
}

void BallFeed::feed(ping_pong::World& world)
{
  const auto gone = [&](ping_pong::BallId id) { return world.findBall(id) == ping_pong::kNone; };
  balls_.erase(std::remove_if(balls_.begin(), balls_.end(), gone), balls_.end());
  for (; balls_.size() >= params_.keep; balls_.pop_front()) world.deleteBall(balls_.front());
  const ping_pong::Shot& shot = params_.shot == kRandomShot ? ping_pong::drawnShot(due_) : shotNamed(params_.shot);
  balls_.push_back(launchBall(world, tableFrame(world), shot));
}
}  // namespace ping_pong_sim
