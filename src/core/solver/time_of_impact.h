// When balls of the solver will meet each other, or a shape, on the paths that they have within the step.
#pragma once

#include "ping_pong_sim/ball.h"
#include "solver/solver_state.h"

namespace ping_pong
{
/// On its path, at time t from the start of the step.
inline Vector3d placeAt(const ContactSolver& solver, std::size_t i, double t)
{
  return solver.movers[i].p + t * (solver.movers[i].v + (0.5 * t) * solver.pathAcceleration(i));
}

inline Vector3d velocityAt(const ContactSolver& solver, std::size_t i, double t)
{
  return solver.movers[i].v + t * solver.pathAcceleration(i);
}

/// The same with its spin; orientations are not told.
inline BallState stateAt(const ContactSolver& solver, std::size_t i, double t)
{
  BallState state;
  state.p_WB = placeAt(solver, i, t);
  state.v_WB = velocityAt(solver, i, t);
  state.w_WB = solver.w[i];
  return state;
}

/// Time of the impact of two balls in this step, or kNever. Where both are under the same acceleration, their relative path is
/// a line. Most pairs part, or are too far from each other: they are told by products alone.
double pairImpact(const ContactSolver& solver, const NeighbourPair& pair);

/// The same for a ball and a shape.
double bodyImpact(const WorldWithSolver& world, const BodyNeighbour& neighbour);
}  // namespace ping_pong
