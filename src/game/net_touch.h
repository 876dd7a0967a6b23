// Whether a racket touches the net assembly: the physics stops paddles there, but lists no contact of two bodies.
#pragma once

#include "game/court.h"

namespace ping_pong
{
class World;

/// True while the racket of that end is within 0.2 mm of the net assembly: a paddle that is stopped by it stays nearer than that.
bool racketTouchesNet(const World& world, const Court& court, End end);

/// Distance between two convex shapes, 0 where they overlap [m]. It is never too small, and too large by less than 1e-5 m for
/// shapes of a racket's size.
double gapBetween(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);
}  // namespace ping_pong
