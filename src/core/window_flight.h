// A window is flown by every ball as if it were alone; then all look for others in their way.
#pragma once

#include "exact_method.h"

namespace ping_pong
{
/// The outlook of a window before this one holds to its end.
bool seesAhead(const IslandRecords& islands, double end);

/// Ball i may have an event with a body until the outlook ends.
bool isDue(const IslandRecords& islands, std::size_t i);

/// All fly, and each looks for others in its way.
void flyAnew(WorldState& world, const Window& window);

/// The same where one sees ahead: whom balls meet that nothing happens to is known.
void flyOn(WorldState& world, const Window& window);
}  // namespace ping_pong
