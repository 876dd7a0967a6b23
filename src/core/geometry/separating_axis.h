// Distance of two convex shapes by separating axes.
#pragma once

#include "ping_pong_sim/shape.h"

namespace ping_pong
{
/// Best separating axis of shapes A and B.
struct Separation
{
  double gap = 0.0;                  ///< along the axis: at most the distance, negative in overlap [m]
  Vector3d n_W = Vector3d::UnitZ();  ///< unit, from B to A
  Vector3d p_WC = Vector3d::Zero();  ///< point of A that is nearest to B along the axis [m]
};

/// Looks along face normals, cylinder axes and their cross products (Gottschalk, Lin, Manocha, "OBBTree", 1996); where round
/// shapes come close, also along the line of nearest points. The sign of the gap is right, its size a lower bound.
Separation separation(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);
}  // namespace ping_pong
