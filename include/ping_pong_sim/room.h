// A closed room: six planes that look inwards. Nothing leaves it, however fast.
#pragma once

#include <optional>
#include <vector>

#include "ping_pong_sim/body.h"

namespace ping_pong
{
/// The planes of a room of this inner size along x, y, z [m]. Origin: the middle of its floor.
std::vector<Shape> roomShapes(const Vector3d& size, MaterialId material);

/// Inner size of a body that is such a room [m]; nothing for any other body.
std::optional<Vector3d> roomSize(const Body& body);
}  // namespace ping_pong
