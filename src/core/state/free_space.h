// Where a ball may be: overlap queries and ways out of an overlap.
#pragma once

#include "state/world_state.h"

namespace ping_pong
{
/// Moves a sphere out of all bodies and balls along their normals; false if there is no room nearby. `except` is a ball
/// that does not count.
bool pushOut(const WorldState& world, Vector3d& p_WB, double radius, std::size_t except);

/// Moves a sphere out of still bodies alone, as far as that is possible.
void pushOutOfStill(const WorldState& world, Vector3d& p_WB, double radius);

/// Whether a ball at this place overlaps nothing by more than 1e-9 m. `except` is a ball that does not count.
bool hasRoom(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except);

/// The same by no more than balls of the solver do: 1e-4 m.
bool hasRoomInSolver(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except);

/// The same by 1e-9 m, but for the other balls.
bool hasRoomAmongBodies(const WorldState& world, const Vector3d& p_WB, double radius);

/// Whether a ball at this place overlaps a body by more than balls of the solver do: 1e-4 m.
bool overlapsABody(const WorldState& world, const Vector3d& p_WB, double radius);

/// What a ball at this place would overlap by more than 1e-9 m: "table (3.2 mm deep)"; empty if nothing. `except` is a ball
/// that does not count.
std::string describeOverlap(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except = kNone);
}  // namespace ping_pong
