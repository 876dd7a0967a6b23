// Motion by keys: acceleration against friction, and the viewer's axes.
#pragma once

#include <Eigen/Geometry>

namespace ping_pong
{
/// How a held key moves things.
struct GlideParams
{
  double acceleration = 30.0;          ///< of a paddle while a key is held [m/s^2]
  double angular_acceleration = 60.0;  ///< likewise [rad/s^2]
  double damping = 14.0;               ///< dv/dt = a - damping v: top speed is a / damping [1/s]
  double speed = 0.6;                  ///< of everything else while a key is held [m/s]
  double angular_speed = 0.9;          ///< likewise [rad/s]
};

struct Glide
{
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d w_W = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// The speeds after `dt` under steady accelerations, exactly; so a long tick is as good as many short ones. Without
/// acceleration they come to rest: what is slower than a person sees (1 mm/s, 3 mrad/s) is zero.
Glide glide(const Glide& from, const Eigen::Vector3d& a_W, const Eigen::Vector3d& alpha_W, double damping, double dt);

/// Rotation that takes the viewer's axes (x away, y left, z up) to the world's. Up stays up: the viewer's pitch and
/// roll do not count. It holds for a view from above too: then "away" is to the upper edge of the picture.
/// @param right_W  to the right of the picture, expressed in W
/// @param up_W     to its upper edge, expressed in W
Eigen::Matrix3d viewAxes(const Eigen::Vector3d& right_W, const Eigen::Vector3d& up_W);
}  // namespace ping_pong
