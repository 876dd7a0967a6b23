// What each ball has flown in a window of time so far, piece by piece: who comes too near later finds here whether they met.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
/// runTogether() with a log of what the balls of the window fly.
bool runLogged(WorldWithWindows& world, const WorkerWindow& window);

/// As if ball i had not flown in this window.
void forgetFlown(IslandRecords& islands, std::size_t i);

/// To be called when ball i has no more events in this window: the path that it is on takes it to the end.
void noteLast(WorldWithWindows& world, const WorkerWindow& window, std::size_t i);

/// When balls i and k meet on the paths that they are on, if it is until then; a search without an answer says up to when they
/// do not [s].
double firstMeeting(const WorldWithWindows& world, std::size_t i, std::size_t k, double until);

/// Of balls flown apart.
struct Encounter
{
  bool met;  ///< they came into each other's way in the window; a piece that is no parabola may say so too often
  double
      next;  ///< else: when they meet on the paths that they are on, if it is until the outlook ends, see firstMeeting() [s]
};
Encounter encounterOf(const WorldWithWindows& world, const WorkerWindow& window, std::size_t i, std::size_t k);
}  // namespace ping_pong
