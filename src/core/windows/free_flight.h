// A window is flown by every ball as if it were alone; then all look for others in their way.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
/// The outlook of a window before this one holds to its end.
bool seesAhead(const WorldWithWindows& world, double end);

/// Ball i may have an event with a body until the outlook ends.
bool isDue(const IslandRecords& islands, std::size_t i);

/// All fly, and each looks for others in its way.
void flyAnew(WorldWithWindows& world, const WorkerWindow& window);

/// The same where one sees ahead: whom balls meet that nothing happens to is known.
void flyOn(WorldWithWindows& world, const WorkerWindow& window);
}  // namespace ping_pong
