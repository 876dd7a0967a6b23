// An independent reference for hits: distance of a point from a box or a cylinder, poses by Eigen's AngleAxis, and a
// march that cannot jump over a contact, since the distance changes no faster than the speed bound. It shares no code
// with the core.
#pragma once

#include <algorithm>
#include <cmath>

#include "evolve/segment.h"
#include "ping_pong_sim/motion.h"
#include "ping_pong_sim/shape.h"

namespace ping_pong
{
/// Distance of q from the surface, both in the shape's own axes; inside: minus the way to the nearest face.
inline double distanceToBox(const Vector3d& q, const Vector3d& half)
{
  const Vector3d over(std::abs(q.x()) - half.x(), std::abs(q.y()) - half.y(), std::abs(q.z()) - half.z());
  const double inside = std::max({over.x(), over.y(), over.z()});
  if (inside <= 0.0) return inside;
  return std::sqrt(std::pow(std::max(over.x(), 0.0), 2) + std::pow(std::max(over.y(), 0.0), 2) +
                   std::pow(std::max(over.z(), 0.0), 2));
}

inline double distanceToCylinder(const Vector3d& q, double radius, double half_length)
{
  const double outwards = std::sqrt(q.x() * q.x() + q.y() * q.y()) - radius;
  const double along = std::abs(q.z()) - half_length;
  if (outwards <= 0.0 || along <= 0.0) return std::max(outwards, along);
  return std::sqrt(outwards * outwards + along * along);
}

/// A ball on a parabola and one moving body with one centred shape, from s = 0 to `duration`.
struct Encounter
{
  Vector3d p, v, a;  // of the ball
  double radius = 0.02;
  Shape shape;
  BodyMotion motion;
  double duration = 0.0;

  Vector3d ball(double s) const { return p + s * v + 0.5 * s * s * a; }

  /// R(s) = exp(w s + alpha s^2/2) R0 by AngleAxis.
  Eigen::Matrix3d rotation(double s) const
  {
    const Vector3d turn = s * motion.twist.w + 0.5 * s * s * motion.alpha_WB;
    const double angle = turn.norm();
    const Eigen::Matrix3d start = motion.pose.q.toRotationMatrix();
    return angle > 0.0 ? Eigen::Matrix3d(Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * start) : start;
  }

  double gap(double s) const
  {
    const Vector3d body = motion.pose.p + s * motion.twist.v + 0.5 * s * s * motion.a_WB;
    const Vector3d q = rotation(s).transpose() * (ball(s) - body);
    const double distance = shape.kind == ShapeKind::Box
                                ? distanceToBox(q, shape.half_size)
                                : distanceToCylinder(q, shape.half_size.x(), shape.half_size.z());
    return distance - radius;
  }

  /// No point of the body within its radius moves faster relative to the ball.
  double speedBound() const
  {
    const double ball_speed = v.norm() + duration * a.norm();
    const double body_speed = motion.twist.v.norm() + duration * motion.a_WB.norm();
    const double turning = motion.twist.w.norm() + duration * motion.alpha_WB.norm();
    return ball_speed + body_speed + turning * shape.half_size.norm() + 1e-9;
  }
};

/// First s at which the gap is below `contact`; infinity if there is none. A step is at most gap / speed bound, which
/// is safe; and at least a nanosecond: at 250 m/s a graze of that length is less than 1e-12 m deep.
inline double firstTouch(const Encounter& e, double contact)
{
  const double bound = e.speedBound();
  for (double s = 0.0; s < e.duration;)
  {
    const double gap = e.gap(s);
    if (gap <= contact) return s;
    s += std::max(gap / bound, 1e-9);
  }
  return e.gap(e.duration) <= contact ? e.duration : std::numeric_limits<double>::infinity();
}
}  // namespace ping_pong
