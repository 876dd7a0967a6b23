// Things that are only seen: lights and cameras. A frame with a name, and no body that a ball could meet.
#pragma once

#include <map>
#include <string>

#include "ping_pong_sim/world.h"

namespace ping_pong_sim
{
/// Poses X_W of frames by name. They are no part of a scene: reset and load_scene leave them where they are.
using Props = std::map<std::string, ping_pong::Pose>;

/// A light above the player's side of the table's middle, and a camera behind the player; both look along their x axis.
Props defaultProps();

/// @param p    of the frame's origin in the world [m]
/// @param rpy  roll, pitch, yaw as in URDF [rad]
ping_pong::Pose propPose(const ping_pong::Vector3d& p, const ping_pong::Vector3d& rpy);

/// A body of the same name wins: then the frame is the body's.
bool isShown(const ping_pong::World& world, const std::string& prop);
}  // namespace ping_pong_sim
