// From what a ball should do to what the racket has to do: the contact law of the core, inverted.
#pragma once

#include <optional>

#include "ping_pong_sim/resolve.h"

namespace ping_pong::play
{
/// A racket at the instant of impact; it does not turn.
struct RacketImpact
{
  Vector3d n_W = Vector3d::UnitX();   ///< unit normal of the face that strikes, towards the ball
  Vector3d v_WP = Vector3d::Zero();   ///< velocity of the racket [m/s]
  Vector3d w_out = Vector3d::Zero();  ///< spin of the ball after it [rad/s]
};

/// How far the impulse may lean from the normal [rad]: beyond, a stroke only grazes the ball and any error becomes large.
constexpr double kMostLean = 1.25;

/// Spin after an impact that changes the velocity from `before` to v_out: as near to w_wanted as friction and kMostLean allow.
/// An impulse J changes the spin by -(r/I) n x J, which is across J and no longer than r |J| sin(lean)/I: the part of the wanted change along J
/// is out of reach, the rest is cut where the lean ends.
Vector3d reachableSpin(const Surface& law, const BallParams& ball, const BallState& before, const Vector3d& v_out,
                       const Vector3d& w_wanted);

/// The racket that gives the ball v_out and reachableSpin(). The angle between n and J = m (v_out - v) is
/// asin(I |dw| / (r |J|)), towards dw x J; the racket's velocity follows from surfaceVelocityFor(). bounce() with it gives v_out and w_out up to
/// rounding.
/// @return  nothing if J is zero or no surface gives it
std::optional<RacketImpact> invertStroke(const Surface& law, const BallParams& ball, const BallState& before,
                                         const Vector3d& v_out, const Vector3d& w_wanted);
}  // namespace ping_pong::play
