// Event by event: closed-form paths, contacts located on them, handled one after the other.
#pragma once

#include "events/flight_log.h"
#include "state/world_state.h"

namespace ping_pong
{
/// Balls that may meet each other, and how long they are followed.
struct Window
{
  double start = 0.0;                    ///< [s]
  double end = 0.0;                      ///< [s]
  double smooth_until = 0.0;             ///< the motions of all paddles are smooth until then [s]
  const std::size_t* members = nullptr;  ///< indices of balls
  std::size_t count = 0;
  Records* records = nullptr;                 ///< of the world or of a worker
  FlightLog* log = nullptr;                   ///< told what the balls fly; null if nobody will ask
  std::size_t most_events = ~std::size_t{0};  ///< more than that are not handled
  double lookahead = 0.0;  ///< whom balls meet is looked for until then, see lookahead.h; no earlier than `end` [s]
};

/// Handles all events of these balls up to the end of the window, one after the other; false if there are more than most_events.
/// What they predict with each other must be true or void.
bool runTogether(WorldState& world, const Window& window);
}  // namespace ping_pong
