// The methods that sample contacts: step, then look for overlaps, push out and reflect. What everybody writes first.
#pragma once

#include "world_state.h"

namespace ping_pong
{
/// Works out what does not change from step to step. To be called when balls have come or gone.
void restartFixedStep(WorldState& world);

/// Advances all balls to `end` in equal steps no longer than scene.dt.
void runFixedStep(WorldState& world, double end);
}  // namespace ping_pong
