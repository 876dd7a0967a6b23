// Evolve by steps of fixed length: the ladder from Euler to Runge-Kutta.
//
// All steps change p_WB, v_WB and w_WB; the orientation is left alone: in the air the spin keeps its direction, so that
// turning has a closed form (turnIn). Spin decays by its closed form, too: no step loses order by it.
#pragma once

#include "ping_pong_sim/forces.h"
#include "ping_pong_sim/segment.h"

namespace ping_pong
{
/// x += v h, then v += a h. First order; gains energy.
void stepExplicit(BallState& state, const FlightModel& model, double h);

/// v += a h, then x += v h. First order.
void stepSemiImplicit(BallState& state, const FlightModel& model, double h);

/// Velocity Verlet: x += v h + a h^2/2, v += (a + a') h/2. Forces that depend on the velocity are asked at v + a h for
/// a' (Heun's method): second order with them, exact and reversible without.
void stepVerlet(BallState& state, const FlightModel& model, double h);

/// Classic Runge-Kutta method (Hairer, Norsett, Wanner, "Solving ODEs I", II.1, table 1.2). Fourth order.
void stepRk4(BallState& state, const FlightModel& model, double h);

/// The same step as a path for every instant of it: the quartic with position and velocity of both ends and the
/// acceleration at the start. (A cubic has to do without the acceleration. Its velocity is of third order, and so is
/// every bounce inside of it.)
Segment flyRk4(const BallState& state, double start, const FlightModel& model, double h);

/// Rotation vector of h seconds in the air from spin w on [rad].
Vector3d turnIn(const Vector3d& w_WB, double spin_decay, double h);
}  // namespace ping_pong
