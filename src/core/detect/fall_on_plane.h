// When a ball that flies a parabola meets a plane: the one search that needs no steps.
#pragma once

#include "detect/conservative_advancement.h"
#include "evolve/segment.h"

namespace ping_pong
{
/// First contact in [from, until] with the half-space below `plane`'s own z = 0; the path has degree 2. What counts as one is
/// the same as in advanceConservatively().
/// @param plane  in the world frame
/// @param n  its normal
inline Detection fallOnPlane(const Segment& path, double radius, const Vector3d& n, const Shape& plane, double from,
                             double until)
{
  const double s = from - path.start;
  const double u = n.dot(path.c[1]);
  const double half_a = n.dot(path.c[2]);
  const double gap = n.dot(path.c[0] - plane.p_BS) - radius + (u + half_a * s) * s;
  const double rate = u + 2.0 * half_a * s;
  const bool touching = gap <= touchTolerance(path.position(s), radius);
  if (touching && (rate < -kNoClosingSpeed || (rate <= kNoSeparationSpeed && half_a < 0.0))) return {from, false};
  double step = safeStep(std::max(gap, 0.0), touching ? std::max(rate, 0.0) : rate, 2.0 * half_a);
  if (touching) step = std::max(step, kFirstAdvance);
  if (!(from + step <= until)) return {};
  return {from + step, false};
}
}  // namespace ping_pong
