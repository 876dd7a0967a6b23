#include "glide.h"

#include <cmath>

namespace ping_pong
{
namespace
{
constexpr double kStill = 1e-3;         ///< [m/s]
constexpr double kStillTurning = 3e-3;  ///< [rad/s]

Eigen::Vector3d damped(const Eigen::Vector3d& v, const Eigen::Vector3d& a, double damping, double dt, double still)
{
  const double stays = std::exp(-damping * dt);
  const double gained = damping > 0.0 ? (1.0 - stays) / damping : dt;
  const Eigen::Vector3d after = stays * v + gained * a;
  if (a.isZero(0.0) && after.norm() < still) return Eigen::Vector3d::Zero();
  return after;
}
}  // namespace

Glide glide(const Glide& from, const Eigen::Vector3d& a_W, const Eigen::Vector3d& alpha_W, double damping, double dt)
{
  return {damped(from.v_W, a_W, damping, dt, kStill), damped(from.w_W, alpha_W, damping, dt, kStillTurning)};
}

Eigen::Matrix3d viewAxes(const Eigen::Vector3d& right_W, const Eigen::Vector3d& up_W)
{
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d right(right_W.x(), right_W.y(), 0.0);
  if (right.norm() < 0.1)  // a camera that lies on its side
  {
    const Eigen::Vector3d away = up_W.cross(right_W);
    right = Eigen::Vector3d(away.y(), -away.x(), 0.0);
  }
  if (right.norm() < 0.1) return Eigen::Matrix3d::Identity();
  right.normalize();
  Eigen::Matrix3d axes;
  axes << z.cross(right), -right, z;
  return axes;
}
}  // namespace ping_pong
