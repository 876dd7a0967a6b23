#include "game/net_touch.h"

#include "ping_pong_sim/world.h"

namespace ping_pong
{
namespace
{
constexpr double kTouching = 2e-4;   // the physics keeps paddles 1e-4 from what stops them [m]
constexpr int kProjections = 200;    // most end after three
constexpr double kProgress = 1e-10;  // a smaller step is none [m]

Vector3d nearestPoint(const Shape& shape, const Pose& X_WB, const Vector3d& p_W)
{
  const Vector3d p_B = X_WB.toB(p_W);
  const Proximity near = proximity(shape, p_B);
  return near.distance <= 0.0 ? p_W : X_WB.p + X_WB.q * (p_B - near.distance * near.normal);
}

Vector3d centre(const Shape& shape, const Pose& X_WB)
{
  return X_WB.p + X_WB.q * shape.p_BS;
}

// Cheap, and true for all but rackets at the net.
bool farFrom(const Shape& net, const Pose& X_WN, const Shape& racket, const Pose& X_WR)
{
  return proximity(net, X_WN.toB(centre(racket, X_WR))).distance > boundingRadius(racket) + kTouching;
}
}  // namespace

// Alternating projections (Cheney and Goldstein 1959): they tend to the nearest pair of points of two convex sets.
double gapBetween(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB)
{
  Vector3d on_b = centre(b, X_WB);
  double gap = HUGE_VAL;
  for (int i = 0; i < kProjections; ++i)
  {
    const Vector3d on_a = nearestPoint(a, X_WA, on_b);
    on_b = nearestPoint(b, X_WB, on_a);
    const double now = (on_a - on_b).norm();
    if (gap - now < kProgress) return now;
    gap = now;
  }
  return gap;
}

bool racketTouchesNet(const World& world, const Court& court, End end)
{
  const std::size_t racket = court.racket[index(end)];
  const Pose X_WR = world.bodyPose(racket);
  for (std::size_t b = 0; b < court.roles.size(); ++b)
    for (std::size_t s = 0; s < court.roles[b].size(); ++s)
    {
      if (court.roles[b][s].part != Part::Net) continue;
      const Pose X_WN = world.bodyPose(b);
      const Shape& net = world.body(b).shapes[s];
      for (const Shape& part : world.body(racket).shapes)
        if (!farFrom(net, X_WN, part, X_WR) && gapBetween(net, X_WN, part, X_WR) < kTouching) return true;
    }
  return false;
}
}  // namespace ping_pong
