#include "game/net_touch.h"

#include "ping_pong_sim/world.h"

namespace ping_pong::game
{
namespace
{
constexpr double kTouching = 2e-4;  // the physics keeps paddles 1e-4 from what stops them [m]
constexpr int kProjections = 200;   // most pairs are told apart by three

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

/// The furthest point of a shape along n_W, as a distance from the world's origin [m].
double furthest(const Shape& shape, const Pose& X_WB, const Vector3d& n_W)
{
  return supportDistance(shape, X_WB.q.conjugate() * n_W) + n_W.dot(X_WB.p);
}

/// A point of a bounded shape that is furthest along n_W.
Vector3d furthestPoint(const Shape& shape, const Pose& X_WB, const Vector3d& n_W)
{
  const Vector3d n = shape.R_BS.transpose() * (X_WB.q.conjugate() * n_W);
  const Vector3d& half = shape.half_size;
  Vector3d p(std::copysign(half.x(), n.x()), std::copysign(half.y(), n.y()), std::copysign(half.z(), n.z()));
  if (shape.kind == ShapeKind::Sphere) p = half.x() * n.normalized();
  if (shape.kind == ShapeKind::Cylinder)
  {
    const double across = std::hypot(n.x(), n.y());
    p.head<2>() = across > 0.0 ? Eigen::Vector2d(half.x() / across * n.head<2>()) : Eigen::Vector2d::Zero();
  }
  return X_WB.p + X_WB.q * (shape.p_BS + shape.R_BS * p);
}

bool farFromNet(const Court& court, End end, const Pose& X_WR)
{
  return std::abs(court.positionInT(X_WR.p).x()) > court.racket_reach[index(end)] + court.net_reach + kTouching;
}
}  // namespace

// Alternating projections (Cheney and Goldstein 1959) tend to the nearest pair of points of two convex sets. Their distance is never
// below the gap; the gap along the line between them is never above it. Between faces that are almost parallel they creep, and the
// corners that are furthest along that line are tried instead.
bool nearerThan(double limit, const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB)
{
  Vector3d on_b = centre(b, X_WB);
  for (int i = 0; i < kProjections; ++i)
  {
    const Vector3d on_a = nearestPoint(a, X_WA, on_b);
    on_b = nearestPoint(b, X_WB, on_a);
    const double distance = (on_a - on_b).norm();
    if (distance < limit) return true;
    const Vector3d n_W = (on_a - on_b) / distance;
    if (-furthest(a, X_WA, -n_W) - furthest(b, X_WB, n_W) > limit) return false;
    // The best start of the next round: where this one has come to, or from the corner of either that looks at the other.
    const Vector3d from_b = furthestPoint(b, X_WB, n_W);
    const Vector3d from_a = nearestPoint(b, X_WB, furthestPoint(a, X_WA, -n_W));
    double best = distance;
    for (const Vector3d& start : {from_b, from_a})
    {
      const double reached = (nearestPoint(a, X_WA, start) - start).norm();
      if (reached >= best) continue;
      best = reached;
      on_b = start;
    }
  }
  return false;
}

bool racketTouchesNet(const World& world, const Court& court, End end)
{
  const std::size_t racket = court.racket[index(end)];
  const Pose X_WR = world.bodyPose(racket);
  if (farFromNet(court, end, X_WR)) return false;
  for (std::size_t b = 0; b < court.roles.size(); ++b)
    for (std::size_t s = 0; s < court.roles[b].size(); ++s)
    {
      if (court.roles[b][s].part != Part::Net) continue;
      for (const Shape& part : world.body(racket).shapes)
        if (nearerThan(kTouching, world.body(b).shapes[s], world.bodyPose(b), part, X_WR)) return true;
    }
  return false;
}
}  // namespace ping_pong::game
