// Shows a world to an umpire, tick by tick.
#pragma once

#include "game/umpire.h"

namespace ping_pong::game
{
/// Tells the umpire all that the last advance() of the world did: contacts, rackets at the net, a table that was moved, the ball in
/// play, the time. A ball in play that is no longer there makes a let. To be called after each advance(); the world is that of
/// the scene in which the court was found, and keeps its contacts.
void observe(const World& world, Umpire& umpire);
}  // namespace ping_pong::game
