// Plain value types shared by all rooms of the physics. SI units, right-handed frames (REP-103).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

namespace ping_pong
{
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Where a frame B is in a frame A: p_AB and the rotation that takes vectors in B to vectors in A.
struct Pose
{
  Vector3d p = Vector3d::Zero();            ///< p_AB [m]
  Quaterniond q = Quaterniond::Identity();  ///< rotation B -> A, unit length

  /// A point Q given in A, as it is in B [m].
  Vector3d toB(const Vector3d& p_AQ) const { return q.conjugate() * (p_AQ - p); }
};

/// Velocity of a frame B in A, both vectors expressed in A.
struct Twist
{
  Vector3d v = Vector3d::Zero();  ///< v_AB [m/s]
  Vector3d w = Vector3d::Zero();  ///< w_AB [rad/s]
};

struct Color
{
  float r = 1.0f, g = 0.5f, b = 0.0f, a = 1.0f;  ///< 0 to 1
};

using BallId = std::uint32_t;      ///< stays with a ball for its life; frame `ball_<id>`
using MaterialId = std::uint16_t;  ///< index into Scene::materials

constexpr std::size_t kNone = static_cast<std::size_t>(-1);  ///< "no such index"
}  // namespace ping_pong
