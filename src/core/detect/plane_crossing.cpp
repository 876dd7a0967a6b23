#include "detect/plane_crossing.h"

#include <algorithm>

namespace ping_pong
{
namespace
{
constexpr double kClose = 2e-6;  // a step of third order as short as this one leaves nothing behind [s]
constexpr int kMaxSteps = 8;     // a bound: each triples the digits; else the general search takes over

// The height bends downwards, and at `from` the ball is above or rises: there is one contact at most. Steps to the zero of the
// parabola that fits the height here (Halley's irrational method). Undecided: they do not lead there.
Detection crossesPlaneOnce(const Height& height, Height::Values now, double start, double from, double until)
{
  const Detection undecided{from, true};
  double t = from + safeStep(std::max(now.f, 0.0), now.rate, now.bend);
  if (!(t < until))
  {
    if (!(until < kNever)) return undecided;
    if (height.at(until - start).f > 0.0) return {};
    t = until;
  }
  for (int i = 0; i < kMaxSteps; ++i)
  {
    now = height.at(t - start);
    const double discriminant = now.rate * now.rate - 2.0 * now.f * now.bend;
    if (!(now.rate < 0.0) || !(discriminant > 0.0)) return undecided;
    const double step = 2.0 * now.f / (std::sqrt(discriminant) - now.rate);
    t += step;
    if (std::abs(step) > kClose) continue;
    return t > until ? Detection() : Detection{std::max(t, from), false};
  }
  return undecided;
}
}  // namespace

Detection crossesPlane(const Height& height, double start, double from, double until, double tolerance)
{
  const Height::Values now = height.at(from - start);
  if (height.most_bend < 0.0 && (now.f > tolerance || now.rate > kNoSeparationSpeed))
  {
    const Detection found = crossesPlaneOnce(height, now, start, from, until);
    if (!found.undecided) return found;
  }
  const auto at = [&](double t)
  {
    const Height::Values here = height.at(t - start);
    return GapSample{here.f, here.rate, height.least_bend};
  };
  const auto presses = [&](double t) { return height.at(t - start).bend < 0.0; };
  return advanceConservatively(at, presses, from, until, tolerance);
}
}  // namespace ping_pong
