// When a height that is a polynomial of time crosses zero downwards. Where it surely bends downwards it does so once, and Newton's
// method needs no care; else advanceConservatively() finds it.
#pragma once

#include <cmath>

#include "detect/conservative_advancement.h"
#include "evolve/segment.h"

namespace ping_pong
{
/// c[0] + c[1] s + ... + c[degree] s^degree, with bounds of its second derivative.
struct Height
{
  double c[Segment::kMaxDegree + 1];
  int degree;
  double least_bend, most_bend;

  struct Values
  {
    double f, rate, bend;  ///< value, first and second derivative
  };
  Values at(double s) const
  {
    double f = c[degree], rate = 0.0, half_bend = 0.0;
    for (int k = degree - 1; k >= 0; --k)
    {
      half_bend = half_bend * s + rate;
      rate = rate * s + f;
      f = f * s + c[k];
    }
    return {f, rate, 2.0 * half_bend};
  }
};

/// First contact of a ball with the plane above which it has this height, times counted from `start`; what counts as one is
/// the same as in advanceConservatively().
/// @param tolerance  height of touching
Detection crossesPlane(const Height& height, double start, double from, double until, double tolerance);
}  // namespace ping_pong
