#include "reach.h"

#include <algorithm>
#include <cmath>

namespace ping_pong
{
namespace
{
constexpr double kHalfLength = 1.37;   ///< of a table [m]
constexpr double kLeastDamping = 3.0;  ///< so that a paddle without friction gets to the border at all [1/s]
constexpr double kBack = 0.5;          ///< speed of the way back, where the border was passed [m/s]
constexpr double kAlong = 0.05;        ///< a ray flatter than this runs along the plane
}  // namespace

TableEnd nearerEnd(const Eigen::Isometry3d& X_WT, const Eigen::Vector3d& p_W)
{
  TableEnd end;
  end.sign = (X_WT.inverse() * p_W).x() < 0.0 ? -1.0 : 1.0;
  const double yaw = end.sign < 0.0 ? 0.0 : M_PI;
  end.X_WE =
      X_WT * Eigen::Translation3d(end.sign * kHalfLength, 0.0, 0.0) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
  return end;
}

bool contains(const Reach& reach, const Eigen::Vector3d& p_E)
{
  return (p_E.array() >= reach.min().array()).all() && (p_E.array() <= reach.max().array()).all();
}

Eigen::Vector3d clampTo(const Reach& reach, const Eigen::Vector3d& p_E)
{
  return p_E.cwiseMax(reach.min()).cwiseMin(reach.max());
}

Eigen::Vector3d slowedAtBorder(const Reach& reach, const Eigen::Vector3d& p_E, const Eigen::Vector3d& v_E,
                               double damping)
{
  // A speed v ends after v / damping. Where the place came late, and the border was passed, it leads back.
  const double rate = std::max(damping, kLeastDamping);
  const Eigen::Vector3d most = (rate * (reach.max() - p_E)).cwiseMax(-kBack);
  const Eigen::Vector3d least = (rate * (reach.min() - p_E)).cwiseMin(kBack);
  return v_E.cwiseMin(most).cwiseMax(least);
}

std::optional<Eigen::Vector3d> onPlane(const Eigen::Vector3d& origin_E, const Eigen::Vector3d& direction_E,
                                       double depth)
{
  const double along = direction_E.x() / direction_E.norm();
  const double distance = (depth - origin_E.x()) / direction_E.x();
  if (std::abs(along) < kAlong || distance <= 0.0) return std::nullopt;
  return origin_E + distance * direction_E;
}
}  // namespace ping_pong
