#include "repeat.h"

#include <cmath>

namespace ping_pong_sim
{
namespace
{
constexpr double kOutOfSight = 5.0;  ///< from the world's origin, along the floor [m]
constexpr double kDown = 0.01;       ///< a gap to the floor below which a ball that does not bounce is down [m]
constexpr double kBounce = 0.3;      ///< a vertical speed below which it does not [m/s]

bool isDone(const ping_pong::World& world, std::size_t ball, double floor)
{
  const ping_pong::BallState state = world.ballState(ball);
  if (std::hypot(state.p_WB.x(), state.p_WB.y()) > kOutOfSight) return true;
  if (world.resting(ball)) return true;
  return state.p_WB.z() - world.ballParams(ball).radius - floor < kDown && std::abs(state.v_WB.z()) < kBounce;
}

// NaN, which nothing is below of, if there is none.
double floorOf(const ping_pong::World& world)
{
  for (std::size_t i = 0; i < world.bodyCount(); ++i)
  {
    if (world.body(i).kind == ping_pong::BodyKind::Static && world.body(i).urdf_path.empty())
      return world.bodyPose(i).p.z();
  }
  return std::nan("");
}
}  // namespace

bool Repeat::due(const ping_pong::World& world)
{
  if (pause_ <= 0.0 || world.ballCount() == 0) return false;
  const double floor = floorOf(world);
  for (std::size_t ball = 0; ball < world.ballCount(); ++ball)
  {
    if (isDone(world, ball, floor)) continue;
    ended_at_ = -1.0;
    return false;
  }
  if (ended_at_ < 0.0) ended_at_ = world.time();
  if (world.time() - ended_at_ < pause_) return false;
  ended_at_ = -1.0;
  return true;
}
}  // namespace ping_pong_sim
