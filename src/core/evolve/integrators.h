// Evolve by steps of fixed length: the ladder from Euler to Runge-Kutta.
//
// The orientation is left alone: in the air the spin keeps its direction, so that turning has a closed form (turnIn).
// Spin decays by its closed form, too: no step loses order by it.
#pragma once

#include <cmath>

#include "base/law_counter.h"
#include "evolve/segment.h"
#include "ping_pong_sim/forces.h"

namespace ping_pong
{
/// What a step changes of a ball, expressed in W.
struct Flight
{
  Vector3d p;  ///< [m]
  Vector3d v;  ///< [m/s]
  Vector3d w;  ///< spin [rad/s]
};

/// Spin h seconds later.
inline Vector3d slowed(const Vector3d& w, const FlightModel& model, double h)
{
  if (model.spinDecay() == 0.0) return w;
  count(Law::SpinDecay);
  return std::exp(-model.spinDecay() * h) * w;
}

// The steps are inline: they are short, and taken thousands of times a second for every ball.

/// x += v h, then v += a h. First order; gains energy.
inline void stepExplicit(Flight& ball, const FlightModel& model, double h)
{
  const Vector3d a = model.acceleration(ball.v, ball.w);
  ball.p += h * ball.v;
  ball.v += h * a;
  ball.w = slowed(ball.w, model, h);
}

/// v += a h, then x += v h. First order.
inline void stepSemiImplicit(Flight& ball, const FlightModel& model, double h)
{
  ball.v += h * model.acceleration(ball.v, ball.w);
  ball.p += h * ball.v;
  ball.w = slowed(ball.w, model, h);
}

/// Velocity Verlet: x += v h + a h^2/2, v += (a + a') h/2. Forces that depend on the velocity are asked at v + a h for
/// a' (Heun's method): second order with them, exact and reversible without.
inline void stepVerlet(Flight& ball, const FlightModel& model, double h)
{
  const Vector3d a = model.acceleration(ball.v, ball.w);
  ball.p += h * (ball.v + 0.5 * h * a);
  ball.w = slowed(ball.w, model, h);
  if (model.constant())
    ball.v += h * a;
  else
    ball.v += 0.5 * h * (a + model.acceleration(ball.v + h * a, ball.w));
}

/// Classic Runge-Kutta method (Hairer, Norsett, Wanner, "Solving ODEs I", II.1, table 1.2). Fourth order.
void stepRk4(Flight& ball, const FlightModel& model, double h);

/// The same step as a path for every instant of it: the quartic with position and velocity of both ends and the
/// acceleration at the start. (A cubic has to do without the acceleration. Its velocity is of third order, and so is
/// every bounce inside of it.)
Segment flyRk4(const BallState& state, double start, const FlightModel& model, double h);

/// Rotation vector of h seconds in the air from spin w on [rad].
Vector3d turnIn(const Vector3d& w_WB, double spin_decay, double h);
}  // namespace ping_pong
