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

  Vector3d position(double s) const;
  Vector3d velocity(double s) const;
  Vector3d acceleration(double s) const;
  Vector3d spin(double s) const;
  BallState state(double s) const;

  /// Upper bound of |velocity| and |acceleration| for s in [from, to].
  double speedBound(double from, double to) const;
  double accelerationBound(double from, double to) const;

private:
  static std::array<Vector3d, kMaxDegree + 1> zeros();
};
}  // namespace ping_pong
