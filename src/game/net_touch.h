// Whether a racket touches the net assembly: the physics stops paddles there, but lists no contact of two bodies.
#pragma once

#include "game/court.h"

namespace ping_pong
{
class World;
}

namespace ping_pong::game
{
/// True while the racket of that end is within 0.2 mm of the net assembly: a paddle that is stopped by it stays nearer than that.
bool racketTouchesNet(const World& world, const Court& court, End end);

/// Whether two convex shapes are nearer to each other than `limit`, or overlap. A gap that differs from the limit by less than a
/// millionth of the shapes' size may be taken for either.
/// @param limit  > 0 [m]
bool nearerThan(double limit, const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);
}  // namespace ping_pong::game
