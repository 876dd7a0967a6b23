// Contact mode of the exact method: from bouncing to lying on a surface, and the path on it.
#pragma once

#include "world_state.h"

namespace ping_pong
{
/// Decides when bouncing has ended: all bounces still to come, taken together, lift the ball by less than 1e-12 m. Their
/// time is summed in closed form, so no bounce is lost from the clock, and no speed is a threshold.
/// @param rate  speed away from the surface after the bounce [m/s]
/// @param press  acceleration into the surface, > 0 [m/s^2]
bool bouncingEnds(double rate, double press, double restitution);

/// Time of all bounces to come: flights 2 v/a with v falling by e each time, 2 v / (a (1 - e)) [s].
double timeOfRemainingBounces(double rate, double press, double restitution);

/// Acceleration of the ball with what its supports allow. Marks the loaded supports in `bounds`.
Vector3d heldAcceleration(const WorldState& world, const Supports& supports, const BallState& ball, double t,
                          AccelerationBounds& bounds);

/// Plans the path from `state` at time t: drops supports that let go or were left, projects what remains of the velocity
/// into them, and lays a closed-form path in the air or on flat faces, or one short quintic piece on curved or turning
/// surfaces. On moving bodies it holds until `window_end` only.
void planPath(const WorldState& world, BallRecord& ball, BallState state, double t, double window_end);
}  // namespace ping_pong
