// The impact of a ball on several surfaces at once, which ends a long row of quick contacts.
#pragma once

#include "state/world_state.h"

namespace ping_pong
{
/// Impacts that follow each other between surfaces that the ball touches, each of which undoes a part of the one before, come
/// to their end after infinitely many: together they are one impact without rebound on all of them. Lists a contact for
/// each surface that is struck. What it touches are its supports from then on.
/// @param event  the impact that is due at time t
/// @param state  of the ball i before; changed to what it is after
/// @return  false if it touches nothing else, or the impact has no answer; nothing is changed then
bool strikeAllTouched(WorldState& world, Records& records, std::size_t i, const Event& event, double t,
                      BallState& state);
}  // namespace ping_pong
