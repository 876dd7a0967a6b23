#include "ping_pong_sim/segment.h"

#include <algorithm>
#include <cmath>

#include "count.h"
#include "ping_pong_sim/evolve.h"
#include "fixed_flight.h"

namespace ping_pong
{
Vector3d Segment::positionOnPolynomial(double s) const
{
  Vector3d sum = c[degree];
  for (int k = degree - 1; k >= 0; --k) sum = sum * s + c[k];
  return sum;
}

Vector3d Segment::velocityOnPolynomial(double s) const
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
  if (spin_decay > 0.0) count(Law::SpinDecay);
  const Vector3d w = spin_decay > 0.0 ? Vector3d(std::exp(-spin_decay * s) * w_WB) : w_WB;
  return w + s * alpha_WB;
}

BallState Segment::state(double s) const
{
  if (w_WB.isZero(0.0) && alpha_WB.isZero(0.0) && turn_WB.isZero(0.0)) return {position(s), q_WB, velocity(s), w_WB};
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

namespace
{
// Powers of tau on [0, 1] to Bernstein polynomials of degree n: B_i = sum over k <= i of binomial(i, k) / binomial(n, k) b_k.
struct ToBernstein
{
  static constexpr int kMost = Segment::kMaxDegree - 2;
  double factor[kMost + 1][kMost + 1][kMost + 1] = {};  // [n][i][k]

  ToBernstein()
  {
    double binomial[kMost + 1][kMost + 1] = {};
    for (int n = 0; n <= kMost; ++n)
      for (int k = 0; k <= n; ++k) binomial[n][k] = k == 0 || k == n ? 1.0 : binomial[n - 1][k - 1] + binomial[n - 1][k];
    for (int n = 0; n <= kMost; ++n)
      for (int i = 0; i <= n; ++i)
        for (int k = 0; k <= i; ++k) factor[n][i][k] = binomial[i][k] / binomial[n][k];
  }
};
}  // namespace

void Segment::boundAcceleration()
{
  static const ToBernstein to_bernstein;
  a_low = a_high = degree < 2 ? Vector3d(Vector3d::Zero()) : Vector3d(2.0 * c[2]);
  if (degree <= 2) return;
  const int n = degree - 2;
  const double h = end - start;
  std::array<Vector3d, kMaxDegree - 1> powers;
  double power = 1.0;
  for (int k = 0; k <= n; ++k, power *= h) powers[k] = (k + 2) * (k + 1) * power * c[k + 2];
  for (int i = 1; i <= n; ++i)
  {
    Vector3d b = powers[0];
    for (int k = 1; k <= i; ++k) b += to_bernstein.factor[n][i][k] * powers[k];
    a_low = a_low.cwiseMin(b);
    a_high = a_high.cwiseMax(b);
  }
}
}  // namespace ping_pong
