#include "blade.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ping_pong::play
{
Blade::Blade(const Scene& scene, const std::string& paddle, const BallParams& ball) : ball_radius_(ball.radius)
{
  const auto found =
      std::find_if(scene.bodies.begin(), scene.bodies.end(),
                   [&](const Body& body) { return body.name == paddle && body.kind == BodyKind::Kinematic; });
  if (found == scene.bodies.end())
    throw std::invalid_argument("paddle: " + paddle + ": expected the name of a kinematic body");
  shapes_ = found->shapes;
  limits_ = found->limits;
  for (const Shape& shape : shapes_)
  {
    const bool blade = shape.kind == ShapeKind::Cylinder && std::abs(shape.R_BS.col(2).x()) > 1.0 - 1e-9;
    if (!blade) continue;
    radius_ = std::max(radius_, shape.half_size.x());
    const Surface& law = scene.surfaces.at(ball.material, shape.material);
    const double front = supportDistance(shape, Vector3d::UnitX()), back = supportDistance(shape, -Vector3d::UnitX());
    if (front > front_) front_ = front, forehand_ = law;
    if (back > back_) back_ = back, backhand_ = law;
  }
  if (radius_ == 0.0) throw std::invalid_argument("paddle: " + paddle + ": expected a blade: cylinders along its x");
}

Quaterniond Blade::attitude(const Vector3d& n, Face face) const
{
  const double side = face == Face::Forehand ? 1.0 : -1.0;
  Vector3d tip = side * n.cross(Vector3d::UnitZ());
  if (tip.squaredNorm() < 1e-6) tip = -side * Vector3d::UnitY();
  tip.normalize();
  Matrix3d R;
  R.col(0) = side * n;
  R.col(2) = tip;
  R.col(1) = R.col(2).cross(R.col(0));
  return Quaterniond(R).normalized();
}

double Blade::extent(const Pose& pose, const Vector3d& n) const
{
  const Vector3d n_P = pose.q.conjugate() * n;
  double most = -1e9;
  for (const Shape& shape : shapes_) most = std::max(most, supportDistance(shape, n_P));
  return n.dot(pose.p) + most;
}

bool Blade::clearOfTable(const Pose& pose, const Court& court, double margin) const
{
  const double front = extent(pose, Vector3d::UnitX());
  if (front < -court.halfLength() - margin) return true;
  const bool before_net = front < -margin;
  if (before_net && -extent(pose, -Vector3d::UnitZ()) > margin) return true;
  const double beside = court.halfWidth() + margin;
  return before_net && (-extent(pose, -Vector3d::UnitY()) > beside || extent(pose, Vector3d::UnitY()) < -beside);
}

bool Blade::stopsBeforeTable(const Pose& pose, const Vector3d& v, double acceleration, const Court& court,
                             double margin) const
{
  const Vector3d way = (0.5 * v.norm() / acceleration) * v;
  return clearOfTable({pose.p + 0.5 * way, pose.q}, court, margin) &&
         clearOfTable({pose.p + way, pose.q}, court, margin);
}

bool Blade::clearOfBall(const Pose& pose, const Vector3d& ball, double margin) const
{
  const Vector3d p = pose.toB(ball);
  const double near = margin + ball_radius_;
  for (const Shape& shape : shapes_)
    if (proximity(shape, p).distance < near) return false;
  return true;
}
}  // namespace ping_pong::play
