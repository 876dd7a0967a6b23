// How far a player's arm reaches: a box around one end of a table.
#pragma once

#include <Eigen/Geometry>
#include <optional>

namespace ping_pong
{
/// One end of a table, as the player there sees it. Frame E: origin in the middle of the end's upper edge, x to the net, y left, z up.
struct TableEnd
{
  Eigen::Isometry3d X_WE = Eigen::Isometry3d::Identity();
  double sign = -1.0;  ///< of the end along the x axis of the table's frame
};

/// The end on whose side of the net p is. @param X_WT  pose of the table's frame, whose origin is in the middle of the playing surface
TableEnd nearerEnd(const Eigen::Isometry3d& X_WT, const Eigen::Vector3d& p_W);

/// A box in frame E, for the centre of the blade [m].
struct Reach
{
  bool limited = true;  ///< false: an arm as long as one likes
  double behind = 1.5;  ///< of the end of the table
  double over = 0.6;    ///< the table
  double side = 1.3;    ///< to each side of its middle
  double below = 0.35;  ///< the playing surface
  double above = 1.0;

  Eigen::Vector3d min() const { return {-behind, -side, -below}; }
  Eigen::Vector3d max() const { return {over, side, above}; }
};

bool contains(const Reach& reach, const Eigen::Vector3d& p_E);
Eigen::Vector3d clampTo(const Reach& reach, const Eigen::Vector3d& p_E);

/// The velocity at which friction alone still brings the blade to rest within reach: what is faster is cut down. Beyond the border it
/// leads slowly back.
/// @param damping  of that friction, dv/dt = -damping v [1/s]
Eigen::Vector3d slowedAtBorder(const Reach& reach, const Eigen::Vector3d& p_E, const Eigen::Vector3d& v_E,
                               double damping);

/// Where a ray, such as that from the eye through the mouse, meets the plane x = depth; nothing if it runs beside it or away from it.
std::optional<Eigen::Vector3d> onPlane(const Eigen::Vector3d& origin_E, const Eigen::Vector3d& direction_E,
                                       double depth);
}  // namespace ping_pong
