// The method `impulse`: every ball is in the contact solver, in steps of scene.dt.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
/// See MethodFunctions.
void reserveImpulse(WorldWithWindows& world, std::size_t balls);
void startImpulse(WorldWithWindows& world);
void impulseBallChanged(WorldWithWindows& world, std::size_t ball);
void runImpulse(WorldWithWindows& world, double end);
}  // namespace ping_pong
