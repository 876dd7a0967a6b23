// One stroke: an offset from the place of the hand that goes back, comes through that place with a speed, and ends there.
#pragma once

#include <Eigen/Core>

namespace ping_pong
{
struct Swing
{
  Eigen::Vector3d v = Eigen::Vector3d::Zero();  ///< at the hit [m/s]
  double hit_at = 0.0;                          ///< when it comes through the hand's place [s]
  double half = 0.1;                            ///< it lasts from half before to half after that [s]
};

struct SwingPoint
{
  Eigen::Vector3d p = Eigen::Vector3d::Zero();  ///< from the hand's place [m]
  Eigen::Vector3d v = Eigen::Vector3d::Zero();  ///< [m/s]
};

/// Place and speed at a time; both are continuous, and zero before and after.
SwingPoint at(const Swing& swing, double time);
inline bool over(const Swing& swing, double time)
{
  return time >= swing.hit_at + swing.half;
}
}  // namespace ping_pong
