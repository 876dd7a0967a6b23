// Contacts of the pile that carry load, in two parts: which links are in touch, and the impulses in them.
#pragma once

#include "pile_shares.h"

namespace ping_pong
{
/// Lists the links that touch by the end of the step, at the velocities that balls have now.
void gatherTouches(WorldState& world);

/// No contact of this step has acted on the ball yet.
void clearChange(Pile& pile, std::uint32_t ball);

/// A sleeping ball wakes up when the force of an awake one on it changes, comes or goes.
/// @param normal  impulse in this step [N s]
/// @param held    the force when one of them fell asleep [N]
void watch(Pile& pile, PileShare& share, const PairLink& link, float normal, float held);
}  // namespace ping_pong
