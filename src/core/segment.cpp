#include "ping_pong_sim/segment.h"

#include <algorithm>
#include <cmath>

#include "ping_pong_sim/evolve.h"
#include "ping_pong_sim/fixed_flight.h"

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

Vector3d Segment::spin(double s) const
{
  const Vector3d w = spin_decay > 0.0 ? Vector3d(std::exp(-spin_decay * s) * w_WB) : w_WB;
  return w + s * alpha_WB;
}

BallState Segment::state(double s) const
{
  // Exact where the axis keeps its direction; a ball that starts to roll while it spins about the normal turns nearly so.
  const Vector3d turn = turn_WB + turnIn(w_WB, spin_decay, s) + (0.5 * s * s) * alpha_WB;
  return {position(s), turned(q_WB, turn, 1.0), velocity(s), spin(s)};
}

std::array<Vector3d, Segment::kMaxDegree + 1> Segment::zeros()
{
  std::array<Vector3d, kMaxDegree + 1> c;
  c.fill(Vector3d::Zero());
  return c;
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
