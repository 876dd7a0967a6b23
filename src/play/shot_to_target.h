// How a ball has to leave the racket to land on a target: shooting on the flight of the core.
#pragma once

#include <functional>
#include <optional>

#include "arc.h"

namespace ping_pong::play
{
/// Where a ball shall land and how. Frame O of the player who strikes.
struct ShotWish
{
  Vector3d target = Vector3d::Zero();  ///< the centre when it lands [m]: its z is the radius on a table at z = 0
  double flight_time = 0.4;            ///< from the racket to there; longer where the clearance asks for it [s]
  double longest_time = 1.0;           ///< [s]
  double least_over_net = 0.0;         ///< height of the centre above the net, from z = 0 [m]
  double least_over_edge = 0.0;        ///< height of the centre above the own end line, from z = 0 [m]
};

/// Spin that the ball has if it leaves with this velocity [rad/s].
using SpinOf = std::function<Vector3d(const Vector3d& v_out)>;

struct AimedShot
{
  BallState out;  ///< as it leaves the racket
  Arc arc;
  Vector3d second_landing = Vector3d::Zero();  ///< of a serve: on the other half [m]
};

/// Velocity with which the ball flies from p to the target in the wished time: Broyden's method ("A class of methods for solving nonlinear
/// simultaneous equations", Math. Comp. 19, 577, 1965) on the landing point and time. Where the arc is too low over net or edge, flight time
/// goes up step by step. Bounded work.
/// @param guess  velocity to begin with; zero: the parabola
/// @return       landing within 1e-6 m and 1e-6 s, or nothing
std::optional<AimedShot> shotToTarget(const Flyer& flyer, const Vector3d& p, const SpinOf& spin, const ShotWish& wish,
                                      const Vector3d& guess = Vector3d::Zero());

/// A serve: lands first at x = own_bounce on the own half, then on the target.
struct ServeWish
{
  Vector3d target = Vector3d::Zero();  ///< the centre when it lands on the other half [m]
  double own_bounce = -0.8;            ///< x of the first landing [m]
  double speed_guess = 5.0;            ///< along x [m/s]; it picks one of the solutions
  double least_over_net = 0.0;         ///< height of the centre above the net, from z = 0 [m]
};

/// How a ball leaves the table. The state is changed from before the bounce to after it.
using TableBounce = std::function<void(BallState&)>;

std::optional<AimedShot> serveToTarget(const Flyer& flyer, const Vector3d& p, const SpinOf& spin,
                                       const TableBounce& bounce_off, const ServeWish& wish);
}  // namespace ping_pong::play
