#include "evolve/segment.h"

#include <algorithm>
#include <cmath>

#include "base/law_counter.h"
#include "evolve/flight.h"
#include "evolve/integrators.h"
#include "evolve/polynomial.h"

namespace ping_pong
{
namespace
{
Polynomial polynomialOf(const Segment& path)
{
  return {path.degree, path.c.data(), path.higher ? path.higher->c.data() : nullptr};
}
}  // namespace

Vector3d Segment::positionOnPolynomial(double s) const
{
  return polynomialOf(*this).at(s);
}
Vector3d Segment::velocityOnPolynomial(double s) const
{
  return polynomialOf(*this).derivativeAt(s);
}
Vector3d Segment::acceleration(double s) const
{
  return polynomialOf(*this).secondDerivativeAt(s);
}

Vector3d Segment::spin(double s) const
{
  const double decay = spinDecay();
  if (decay > 0.0) count(Law::SpinDecay);
  const Vector3d w = decay > 0.0 ? Vector3d(std::exp(-decay * s) * w_WB) : w_WB;
  if (!higher || !higher->spin) return w + s * alpha_WB();
  Vector3d sum = Vector3d::Zero();
  for (std::size_t k = higher->spin->c.size(); k-- > 0;) sum = sum * s + higher->spin->c[k];
  return w + s * (higher->alpha_WB + s * sum);
}

namespace
{
constexpr double kTurnAtATime = 0.2;  // [rad]
constexpr double kMostTurns = 64.0;

// Orientation where the axis of the spin moves: fourth-order Magnus series at two Gauss points (Iserles and Norsett 1999), in
// steps of a small turn.
Quaterniond turnedAboutMovingAxis(const Segment& path, double s)
{
  const double turn = std::max(path.spin(0.0).norm(), path.spin(s).norm()) * s;
  const double steps = std::min(kMostTurns, std::ceil(turn / kTurnAtATime) + 1.0);
  const double h = s / steps, offset = h * std::sqrt(3.0) / 6.0;
  Quaterniond q = path.q_WB;
  for (double step = 0.0; step < steps; step += 1.0)
  {
    const double middle = (step + 0.5) * h;
    const Vector3d w1 = path.spin(middle - offset), w2 = path.spin(middle + offset);
    q = turned(q, 0.5 * h * (w1 + w2) + 0.5 * offset * h * w2.cross(w1), 1.0);
  }
  return q;
}
}  // namespace

Quaterniond Segment::orientation(double s) const
{
  const Vector3d alpha = alpha_WB();
  if ((higher && higher->spin) || !alpha.cross(w_WB).isZero(0.0)) return turnedAboutMovingAxis(*this, s);
  return turned(q_WB, pending_rotation() + turnIn(w_WB, spinDecay(), s) + (0.5 * s * s) * alpha, 1.0);
}

BallState Segment::state(double s) const
{
  const bool turns = higher && (higher->spin || !higher->alpha_WB.isZero(0.0) || !higher->pending_rotation.isZero(0.0));
  if (w_WB.isZero(0.0) && !turns) return {position(s), q_WB, velocity(s), w_WB};
  return {position(s), orientation(s), velocity(s), spin(s)};
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
      for (int k = 0; k <= n; ++k)
        binomial[n][k] = k == 0 || k == n ? 1.0 : binomial[n - 1][k - 1] + binomial[n - 1][k];
    for (int n = 0; n <= kMost; ++n)
      for (int i = 0; i <= n; ++i)
        for (int k = 0; k <= i; ++k) factor[n][i][k] = binomial[i][k] / binomial[n][k];
  }
};
}  // namespace

void Segment::boundAcceleration()
{
  static const ToBernstein to_bernstein;
  if (degree <= 2) return;
  const int n = degree - 2;
  const double h = end - start;
  std::array<Vector3d, kMaxDegree - 1> powers;
  double power = 1.0;
  for (int k = 0; k <= n; ++k, power *= h) powers[k] = (k + 2) * (k + 1) * power * coefficient(k + 2);
  Vector3d &low = higher->a_low, &high = higher->a_high;
  low = high = 2.0 * c[2];
  for (int i = 1; i <= n; ++i)
  {
    Vector3d b = powers[0];
    for (int k = 1; k <= i; ++k) b += to_bernstein.factor[n][i][k] * powers[k];
    low = low.cwiseMin(b);
    high = high.cwiseMax(b);
  }
}
}  // namespace ping_pong
