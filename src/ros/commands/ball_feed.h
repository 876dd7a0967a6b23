// The ball machine: a shot every so many seconds of simulated time.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "ping_pong_sim/world.h"
#include "ros/base/rejections.h"

namespace ping_pong_sim
{
constexpr char kRandomShot[] = "random";  ///< value of ~feed_shot: all of them, see drawnShot()

struct FeedParams
{
  double period = 0.0;             ///< simulated time from ball to ball [s]; 0: no feed
  std::string shot = kRandomShot;  ///< name of a shot, or kRandomShot
  std::size_t keep = 10;           ///< fed balls that may be in the world at once, > 0
};

class BallFeed
{
public:
  explicit BallFeed(const FeedParams& params) : params_(params) {}

  /// After every tick: adds the ball that is due. Ball n is due at the world time n * period; so the first one comes
  /// after one period. The oldest makes room for it, if there are `keep` already. A ball that finds its place taken is
  /// left out, and counted as a rejection.
  void update(ping_pong::World& world, Rejections& rejections);

  /// The world began anew, and with it the series of shots.
  void restart();

private:
  void feed(ping_pong::World& world);

  FeedParams params_;
  std::uint64_t due_ = 0;                ///< balls that were due until now
  std::deque<ping_pong::BallId> balls_;  ///< those that still are in the world, oldest first
};
}  // namespace ping_pong_sim
