// Nearest surface point, with everything in the shape's own frame.
#pragma once

#include "ping_pong_sim/shape.h"

namespace ping_pong
{
/// As proximity(), but for a point and an answer in the axes of the shape, at its origin.
Proximity proximityHere(const Shape& shape, const Vector3d& p_SQ);
}  // namespace ping_pong
