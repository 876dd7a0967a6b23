// All balls in few bytes.
#pragma once

#include "ping_pong_sim/Crowd.h"
#include "ros/simulation/simulation.h"

namespace ping_pong_sim
{
/// Fills a message that may be used again and again.
void fillCrowd(const Simulation& simulation, Crowd& message);
}  // namespace ping_pong_sim
