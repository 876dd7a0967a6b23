// One smooth piece of a ball's path: a state for every instant of it.
#pragma once

#include <limits>

#include "ping_pong_sim/ball.h"

namespace ping_pong
{
/// p(s) = c0 + c1 s + ... + c_degree s^degree with s = t - start, spin constant (no torque acts on a smooth sphere).
/// Flight in vacuum has degree 2; a path held to a curved or turning surface is a quintic piece.
struct Segment
{
  static constexpr int kMaxDegree = 5;

  double start = 0.0;                                          ///< world time of s = 0 [s]
  double end = std::numeric_limits<double>::infinity();        ///< world time up to which it holds [s]
  int degree = 0;
  Vector3d c[kMaxDegree + 1] = {Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(),
                                Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};  ///< [m/s^k], in W
  Quaterniond q_WB = Quaterniond::Identity();                  ///< orientation at s = 0
  Vector3d w_WB = Vector3d::Zero();                            ///< spin [rad/s]

  Vector3d position(double s) const;
  Vector3d velocity(double s) const;
  Vector3d acceleration(double s) const;
  BallState state(double s) const;

  /// Upper bound of |velocity| and |acceleration| for s in [from, to].
  double speedBound(double from, double to) const;
  double accelerationBound(double from, double to) const;
};
}  // namespace ping_pong
