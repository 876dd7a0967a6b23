// A ball on one of its supports at one instant: geometry, slip, and how both change.
#pragma once

#include "geometry/feature.h"
#include "geometry/tangential.h"
#include "ping_pong_sim/body.h"
#include "ping_pong_sim/scene.h"

namespace ping_pong
{
/// A surface that carries a ball, for as long as one path lasts.
struct SupportSurface
{
  const Shape* shape = nullptr;
  const Surface* law = nullptr;
  const BodyMotion* motion = nullptr;
  Feature feature;
  bool still = true;     ///< the body does not move
  bool turning = false;  ///< or it turns, too
  bool flat = true;      ///< the feature is a plane

  /// Neither curved nor turning: the normal stays.
  bool plane() const { return flat && !turning; }
};

/// Motion of a ball at one instant. Spins are surface speeds r w, so that all rates have one unit.
struct BallMotion
{
  Vector3d p = Vector3d::Zero();  ///< p_WB [m]
  Vector3d v = Vector3d::Zero();  ///< v_WB [m/s]
  Vector3d s = Vector3d::Zero();  ///< r w_WB [m/s]
};

/// Acceleration of a ball, the unknown of all contact equations.
struct BallAcceleration
{
  Vector3d a = Vector3d::Zero();  ///< dv/dt [m/s^2]
  Vector3d b = Vector3d::Zero();  ///< ds/dt = r dw/dt [m/s^2]
};

/// All vectors expressed in W. The rates of change hold for the ball's velocity; the ball's acceleration (a, b) enters as
///   d(gap rate)/dt = n.a - least,   d(slip)/dt = (a - b x n)_t + slip_bias,
///   d(roll)/dt = b_t + roll_bias,   d(spin)/dt = n.b + spin_bias.
struct SupportPoint
{
  Vector3d n;          ///< unit normal, towards the ball
  double gap;          ///< of the surfaces [m]
  double rate;         ///< of the gap [m/s]
  double least;        ///< n.a below this would go into the surface [m/s^2]
  Vector3d slip;       ///< velocity of the touching point over the surface: (v - s x n - u_C)_t [m/s]
  Vector3d slip_bias;  ///< [m/s^2]
  Vector3d roll;       ///< r times the tangential part of the ball's spin relative to the body [m/s]
  Vector3d roll_bias;  ///< [m/s^2]
  double spin;         ///< r times the normal part of it [m/s]
  double spin_bias;    ///< [m/s^2]
};

/// @param t  world time [s]
SupportPoint supportPoint(const SupportSurface& surface, const BallMotion& ball, double radius, double t);

/// Rates of slip, roll and spin under this acceleration [m/s^2].
inline Vector3d slipRate(const SupportPoint& at, const BallAcceleration& motion)
{
  return tangential(motion.a, at.n) - motion.b.cross(at.n) + at.slip_bias;
}
inline Vector3d rollRate(const SupportPoint& at, const BallAcceleration& motion)
{
  return tangential(motion.b, at.n) + at.roll_bias;
}
inline double spinRate(const SupportPoint& at, const BallAcceleration& motion)
{
  return at.n.dot(motion.b) + at.spin_bias;
}
}  // namespace ping_pong
