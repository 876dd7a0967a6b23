// A tray that balls fall into, as wide as their number needs: they come to rest ten layers deep.
#pragma once

#include "ping_pong_sim/scene.h"

namespace ping_pong::bench
{
/// Inside of the tray of so many balls, its height along z; the middle of its bottom is the origin [m].
Vector3d traySize(std::size_t balls);

/// Balls of 40 mm with e = 0.8 and mu = 0.3, on a grid with jitter and small velocities of their own, 0.1 m above the bottom
/// and higher: the same for the same number.
Scene trayScene(std::size_t balls);
}  // namespace ping_pong::bench
