// Resolve: velocities before a contact to velocities after it.
#pragma once

#include "ping_pong_sim/scene.h"

namespace ping_pong
{
/// Velocity of a ball after a smooth impact on an infinitely heavy surface.
/// v' = v - (1 + e) (n.(v - u)) n, that is v'_n - u_n = -e (v_n - u_n); unchanged if it moves away.
/// @param u_WC  velocity of the touched point of the surface [m/s]
/// @param n_W   unit normal, from the surface to the ball
Vector3d bounce(const Surface& law, const Vector3d& v_WB, const Vector3d& u_WC, const Vector3d& n_W);

/// Impulse on ball 1 [N s] in a smooth impact of two balls: m12 (1 + e) (closing speed) along n, m12 = m1 m2 / (m1 + m2).
/// @param n_W  unit normal, from ball 2 to ball 1
Vector3d impulseBetween(const Surface& law, double m1, const Vector3d& v1, double m2, const Vector3d& v2,
                        const Vector3d& n_W);
}  // namespace ping_pong
