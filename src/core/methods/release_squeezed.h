// Balls that had no room, after every motion of the bodies.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
/// Those that have room again are given back, at rest, to whom they were taken from.
void releaseSqueezed(WorldWithWindows& world);
}  // namespace ping_pong
