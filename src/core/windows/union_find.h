// Which balls are of one island.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
/// Those who met are of one island now; its root is in a list of a worker, of islands that have to run.
void uniteWhoMet(WorldWithWindows& world);
}  // namespace ping_pong
