// The exact method: closed-form paths, contacts located on them, handled one event after the other.
#pragma once

#include "world_state.h"

namespace ping_pong
{
/// Plans paths and events of all balls from scratch at world.time.
void restartExact(WorldState& world);

/// Handles all events up to `window_end`; the motions of all paddles are smooth until then.
void runExact(WorldState& world, double window_end);

/// The ball stays where it was last whole, collides with nothing, and is let go at rest when there is room again.
void squeeze(BallRecord& ball, BallState state, double t);

/// Frees balls that have room again.
void releaseSqueezed(WorldState& world);
}  // namespace ping_pong
