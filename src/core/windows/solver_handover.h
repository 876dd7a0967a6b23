// Passing balls between the exact method and the pile: events that follow each other without end are stepped over.
//
// A ball that meets others too often, in contacts that lose speed, joins the pile; so does whoever may meet a ball of the pile
// within a window, at the start of the window. A ball that has touched no other for a while and has nobody near goes back. A
// scene in which no ball joins is not changed by a bit. The rule and what it costs: docs/crowds.md.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
/// So many events in one window are crowded for these balls, if all of them can lose speed to each other.
std::size_t mostEvents(const WorldWithWindows& world, const std::vector<std::size_t>& balls);

/// These balls join the pile where they are at time t.
void passOn(WorldWithWindows& world, const std::vector<std::uint32_t>& balls, double t);

/// End of the next window, which starts at `start`: short while balls of the pile are awake.
double endOfWindow(const WorldWithWindows& world, double start, double end);

/// Balls that may meet a ball of the pile in this window join it.
void joinPile(WorldWithWindows& world, double start, double end);

/// Steps the pile through the window, lets go whom nobody touches any more, and takes in who has met others too often.
/// @param smooth_until  the motions of all paddles are smooth until then [s]
void movePile(WorldWithWindows& world, double start, double end, double smooth_until);

/// A ball goes back to the exact method where it is at time t.
void leavePile(WorldWithWindows& world, std::uint32_t ball, double t, double smooth_until);
}  // namespace ping_pong
