// Where a ball may be: overlap queries and ways out of an overlap.
#pragma once

#include "world_state.h"

namespace ping_pong
{
/// Deepest overlap of a sphere with any body at world time t.
struct Overlap
{
  double gap = kNever;        ///< smallest gap, negative in overlap [m]
  Vector3d n_W = Vector3d::UnitZ();
  Vector3d u_W = Vector3d::Zero();  ///< velocity of the surface there [m/s]
  std::size_t body = kNone;
  std::size_t shape = kNone;
};

Overlap deepestOverlap(const WorldState& world, const Vector3d& p_WB, double radius, double t);

/// Moves a sphere out of all bodies along their normals; false if there is no room nearby.
bool pushOut(const WorldState& world, Vector3d& p_WB, double radius, double t);

/// What a ball at this place would overlap by more than 1e-9 m: "table (3.2 mm deep)"; empty if nothing. `except` is a ball
/// that does not count.
std::string describeOverlap(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except = kNone);
}  // namespace ping_pong
