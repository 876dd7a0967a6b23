// One smooth piece of a ball's path: a state for every instant of it.
#pragma once

#include <array>
#include <limits>

#include "ping_pong_sim/ball.h"

namespace ping_pong
{
/// p(s) = c0 + c1 s + ... + c_degree s^degree with s = t - start; spin w(s) = w exp(-decay s) + alpha s.
/// Flight in vacuum has degree 2, flight through air 5 or 9; a path held to a curved or turning surface is a quintic piece.
struct Segment
{
  static constexpr int kMaxDegree = 9;

  double start = 0.0;                                          ///< world time of s = 0 [s]
  double end = std::numeric_limits<double>::infinity();        ///< world time up to which it holds [s]
  int degree = 0;
  std::array<Vector3d, kMaxDegree + 1> c = zeros();            ///< [m/s^k], in W
  Quaterniond q_WB = Quaterniond::Identity();                  ///< orientation at s = 0
  Vector3d turn_WB = Vector3d::Zero();                         ///< turning before s = 0 that is not in q_WB yet [rad]
  Vector3d w_WB = Vector3d::Zero();                            ///< spin at s = 0 [rad/s]
  Vector3d alpha_WB = Vector3d::Zero();                        ///< on a surface [rad/s^2]
  double spin_decay = 0.0;                                     ///< in the air [1/s]
  Vector3d a_low = Vector3d::Zero();                           ///< bounds of each component of the acceleration on the
  Vector3d a_high = Vector3d::Zero();                          ///< whole piece, see boundAcceleration() [m/s^2]

  Vector3d position(double s) const
  {
    return degree == 2 ? Vector3d(c[0] + s * (c[1] + s * c[2])) : positionOnPolynomial(s);
  }
  Vector3d velocity(double s) const
  {
    return degree == 2 ? Vector3d(c[1] + (2.0 * s) * c[2]) : velocityOnPolynomial(s);
  }
  Vector3d acceleration(double s) const;
  Vector3d spin(double s) const;
  BallState state(double s) const;

  /// Sets the bounds once the coefficients and the end are there: the least and greatest Bernstein coefficients on [0, end - start].
  void boundAcceleration();
  /// Upper bound of |acceleration| on the whole piece, and of |velocity| for s in [from, to].
  double accelerationBound() const { return a_low.cwiseAbs().cwiseMax(a_high.cwiseAbs()).norm(); }
  double speedBound(double from, double to) const { return velocity(from).norm() + (to - from) * accelerationBound(); }

private:
  Vector3d positionOnPolynomial(double s) const;
  Vector3d velocityOnPolynomial(double s) const;
  static std::array<Vector3d, kMaxDegree + 1> zeros();
};
}  // namespace ping_pong
