// The part of a vector in the tangent plane of a surface.
#pragma once

#include "ping_pong_sim/types.h"

namespace ping_pong
{
/// @param n  unit normal of the surface
inline Vector3d tangential(const Vector3d& x, const Vector3d& n)
{
  return x - n.dot(x) * n;
}
}  // namespace ping_pong
