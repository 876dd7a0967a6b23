// The free-flight pass of a window: every ball flies as if it were alone, then all look for others in their way.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
/// The lookahead of a window before this one holds to its end.
bool seesAhead(const WorldWithWindows& world, double end);

/// Ball i may have an event with a body until the lookahead ends.
bool isDue(const IslandRecords& islands, std::size_t i);

/// All fly, and each looks for others in its way.
void flyAll(WorldWithWindows& world, const WorkerWindow& window);

/// The same where one sees ahead: whom balls meet that nothing happens to is known.
void flyDue(WorldWithWindows& world, const WorkerWindow& window);
}  // namespace ping_pong
