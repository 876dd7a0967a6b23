// The methods that sample contacts: step, then look for overlaps, push out and reflect. What everybody writes first.
#pragma once

#include "world_state.h"

namespace ping_pong
{
/// Advances all balls to `end` in equal steps no longer than scene.dt.
void runFixedStep(WorldState& world, double end);
}  // namespace ping_pong
