// One smooth piece of a ball's path: a state for every instant of it.
#pragma once

#include <array>
#include <limits>

#include "base/pooled.h"
#include "ping_pong_sim/ball.h"

namespace ping_pong
{
/// What the spin of a path has beyond its linear term: on a curved or turning surface.
struct SpinCoefficients
{
  static constexpr int kFirst = 2;  ///< power of s that c begins with
  static constexpr int kLast = 8;

  std::array<Vector3d, kLast - kFirst + 1> c{};  ///< [rad/s^(k+1)], in W
  double next_piece = 0.0;                       ///< length that will do for the piece after this one, 0: unknown [s]
};

/// What a path has that is not free flight in vacuum.
struct HigherCoefficients
{
  static constexpr int kFirst = 3;  ///< power of s that c begins with
  static constexpr int kLast = 9;

  std::array<Vector3d, kLast - kFirst + 1> c;    ///< [m/s^k], in W; as many as the degree of the path asks for
  Vector3d pending_rotation = Vector3d::Zero();  ///< turning before s = 0 that is not in q_WB yet [rad]
  Vector3d alpha_WB = Vector3d::Zero();          ///< on a surface [rad/s^2]
  double spin_decay = 0.0;                       ///< in the air [1/s]
  double next_piece = 0.0;                       ///< length that will do for the piece after this one, 0: unknown [s]
  Vector3d a_low, a_high;                        ///< of a degree above 2, see boundAcceleration() [m/s^2]
  Pooled<SpinCoefficients> spin;
};

/// p(s) = c0 + c1 s + ... + c_degree s^degree with s = t - start; spin w(s) = w exp(-decay s) + alpha s + spin coefficients.
/// Flight in vacuum has degree 2 and no higher coefficients; flight through air degree 5 to 9; a path held to a curved or turning
/// surface degree 9, with spin coefficients. Without higher coefficients all that is theirs is zero.
struct Segment
{
  static constexpr int kMaxDegree = HigherCoefficients::kLast;

  Quaterniond q_WB = Quaterniond::Identity();                    ///< orientation at s = 0
  double start = 0.0;                                            ///< world time of s = 0 [s]
  double end = std::numeric_limits<double>::infinity();          ///< world time up to which it holds [s]
  std::array<Vector3d, HigherCoefficients::kFirst> c = zeros();  ///< [m/s^k], in W
  Vector3d w_WB = Vector3d::Zero();                              ///< spin at s = 0 [rad/s]
  Pooled<HigherCoefficients> higher;
  int degree = 0;

  const Vector3d& coefficient(int k) const
  {
    return k < HigherCoefficients::kFirst ? c[k] : higher->c[k - HigherCoefficients::kFirst];
  }
  /// The same to be written to; the higher coefficients have to be there where they are asked for.
  Vector3d& coefficient(int k)
  {
    return k < HigherCoefficients::kFirst ? c[k] : higher->c[k - HigherCoefficients::kFirst];
  }
  Vector3d pending_rotation() const { return higher ? higher->pending_rotation : Vector3d(Vector3d::Zero()); }
  Vector3d alpha_WB() const { return higher ? higher->alpha_WB : Vector3d(Vector3d::Zero()); }
  double spinDecay() const { return higher ? higher->spin_decay : 0.0; }

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

  /// Bounds of each component of the acceleration on the whole piece [m/s^2].
  Vector3d aLow() const { return degree > 2 ? higher->a_low : Vector3d(2.0 * c[2]); }
  Vector3d aHigh() const { return degree > 2 ? higher->a_high : Vector3d(2.0 * c[2]); }
  /// Sets them where the degree is above 2, once the coefficients and the end are there: the least and greatest Bernstein
  /// coefficients on [0, end - start].
  void boundAcceleration();
  /// Upper bound of |acceleration| on the whole piece, and of |velocity| for s in [from, to].
  double accelerationBound() const { return aLow().cwiseAbs().cwiseMax(aHigh().cwiseAbs()).norm(); }
  double speedBound(double from, double to) const { return velocity(from).norm() + (to - from) * accelerationBound(); }

private:
  Quaterniond orientation(double s) const;
  Vector3d positionOnPolynomial(double s) const;
  Vector3d velocityOnPolynomial(double s) const;
  static std::array<Vector3d, HigherCoefficients::kFirst> zeros()
  {
    return {Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  }
};
}  // namespace ping_pong
