// What each ball has flown in a window of time so far, piece by piece: who comes too near later finds here whether they met.
#pragma once

#include "exact_method.h"

namespace ping_pong
{
/// To be called before ball i leaves its path at time t.
void noteFlown(WorldState& world, const Window& window, std::size_t i, double t);

/// The same for several pieces of flight at once, of which no more is known than that they were in a box. One piece
/// has been noted before.
void noteSomewhere(WorldState& world, const Window& window, std::size_t i, const Box& box, double t);

/// As if ball i had not flown in this window.
void forgetFlown(IslandRecords& islands, std::size_t i);

/// To be called when ball i has no more events in this window: the path that it is on takes it to the end.
void noteLast(WorldState& world, const Window& window, std::size_t i);

/// When balls i and k meet on the paths that they are on, if it is until then; a search without an answer says up to when they
/// do not [s].
double firstMeeting(const WorldState& world, std::size_t i, std::size_t k, double until);

/// Of balls flown apart.
struct Encounter
{
  bool met;     ///< they came into each other's way in the window; a piece that is no parabola may say so too often
  double next;  ///< else: when they meet on the paths that they are on, if it is until the outlook ends, see firstMeeting() [s]
};
Encounter encounterOf(const WorldState& world, const Window& window, std::size_t i, std::size_t k);
}  // namespace ping_pong
