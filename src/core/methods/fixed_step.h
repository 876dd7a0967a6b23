// The methods that sample contacts: step, then look for overlaps, push out and reflect. What everybody writes first.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
/// Advance all balls to `end` in equal steps no longer than scene.dt; see MethodFunctions.
void runEulerExplicit(WorldWithWindows& world, double end);
void runEulerSemiImplicit(WorldWithWindows& world, double end);
void runVerlet(WorldWithWindows& world, double end);
void runRk4(WorldWithWindows& world, double end);
}  // namespace ping_pong
