// Smooth motion after a hand that jumps from picture to picture.
#pragma once

#include <Eigen/Geometry>

namespace ping_pong
{
struct Followed
{
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d w = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// Follows the target for `dt` as a critically damped spring would, exactly: no overshoot from rest, whatever the tick.
/// A target that jumps by d is approached at d rate / e at most.
/// @param rate  1 / time constant [1/s]
Followed follow(const Followed& from, const Eigen::Vector3d& target_p, const Eigen::Quaterniond& target_q, double rate,
                double dt);

/// So close and so slow that a person sees no difference.
bool arrived(const Followed& followed, const Eigen::Vector3d& target_p, const Eigen::Quaterniond& target_q);
}  // namespace ping_pong
