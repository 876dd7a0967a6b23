#include "ping_pong_sim/segment.h"

#include <algorithm>
#include <cmath>

#include "count.h"
#include "ping_pong_sim/evolve.h"
#include "fixed_flight.h"
#include "polynomial.h"

namespace ping_pong
{
namespace
{
Polynomial polynomialOf(const Segment& path)
{
  return {path.degree, path.c.data(), path.further ? path.further->c.data() : nullptr};
}
}  // namespace

Vector3d Segment::positionOnPolynomial(double s) const { return polynomialOf(*this).at(s); }
Vector3d Segment::velocityOnPolynomial(double s) const { return polynomialOf(*this).derivativeAt(s); }
Vector3d Segment::acceleration(double s) const { return polynomialOf(*this).secondDerivativeAt(s); }

Vector3d Segment::spin(double s) const
{
  const double decay = spinDecay();
  if (decay > 0.0) count(Law::SpinDecay);
  const Vector3d w = decay > 0.0 ? Vector3d(std::exp(-decay * s) * w_WB) : w_WB;
  return w + s * alpha_WB();
}

BallState Segment::state(double s) const
{
  const Vector3d turned_before = turn_WB(), alpha = alpha_WB();
  if (w_WB.isZero(0.0) && alpha.isZero(0.0) && turned_before.isZero(0.0)) return {position(s), q_WB, velocity(s), w_WB};
  // Exact where the axis keeps its direction; a ball that starts to roll while it spins about the normal turns nearly so.
  const Vector3d turn = turned_before + turnIn(w_WB, spinDecay(), s) + (0.5 * s * s) * alpha;
  return {position(s), turned(q_WB, turn, 1.0), velocity(s), spin(s)};
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
  if (degree <= 2) return;
  const int n = degree - 2;
  const double h = end - start;
  std::array<Vector3d, kMaxDegree - 1> powers;
  double power = 1.0;
  for (int k = 0; k <= n; ++k, power *= h) powers[k] = (k + 2) * (k + 1) * power * coefficient(k + 2);
  Vector3d &low = further->a_low, &high = further->a_high;
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
