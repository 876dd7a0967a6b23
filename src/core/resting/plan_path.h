// Contact mode of the exact method: from bouncing to lying on a surface, and the path on it.
#pragma once

#include <algorithm>

#include "state/world_state.h"

namespace ping_pong
{
inline constexpr double kLift = 1e-12;             ///< height of bounces that no longer count [m]
inline constexpr double kLiftInTolerances = 32.0;  ///< or this many touch tolerances, far from the origin

/// Decides when bouncing has ended: all bounces still to come, taken together, lift the ball by less than 1e-12 m. Their
/// time is summed in closed form: no bounce is lost from the clock. Far from the origin, where coordinates are coarser, the
/// height is 32 touch tolerances.
/// @param rate  speed away from the surface after the bounce [m/s]
/// @param press  acceleration into the surface, > 0 [m/s^2]
inline bool bouncingEnds(double rate, double press, double touch_tolerance)
{
  if (press <= 0.0) return false;
  const double lift = std::max(kLift, kLiftInTolerances * touch_tolerance);
  return rate <= kNoSeparationSpeed || rate * rate < 2.0 * press * lift;
}

/// Time of all bounces to come: flights 2 v/a with v falling by e each time, 2 v / (a (1 - e)) [s]; 0 for e = 1, where
/// it would never end.
double timeOfRemainingBounces(double rate, double press, double restitution);

constexpr double kSurelyBounces = 1.0;  ///< leaving faster than this, no force ends the bouncing [m/s]
constexpr double kKeepSpeed = 1e-6;     ///< a support is left by moving away faster than this [m/s]

/// Acceleration of a ball on the supports that it still touches: loads, friction and forces together [m/s^2].
Vector3d accelerationOnSupports(const WorldState& world, const BallRecord& ball, const BallState& state, double t);

/// Adds to the supports what the ball touches without closing in and is pressed on by them: all of it holds the ball from the start.
void addTouched(const WorldState& world, BallRecord& ball, const BallState& state, double t);

/// Faces this far apart are one plane [m].
inline double flushTolerance(const Vector3d& p_WB, double radius)
{
  return 1e-11 + 32.0 * touchTolerance(p_WB, radius);
}

/// Plans the path from `state` at time t: drops supports that let go or were left, projects what remains of the velocity
/// into them, and lays a path: in the air; in closed form on flat faces (sliding straight to the end of slip, rolling, lying
/// still); else one polynomial piece. On moving bodies it holds until `window_end` only.
void planPath(const WorldState& world, BallRecord& ball, const BallState& state, double t, double window_end);
}  // namespace ping_pong
