// The methods that sample contacts: step, then look for overlaps, push out and reflect. What everybody writes first.
#pragma once

#include "world_state.h"

namespace ping_pong
{
/// Advance all balls to `end` in equal steps no longer than scene.dt; see MethodFunctions.
void runEulerExplicit(WorldState& world, double end);
void runEulerSemiImplicit(WorldState& world, double end);
void runVerlet(WorldState& world, double end);
void runRk4(WorldState& world, double end);
}  // namespace ping_pong
