// How handles look and what can be dragged on each.
#pragma once

#include <visualization_msgs/InteractiveMarker.h>

#include <string>

#include "messages.h"

namespace ping_pong_sim
{
/// Arrows and rings along and about all three axes, and a bead in the middle that moves in the picture's plane.
/// @param size  [m]
visualization_msgs::InteractiveMarker bodyHandle(const std::string& name, const FramePose& pose, double size);

/// A clear shell around a ball.
visualization_msgs::InteractiveMarker ballHandle(const std::string& name, const FramePose& pose, double radius);

/// The bead that gives a ball a velocity.
visualization_msgs::InteractiveMarker throwHandle(const std::string& name, const Eigen::Vector3d& p_W);

/// An arrow to look at.
visualization_msgs::InteractiveMarker arrow(const std::string& name, const Eigen::Vector3d& from_W,
                                            const Eigen::Vector3d& to_W);
}  // namespace ping_pong_sim
