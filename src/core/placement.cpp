#include "placement.h"

#include <cstdio>

namespace ping_pong
{
namespace
{
constexpr double kTouching = 1e-9;  // overlap that is no overlap [m]
constexpr int kMaxPushes = 50;

std::string described(const std::string& what, double depth)
{
  char text[64];
  std::snprintf(text, sizeof text, " (%.3g mm deep)", 1e3 * depth);
  return what + text;
}
}  // namespace

Overlap deepestOverlap(const WorldState& world, const Vector3d& p_WB, double radius, double t)
{
  Overlap deepest;
  for (std::size_t b = 0; b < world.bodies.size(); ++b)
  {
    const BodyRecord& body = world.bodies[b];
    const BodyFrame frame = frameAt(body.frame(), t - body.frame().start);
    for (std::size_t s = 0; s < body.shapes().size(); ++s)
    {
      const Gap gap = gapTo(body.shapes()[s], frame, p_WB, Vector3d::Zero(), radius);
      if (gap.gap < deepest.gap)
        deepest = {gap.gap, gap.n_W, frame.pointVelocity(p_WB - radius * gap.n_W), b, s};
    }
  }
  return deepest;
}

bool pushOut(const WorldState& world, Vector3d& p_WB, double radius, double t)
{
  for (int i = 0; i < kMaxPushes; ++i)
  {
    const Overlap deepest = deepestOverlap(world, p_WB, radius, t);
    if (deepest.gap >= -kTouching) return true;
    p_WB -= deepest.gap * deepest.n_W;
  }
  return false;
}

std::string describeOverlap(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except)
{
  const Overlap deepest = deepestOverlap(world, p_WB, radius, world.time);
  if (deepest.gap < -kTouching) return described(world.bodies[deepest.body].body.name, -deepest.gap);
  for (std::size_t i = 0; i < world.balls.size(); ++i)
  {
    if (i == except) continue;
    const BallRecord& other = world.balls[i];
    const double gap = (other.stateAt(world.time).p_WB - p_WB).norm() - radius - other.params.radius;
    if (gap < -kTouching) return described("ball_" + std::to_string(other.id), -gap);
  }
  return {};
}
}  // namespace ping_pong
