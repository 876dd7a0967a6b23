// Distance of two disjoint convex shapes.
#pragma once

#include <functional>

#include "ping_pong_sim/types.h"

namespace ping_pong
{
/// Point of the difference A - B of two convex sets that is furthest along a direction.
using DifferenceSupport = std::function<Vector3d(const Vector3d&)>;

/// Shortest vector from B to A, by the algorithm of Gilbert, Johnson and Keerthi ("A fast procedure for computing the
/// distance between complex objects", 1988); zero if they overlap or come nearer than 1e-12 m.
Vector3d shortestDifference(const DifferenceSupport& support, const Vector3d& start);
}  // namespace ping_pong
