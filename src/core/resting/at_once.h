// Changes of a ball's velocity in one instant: grips that bring slip to rest, and impacts on all that it touches.
#pragma once

#include "resting/constrained_ball.h"

namespace ping_pong
{
bool any(const Grips& grips);
Grips allThatIsRough(const ConstrainedBall& constrained);

/// Brings these motions to rest at once, as by an impulse: energy falls.
/// @param modes  of what goes on slipping meanwhile, and rubs; null where speeds change by so much that its slip may turn
void gripAtOnce(const ConstrainedBall& constrained, const Grips& grips, const ContactProblem* modes, double t,
                BallMotion& ball);

/// An impact without rebound on all surfaces at the same time: the contact problem of forces, with velocities in the place of
/// accelerations (Moreau 1988, "Unilateral contact and dry friction in finite freedom dynamics").
/// @param impulses  of each surface on the ball, per mass: load and friction [m/s]
/// @return  false if there is no answer; the ball is as it was then
bool strikeAll(const ConstrainedBall& constrained, double t, BallMotion& ball, SupportForces& impulses);
}  // namespace ping_pong
