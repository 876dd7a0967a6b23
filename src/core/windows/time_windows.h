// Many balls, each on its own clock: every ball flies through a window as if it were alone. Where the boxes that balls sweep
// overlap and they would meet, they form an island: it goes back to the start of the window and runs event by event, together.
// A ball that is thrown off its path may sweep into others: then the islands are joined and run again. What comes out is the
// same as if all balls had been handled in one list of events, in any order of the islands.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
/// Handles all events of all balls from world.time to `end`; the motions of all paddles are smooth until then.
void runIslands(WorldWithWindows& world, double end);
}  // namespace ping_pong
