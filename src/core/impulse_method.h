// The method `impulse`: every ball is in the contact solver, in steps of scene.dt.
#pragma once

#include "world_state.h"

namespace ping_pong
{
/// See MethodFunctions.
void reserveImpulse(WorldState& world, std::size_t balls);
void startImpulse(WorldState& world);
void impulseBallChanged(WorldState& world, std::size_t ball);
void runImpulse(WorldState& world, double end);
}  // namespace ping_pong
