// Evolve: move a ball through the air for a while, no contacts.
#pragma once

#include "ping_pong_sim/scene.h"
#include "ping_pong_sim/segment.h"

namespace ping_pong
{
/// Acceleration of a free ball from the scene's forces [m/s^2], in W. The room for a new force.
Vector3d freeAcceleration(const Forces& forces);

/// Closed-form flight in vacuum from `state` at time `start`: p0 + v0 s + g s^2 / 2.
Segment fly(const BallState& state, double start, const Forces& forces);

/// One fixed step of the sampled methods. Explicit: x += v h, v += a h. Semi-implicit: v += a h, x += v h.
void stepExplicit(BallState& state, const Forces& forces, double h);
void stepSemiImplicit(BallState& state, const Forces& forces, double h);

/// Orientation after turning with constant spin w (in W) for s [s].
Quaterniond turned(const Quaterniond& q, const Vector3d& w, double s);
}  // namespace ping_pong
