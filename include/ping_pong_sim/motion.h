// How a body moves during one window: a smooth path whose pose and velocity agree at every instant.
#pragma once

#include "ping_pong_sim/types.h"

namespace ping_pong
{
/// p(s) = p0 + v0 s + a s^2/2 and R(s) = exp(w0 s + alpha s^2/2) R0, for s in [0, duration] after `start`.
/// Rotation vector quadratic in time: pose, velocity and acceleration are exact derivatives of each other.
struct BodyMotion
{
  double start = 0.0;                    ///< world time at s = 0 [s]
  Pose pose;                             ///< X_WB at s = 0
  Twist twist;                           ///< (v0, w0), expressed in W
  Vector3d a_WB = Vector3d::Zero();      ///< [m/s^2]
  Vector3d alpha_WB = Vector3d::Zero();  ///< second derivative of the rotation vector [rad/s^2]

  bool still() const;    ///< does not move at all
  bool turning() const;  ///< any rotation
  Pose poseAt(double s) const;
  Twist twistAt(double s) const;
};

/// Everything about a body at one instant that contact calculations need.
struct BodyFrame
{
  Matrix3d R_WB = Matrix3d::Identity();
  Vector3d p_WB = Vector3d::Zero();
  Vector3d v_WB = Vector3d::Zero();
  Vector3d w_WB = Vector3d::Zero();
  Vector3d a_WB = Vector3d::Zero();
  Vector3d alpha_WB = Vector3d::Zero();  ///< derivative of w_WB

  /// Velocity of the material point of the body that is now at p_WC, expressed in W [m/s].
  Vector3d pointVelocity(const Vector3d& p_WC) const { return v_WB + w_WB.cross(p_WC - p_WB); }
};

BodyFrame frameAt(const BodyMotion& motion, double s);
}  // namespace ping_pong
