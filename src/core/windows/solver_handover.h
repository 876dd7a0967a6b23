// The hand-off of balls from the exact method to the contact solver and back: events without end are stepped over.
//
// A ball that meets others too often, in contacts that lose speed, goes to the solver; so does one that may meet a ball there
// within a window, at the start of the window. A ball that has touched no other for a while and has none near goes back. A
// scene in which no ball is handed off is not changed by a bit. The rule and what it costs: docs/crowds.md.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
/// More events in one window hand these balls off, if all of them can lose speed to each other.
std::size_t mostEvents(const WorldWithWindows& world, const std::vector<std::size_t>& balls);

/// These balls go to the solver where they are at time t.
void handToSolver(WorldWithWindows& world, const std::vector<std::uint32_t>& balls, double t);

/// End of the next window, which starts at `start`: short while balls of the solver are awake.
double endOfWindow(const WorldWithWindows& world, double start, double end);

/// Balls that may meet a ball of the solver in this window go to it.
void handNeighboursToSolver(WorldWithWindows& world, double start, double end);

/// Steps the solver through the window, gives back balls that touch no other, and takes in those that meet others too often.
/// @param smooth_until  the motions of all paddles are smooth until then [s]
void moveSolver(WorldWithWindows& world, double start, double end, double smooth_until);

/// A ball goes back to the exact method where it is at time t.
void takeFromSolver(WorldWithWindows& world, std::uint32_t ball, double t, double smooth_until);
}  // namespace ping_pong
