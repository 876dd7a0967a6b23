// Conservative advancement to a first contact, see first_contact.h: how far the gap stays open, step there, sample again.
#pragma once

#include <algorithm>
#include <cmath>

#include "detect/first_contact.h"

namespace ping_pong
{
// Closing in slower than this is rounding.
inline constexpr double kNoClosingSpeed = 1e-12;  // [m/s]
// A touching ball that neither closes in nor presses: advance by at least this time, then by twice that.
inline constexpr double kFirstAdvance = 1e-9;  // [s]
inline constexpr double kLastAdvance = 1e-6;   // [s]
inline constexpr int kMaxSamples = 2000;       // undecided then: the loop of events goes on from there
// First d >= 0 with f + f' d + c d^2 / 2 = 0, for f >= 0, without cancellation; kNever if there is none.
inline double safeStep(double gap, double rate, double c)
{
  if (c >= 0.0 && rate >= 0.0) return kNever;
  const double discriminant = rate * rate - 2.0 * c * gap;
  if (discriminant < 0.0) return kNever;
  const double root = std::sqrt(discriminant);
  return rate < 0.0 ? 2.0 * gap / (root - rate) : (rate + root) / -c;
}

// A sample of the gap, for advanceConservatively(): gap, rate, and a lower bound of the gap's second derivative from now on.
struct GapSample
{
  double gap, rate, least_change;
};

// `at(t)` gives a GapSample, `tolerance` the gap of touching, `presses(t)` whether a touching ball is accelerated inwards.
template <typename At, typename Presses>
Detection advanceConservatively(const At& at, const Presses& presses, double from, double until, double tolerance)
{
  double t = from;
  double minimum_advance = kFirstAdvance;
  for (int sample = 0; sample < kMaxSamples; ++sample)
  {
    GapSample now = at(t);
    const bool touching = now.gap <= tolerance;
    if (touching)
    {
      if (now.rate < -kNoClosingSpeed) return {t, false};
      if (now.rate <= kNoSeparationSpeed && presses(t)) return {t, false};
      now.rate = std::max(now.rate, 0.0);
    }
    double step = safeStep(std::max(now.gap, 0.0), now.rate, now.least_change);
    if (touching)
    {
      step = std::max(step, minimum_advance);
      minimum_advance = std::min(2.0 * minimum_advance, kLastAdvance);
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
