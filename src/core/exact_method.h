// The exact method: closed-form paths, contacts located on them, handled one event after the other.
#pragma once

#include "world_state.h"

namespace ping_pong
{
/// See MethodFunctions.
void reserveExact(WorldState& world, std::size_t balls);
void startExact(WorldState& world);
void exactBallChanged(WorldState& world, std::size_t ball);

/// Balls that may meet each other, and how long they are followed.
struct Window
{
  double start = 0.0;                     ///< [s]
  double end = 0.0;                       ///< [s]
  double smooth_until = 0.0;              ///< the motions of all paddles are smooth until then [s]
  const std::size_t* members = nullptr;   ///< indices of balls
  std::size_t count = 0;
  Records* records = nullptr;             ///< of the world; of the worker,
  IslandWork* work = nullptr;             ///< who also notes what the balls have flown. Null: nobody will ask
  std::size_t most_events = ~std::size_t{0};  ///< more than that are not handled
  double outlook = 0.0;                   ///< whom balls meet is looked for until then, see outlook.h; no earlier than `end` [s]
};

/// Handles all events of these balls up to the end of the window, one after the other; false if there are more than most_events.
/// What they foresee with each other must be true or void.
bool runTogether(WorldState& world, const Window& window);

/// Handles all events up to `end`. See MethodFunctions.
void runExact(WorldState& world, double end);

/// The ball stays where it was last whole, collides with nothing, and is let go at rest when there is room again.
void squeeze(Records& records, BallRecord& ball, BallState state, double t);

/// Frees balls that have room again.
void releaseSqueezed(WorldState& world);
}  // namespace ping_pong
