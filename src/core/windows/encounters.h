// The flight log of a window of time, piece by piece: for a ball that comes too near another one later it tells whether they met.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
/// runTogether() with a log of the flights of its balls.
bool runLogged(WorldWithWindows& world, const WorkerWindow& window);

/// As if ball i had not moved in this window.
void clearFlightLog(IslandRecords& islands, std::size_t i);

/// To be called when ball i has no more events in this window: the path that it is on takes it to the end.
void noteLast(WorldWithWindows& world, const WorkerWindow& window, std::size_t i);

/// When balls i and k meet on the paths that they are on, if it is until then; a search without an answer says up to when they
/// do not [s].
double firstPairContact(const WorldWithWindows& world, std::size_t i, std::size_t k, double until);

/// Of two balls, each of which has flown as if it were alone.
struct PairOutcome
{
  bool met;  ///< they came into each other's way in the window; a piece that is no parabola may say so too often
  double
      next;  ///< else: when they meet on the paths that they are on, if it is until the lookahead ends, see firstPairContact() [s]
};
PairOutcome outcomeOf(const WorldWithWindows& world, const WorkerWindow& window, std::size_t i, std::size_t k);
}  // namespace ping_pong
