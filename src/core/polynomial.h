// Vectors that are polynomials of time, and their derivatives, by Horner's rule.
#pragma once

#include "ping_pong_sim/types.h"

namespace ping_pong
{
/// c(0) + c(1) s + ... + c(degree) s^degree.
template <class Coefficient>
Vector3d valueAt(double s, int degree, const Coefficient& c)
{
  Vector3d sum = c(degree);
  for (int k = degree - 1; k >= 0; --k) sum = sum * s + c(k);
  return sum;
}

template <class Coefficient>
Vector3d derivativeAt(double s, int degree, const Coefficient& c)
{
  if (degree < 1) return Vector3d::Zero();
  Vector3d sum = degree * c(degree);
  for (int k = degree - 1; k >= 1; --k) sum = sum * s + k * c(k);
  return sum;
}

template <class Coefficient>
Vector3d secondDerivativeAt(double s, int degree, const Coefficient& c)
{
  if (degree < 2) return Vector3d::Zero();
  Vector3d sum = degree * (degree - 1) * c(degree);
  for (int k = degree - 1; k >= 2; --k) sum = sum * s + k * (k - 1) * c(k);
  return sum;
}
}  // namespace ping_pong
