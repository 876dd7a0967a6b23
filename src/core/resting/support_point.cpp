#include "resting/support_point.h"

#include "base/law_counter.h"

namespace ping_pong
{
namespace
{
// On a body at rest all terms of its motion are zero.
SupportPoint onStill(const Proximity& near, const BallMotion& ball, double radius)
{
  SupportPoint at;
  const Vector3d& n = near.normal;
  at.n = n;
  at.gap = near.distance - radius;
  at.rate = n.dot(ball.v);
  at.slip = tangential(ball.v, n) - ball.s.cross(n);
  at.spin = n.dot(ball.s);
  at.roll = ball.s - at.spin * n;
  at.least = at.spin_bias = 0.0;
  at.slip_bias = at.roll_bias = Vector3d::Zero();
  if (near.flat()) return at;
  const Vector3d t2 = n.cross(near.t1);
  const double u1 = ball.v.dot(near.t1), u2 = ball.v.dot(t2);
  const Vector3d dn = near.k1 * u1 * near.t1 + near.k2 * u2 * t2;
  at.least = -near.k1 * u1 * u1 - near.k2 * u2 * u2;
  at.slip_bias = -tangential(ball.s.cross(dn), n);
  at.roll_bias = -at.spin * dn;
  at.spin_bias = dn.dot(ball.s);
  return at;
}

SupportPoint onMoving(const BodyFrame& frame, const Proximity& near, const BallMotion& ball, double radius)
{
  SupportPoint at;
  const Vector3d n = frame.R_WB * near.normal, t1 = frame.R_WB * near.t1, t2 = n.cross(t1);
  const Vector3d& w = frame.w_WB;
  const Vector3d d = ball.p - frame.p_WB;
  const Vector3d u = ball.v - frame.v_WB - w.cross(d);  // seen from the body
  const double u1 = u.dot(t1), u2 = u.dot(t2);
  const Vector3d dn = near.k1 * u1 * t1 + near.k2 * u2 * t2 + w.cross(n);
  at.n = n;
  at.gap = near.distance - radius;
  at.rate = n.dot(u);
  const Vector3d carried = frame.a_WB + frame.alpha_WB.cross(d) + w.cross(w.cross(d)) + 2.0 * w.cross(u);
  at.least = n.dot(carried) - near.k1 * u1 * u1 - near.k2 * u2 * u2;
  const Vector3d arm = d - radius * n;
  at.slip = tangential(ball.v - frame.v_WB - w.cross(arm), n) - ball.s.cross(n);
  const Vector3d touched = frame.a_WB + frame.alpha_WB.cross(arm) + w.cross(ball.v - frame.v_WB - radius * dn);
  at.slip_bias = -tangential(touched + ball.s.cross(dn), n);
  const Vector3d spin = ball.s - radius * w;
  at.spin = n.dot(spin);
  at.roll = spin - at.spin * n;
  at.roll_bias = -tangential(radius * frame.alpha_WB, n) - at.spin * dn;
  at.spin_bias = dn.dot(spin) - radius * n.dot(frame.alpha_WB);
  return at;
}
}  // namespace

SupportPoint supportPoint(const SupportSurface& surface, const BallMotion& ball, double radius, double t)
{
  if (surface.law->friction > 0.0) count(Law::Slip);
  if (surface.still) return onStill(proximity(*surface.shape, surface.feature, ball.p), ball, radius);
  const BodyFrame frame = frameAt(*surface.motion, t - surface.motion->start);
  const Vector3d p_BQ = frame.R_WB.transpose() * (ball.p - frame.p_WB);
  return onMoving(frame, proximity(*surface.shape, surface.feature, p_BQ), ball, radius);
}
}  // namespace ping_pong
