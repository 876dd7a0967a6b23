#include "ping_pong_sim/segment.h"

#include <algorithm>
#include <cmath>

#include "ping_pong_sim/evolve.h"

namespace ping_pong
{
Vector3d Segment::position(double s) const
{
  Vector3d sum = c[degree];
  for (int k = degree - 1; k >= 0; --k) sum = sum * s + c[k];
  return sum;
}

Vector3d Segment::velocity(double s) const
{
  if (degree < 1) return Vector3d::Zero();
  Vector3d sum = degree * c[degree];
  for (int k = degree - 1; k >= 1; --k) sum = sum * s + k * c[k];
  return sum;
}

Vector3d Segment::acceleration(double s) const
{
  if (degree < 2) return Vector3d::Zero();
  Vector3d sum = degree * (degree - 1) * c[degree];
  for (int k = degree - 1; k >= 2; --k) sum = sum * s + k * (k - 1) * c[k];
  return sum;
}

BallState Segment::state(double s) const
{
  return {position(s), turned(q_WB, w_WB, s), velocity(s), w_WB};
}

double Segment::speedBound(double from, double to) const
{
  return velocity(from).norm() + (to - from) * accelerationBound(from, to);
}

double Segment::accelerationBound(double from, double to) const
{
  const double s = std::max(std::abs(from), std::abs(to));
  double bound = 0.0;
  for (int k = degree; k >= 2; --k) bound = bound * s + k * (k - 1) * c[k].norm();
  return bound;
}
}  // namespace ping_pong
