// The walk to the first contact that first_contact.h explains: how far the gap surely stays open, step there, look again.
#pragma once

#include <algorithm>
#include <cmath>

#include "detect/first_contact.h"

namespace ping_pong
{
// Closing in slower than this is rounding.
inline constexpr double kNoClosingSpeed = 1e-12;  // [m/s]
// A touching ball that neither closes in nor presses: look again after this time, then after twice that.
inline constexpr double kFirstNudge = 1e-9;  // [s]
inline constexpr double kLastNudge = 1e-6;   // [s]
inline constexpr int kMaxLooks = 2000;
// First d >= 0 with f + f' d + c d^2 / 2 = 0, for f >= 0, without cancellation; kNever if there is none.
inline double safeStep(double gap, double rate, double c)
{
  if (c >= 0.0 && rate >= 0.0) return kNever;
  const double discriminant = rate * rate - 2.0 * c * gap;
  if (discriminant < 0.0) return kNever;
  const double root = std::sqrt(discriminant);
  return rate < 0.0 ? 2.0 * gap / (root - rate) : (rate + root) / -c;
}

// What `march` looks at: gap, rate, and a lower bound of the gap's second derivative from now on.
struct Look
{
  double gap, rate, least_change;
};

// `at(t)` gives a Look, `tolerance` the gap of touching, `presses(t)` whether a touching ball is accelerated inwards.
template <typename At, typename Presses>
Detection march(const At& at, const Presses& presses, double from, double until, double tolerance)
{
  double t = from;
  double nudge = kFirstNudge;
  for (int look = 0; look < kMaxLooks; ++look)
  {
    Look now = at(t);
    const bool touching = now.gap <= tolerance;
    if (touching)
    {
      if (now.rate < -kNoClosingSpeed) return {t, false};
      if (now.rate <= kNoHopSpeed && presses(t)) return {t, false};
      now.rate = std::max(now.rate, 0.0);
    }
    double step = safeStep(std::max(now.gap, 0.0), now.rate, now.least_change);
    if (touching)
    {
      step = std::max(step, nudge);
      nudge = std::min(2.0 * nudge, kLastNudge);
    }
    if (!(t + step <= until)) return {};
    if (t + step == t) return {t, false};  // closing in by less than time can resolve
    t += step;
  }
  return {t, true};
}

/// The least n.a of all a between the bounds.
inline double leastAlong(const Vector3d& n, const Vector3d& a_low, const Vector3d& a_high)
{
  return n.cwiseProduct(a_low).cwiseMin(n.cwiseProduct(a_high)).sum();
}
}  // namespace ping_pong
