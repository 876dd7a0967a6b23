// Vectors that are polynomials of time, and their derivatives, by Horner's rule. Coefficients from s^3 on may be elsewhere.
#pragma once

#include "ping_pong_sim/types.h"

namespace ping_pong
{
struct Polynomial
{
  int degree;
  const Vector3d* c;     ///< of 1, s and s^2
  const Vector3d* high;  ///< of s^3 and so on, where the degree is that high

  Vector3d at(double s) const
  {
    if (degree < 3)
    {
      Vector3d sum = c[degree];
      for (int k = degree - 1; k >= 0; --k) sum = sum * s + c[k];
      return sum;
    }
    Vector3d sum = high[degree - 3];
    for (int k = degree - 1; k >= 3; --k) sum = sum * s + high[k - 3];
    return ((sum * s + c[2]) * s + c[1]) * s + c[0];
  }

  Vector3d derivativeAt(double s) const
  {
    if (degree < 1) return Vector3d::Zero();
    if (degree < 2) return c[1];
    if (degree < 3) return 2 * c[2] * s + c[1];
    Vector3d sum = degree * high[degree - 3];
    for (int k = degree - 1; k >= 3; --k) sum = sum * s + k * high[k - 3];
    return (sum * s + 2 * c[2]) * s + c[1];
  }

  Vector3d secondDerivativeAt(double s) const
  {
    if (degree < 2) return Vector3d::Zero();
    if (degree < 3) return 2 * c[2];
    Vector3d sum = degree * (degree - 1) * high[degree - 3];
    for (int k = degree - 1; k >= 3; --k) sum = sum * s + k * (k - 1) * high[k - 3];
    return sum * s + 2 * c[2];
  }
};
}  // namespace ping_pong
