// The contacts of a window: those that have happened, in their order.
#pragma once

#include "windows/window_state.h"

namespace ping_pong
{
/// While a window runs the first worker writes to the world's own lists: where it is alone, no contact is copied. A second
/// call gives them back.
void lendContacts(WorldWithWindows& world);

/// To be called for each list when a window is done: what has not happened is dropped from it.
void dropVoidContacts(const WorldWithWindows& world, IslandWork& list);

/// What is left is added to the world's list.
void takeContacts(WorldWithWindows& world);

/// By time, ties by ball, from the first one on.
void sortContacts(WorldWithWindows& world, std::size_t first);
}  // namespace ping_pong
