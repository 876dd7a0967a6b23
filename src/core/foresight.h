// Detect, for the exact method: the next event of every ball.
#pragma once

#include "world_state.h"

namespace ping_pong
{
/// Finds ball i's next event with still bodies and with balls from time t on, and tells the partners it finds.
void foresee(WorldState& world, std::size_t i, double t);

/// Finds ball i's next event with moving bodies in [t, window_end].
void foreseeMoving(WorldState& world, std::size_t i, double t, double window_end);

/// False if the other has changed its path or pose since the event was foreseen.
bool stillTrue(const WorldState& world, const Event& event);
}  // namespace ping_pong
