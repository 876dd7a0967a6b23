// One polynomial piece of the path of a ball on surfaces that bend, turn, or whose friction changes its direction.
#pragma once

#include "resting/constrained_ball.h"

namespace ping_pong
{
/// Lays a piece from `ball` at time t on, under the modes of the decision: it ends where these cease to hold, where a support
/// ends, or where its error would pass the tolerance. Collocation at 8 Gauss-Legendre points for position, velocity and spin.
/// @param longest    [s]
/// @param tolerance  error of the position that the piece may leave after a second [m]
/// @param shortest   the piece is no shorter, whatever ends [s]
void layConstrainedPiece(const ConstrainedBall& constrained, const Decision& decision, const BallMotion& ball, double t,
                         double longest, double tolerance, double shortest, Segment& path);
}  // namespace ping_pong
