// Resolve, for the exact method: what an event makes of its balls.
#pragma once

#include <array>

#include "events/event_loop.h"

namespace ping_pong
{
/// An event that is due, with the balls whose paths end with it.
struct DueEvent
{
  Event event;
  std::array<std::size_t, 2> balls;  ///< indices
  std::size_t count;                 ///< of balls that go on from here; 0 once a squeezed ball has been taken out
  std::array<BallState, 2> states;   ///< of these balls at the time of the event: before it, and once resolved after it
};

/// Impacts change the states, list a contact, and may make a surface a support. Where a face ends nothing changes at once.
void resolve(WorldState& world, const Window& window, DueEvent& due);
}  // namespace ping_pong
