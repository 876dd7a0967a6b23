// A ball without room.
#pragma once

#include "state/world_state.h"

namespace ping_pong
{
/// The ball stays where it was last whole, collides with nothing, and is released at rest when there is room again.
void squeeze(Records& records, BallRecord& ball, BallState state, double t);
}  // namespace ping_pong
