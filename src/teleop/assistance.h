// Help for a hand at the mouse: how to hold the blade for the ball that comes, and how to go through it.
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <optional>

#include "follow.h"

namespace ping_pong
{
/// A ball in the frame E of the player's end (reach.h).
struct BallSight
{
  Eigen::Vector3d p = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d v = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d w = Eigen::Vector3d::Zero();  ///< spin [rad/s]
};

/// What a helper would do, in frame E. Place across the table and height are the hand's alone.
struct Help
{
  Eigen::Quaterniond q =
      Eigen::Quaterniond::Identity();           ///< of the paddle's frame: x out of the forehand, z from handle to tip
  double depth = 0.0;                           ///< x at which to meet the ball [m]
  Eigen::Vector3d v = Eigen::Vector3d::Zero();  ///< of the blade at the hit [m/s]
  double in = 0.0;                              ///< until the hit [s]
};

/// Nothing: no ball comes that can be played. It is asked at every tick (100 Hz), so it takes well below a millisecond.
/// @param hand  the paddle as it is held now, in frame E; p.x() is the depth that the hand keeps
using Helper = std::function<std::optional<Help>(const BallSight& ball, const Followed& hand)>;

/// The simplest helper: a parabola to the hand's depth, and the mirror that sends the ball on another one to the middle of the other half.
/// A ball that is thrown up at this end is served. It knows neither air nor spin.
std::optional<Help> mirrorHelp(const BallSight& ball, const Followed& hand);

/// The attitude with this normal out of the forehand and the tip pointing away from a body that stands behind the middle of the end.
/// @param p  of the blade, in frame E
Eigen::Quaterniond heldAt(const Eigen::Vector3d& p, const Eigen::Vector3d& normal);
}  // namespace ping_pong
