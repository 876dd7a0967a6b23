#include "follow.h"

#include <cmath>

namespace ping_pong
{
namespace
{
// Solution of x'' = -2 r x' - r^2 x from x0 with velocity v0.
struct Spring
{
  Spring(const Eigen::Vector3d& x0, const Eigen::Vector3d& v0, double r, double t)
      : x(std::exp(-r * t) * (x0 + t * (v0 + r * x0))), v(std::exp(-r * t) * (v0 - r * t * (v0 + r * x0)))
  {
  }
  Eigen::Vector3d x;
  Eigen::Vector3d v;
};

/// Rotation vector of the short way from `to` to `from`.
Eigen::Vector3d turnBetween(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to)
{
  Eigen::Quaterniond turn = from * to.conjugate();
  if (turn.w() < 0.0) turn.coeffs() *= -1.0;
  const Eigen::AngleAxisd angle(turn);
  return angle.angle() * angle.axis();
}

Eigen::Quaterniond toTurn(const Eigen::Vector3d& r)
{
  const double angle = r.norm();
  return angle < 1e-12 ? Eigen::Quaterniond::Identity() : Eigen::Quaterniond(Eigen::AngleAxisd(angle, r / angle));
}
}  // namespace

Followed follow(const Followed& from, const Eigen::Vector3d& target_p, const Eigen::Quaterniond& target_q, double rate,
                double dt)
{
  const Spring position(from.p - target_p, from.v, rate, dt);
  const Spring turn(turnBetween(from.q, target_q), from.w, rate, dt);
  return {target_p + position.x, (toTurn(turn.x) * target_q).normalized(), position.v, turn.v};
}

bool arrived(const Followed& followed, const Eigen::Vector3d& target_p, const Eigen::Quaterniond& target_q)
{
  return (followed.p - target_p).norm() < 5e-4 && followed.v.norm() < 5e-3 &&
         turnBetween(followed.q, target_q).norm() < 2e-3 && followed.w.norm() < 2e-2;
}
}  // namespace ping_pong
