// Detect, for the exact method: the next event of every ball.
#pragma once

#include "state/world_state.h"

namespace ping_pong
{
/// A ball that meets nothing looks again after so long: it bounds the work of a search into empty space [s].
constexpr double kHorizon = 4.0;

/// Boxes that come so near are taken to overlap, whatever rounding says [m].
constexpr double kSlack = 1e-9;

/// Finds ball i's next event with still bodies from time t on.
void predictStill(WorldState& world, std::size_t i, double t);

/// Finds ball i's next event with moving bodies in [t, window_end].
void predictMoving(WorldState& world, std::size_t i, double t, double window_end);

/// Looks whether ball i meets ball k up to window_end, before it meets another one, and tells both. The search begins where
/// the later of the two paths does, and takes the balls in the order of the list: its answer is the same bits in any window.
/// @param resume  begin no earlier than this: where a search was cut short [s]
void predictBall(WorldState& world, std::size_t i, std::size_t k, double resume, double window_end, Records& records);

/// False if the other has changed its path or pose since the event was predicted.
bool stillTrue(const WorldState& world, const Event& event);
}  // namespace ping_pong
