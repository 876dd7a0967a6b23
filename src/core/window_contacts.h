// The contacts of a window: those that have happened, in their order.
#pragma once

#include "world_state.h"

namespace ping_pong
{
/// While a window runs the first worker writes to the world's own lists: where it is alone, no contact is copied. A second
/// call gives them back.
void lendContacts(WorldState& world);

/// To be called for each list when a window is done: what has not happened is dropped from it.
void dropVoidContacts(const WorldState& world, IslandWork& list);

/// What is left is added to the world's list.
void takeContacts(WorldState& world);

/// By time, ties by ball, from the first one on.
void sortContacts(WorldState& world, std::size_t first);
}  // namespace ping_pong
