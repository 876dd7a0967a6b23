// When two balls in free flight under the same acceleration meet: a quadratic, solved without cancellation.
#pragma once

#include <cmath>

#include "detect/conservative_advancement.h"
#include "evolve/parabola.h"

namespace ping_pong
{
/// More than the discriminant below is wrong by, as a part of |u|^2 |d|^2.
constexpr double kRoundingOfSquares = 1e-13;

/// Two balls at one time.
struct Approach
{
  Vector3d p;               ///< of the first one [m]
  double closing;           ///< half the derivative of |d|^2, where d is from the second to the first [m^2/s]
  double distance_squared;  ///< |d|^2
  double speed_squared;     ///< of one against the other
};

/// First contact in [from, until] of balls under the same acceleration that come closer at `from`.
Detection contactAhead(const Approach& at, double reach, double from, double until);

/// First contact in [from, until] of balls whose radii add up to `reach`; both have the same half_a.
[[gnu::always_inline]] inline Detection firstContact(const ParabolaView& a, const ParabolaView& b, double reach,
                                                     double from, double until)
{
  const double s1 = from - a.start;
  const double s2 = from - b.start;
  const Vector3d p1 = a.p + s1 * (a.v + s1 * a.half_a);
  const Vector3d p2 = b.p + s2 * (b.v + s2 * b.half_a);
  const Vector3d d = p1 - p2;
  const Vector3d u = a.v - b.v + (2.0 * (s1 - s2)) * a.half_a;
  const double closing = d.dot(u);
  if (closing >= -kNoClosingSpeed * reach) return {};
  const double dd = d.squaredNorm(), uu = u.squaredNorm();
  if (closing * closing < uu * (dd * (1.0 - kRoundingOfSquares) - reach * reach)) return {};  // most pass by
  return contactAhead({p1, closing, dd, uu}, reach, from, until);
}
}  // namespace ping_pong
