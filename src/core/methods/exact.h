// The method `exact`: one ball by itself, or many in time windows.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
/// See MethodFunctions.
void reserveExact(WorldWithWindows& world, std::size_t balls);
void startExact(WorldWithWindows& world);
void exactBallChanged(WorldWithWindows& world, std::size_t ball);

/// Handles all events up to `end`. See MethodFunctions.
void runExact(WorldWithWindows& world, double end);
}  // namespace ping_pong
