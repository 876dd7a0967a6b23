// Resolve: velocities before a contact to velocities after it.
#pragma once

#include <optional>

#include "ping_pong_sim/scene.h"

namespace ping_pong
{
/// Impact of a ball on an infinitely heavy surface. With the slip u = v + w x (-r n) - u_WC of the touching point,
///   J_n = -(1 + e(u_n)) m u_n,
///   J_t = -(1 + e_t) m k/(1 + k) u_t, grip; at most mu J_n, slide (Garwin 1969; Nakashima et al. 2010),
///   v' = v + (J_n n + J_t)/m, w' = w - r n x J_t / (k m r^2).
/// Unchanged if the ball moves away.
/// @param u_WC  velocity of the touched point of the surface [m/s]
/// @param n_W   unit normal, from the surface to the ball
/// @return      impulse on the ball [N s]
Vector3d bounce(const Surface& law, const BallParams& ball, BallState& state, const Vector3d& u_WC,
                const Vector3d& n_W);

/// The inverse of bounce(): how fast the touched point has to move so that the ball receives this impulse.
/// @param before  the ball as it comes
/// @param J_W     wanted impulse on the ball, expressed in W [N s]
/// @return        u_WC [m/s]; of all that would do where the contact slides, the one with the least slip. Nothing if no surface does:
///                J_W pulls on the ball, or asks for more friction than there is (|J_t| > mu J_n, or e_t = -1).
std::optional<Vector3d> surfaceVelocityFor(const Surface& law, const BallParams& ball, const BallState& before,
                                           const Vector3d& J_W, const Vector3d& n_W);

/// Impact of two balls: the same with m12 = m1 m2/(m1 + m2) for the normal, and 1 / sum((1 + 1/k_i)/m_i) for the slip.
/// @param n_W  unit normal, from ball 2 to ball 1
/// @param speed  normal speed of separation after it, by the law e times the closing speed [m/s]
/// @return     impulse on ball 1 [N s]
Vector3d part(const Surface& law, double speed, const BallParams& ball1, BallState& state1, const BallParams& ball2,
              BallState& state2, const Vector3d& n_W);
}  // namespace ping_pong
