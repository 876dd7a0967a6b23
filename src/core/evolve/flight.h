// Evolve: move a ball through the air for a while, no contacts.
#pragma once

#include "evolve/segment.h"
#include "ping_pong_sim/scene.h"

namespace ping_pong
{
/// Closed-form flight under a constant acceleration from `state` at time `start`: p0 + v0 s + a s^2 / 2.
Segment flyParabola(const BallState& state, double start, const Vector3d& a);

/// Degree of the pieces of flight through air that is the cheapest at this tolerance, see fly() [m]: the smaller the error
/// has to be, the more it pays to have more points.
constexpr int pieceDegree(double tolerance)
{
  return tolerance > 3e-6 ? 5 : tolerance > 1e-9 ? 7 : 9;
}

/// Flight under the model's forces: a parabola if its acceleration is constant; else one polynomial piece by collocation at
/// Gauss-Legendre points (Hairer, Norsett, Wanner, "Solving ODEs I", II.7), as long as its error allows.
/// @param tolerance  error of the position that the piece may leave after a second [m]
/// @param path       in: any; if its higher coefficients know the length of the next piece, that is what is tried first
void fly(const BallState& state, double start, const FlightModel& model, double tolerance, Segment& path);

/// Orientation after turning with constant spin w (in W) for s [s].
Quaterniond turned(const Quaterniond& q, const Vector3d& w, double s);
}  // namespace ping_pong
