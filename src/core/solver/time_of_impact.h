// When balls of the pile will meet each other, or a shape, on the paths that they have within the step.
#pragma once

#include "ping_pong_sim/ball.h"
#include "solver/solver_state.h"

namespace ping_pong
{
/// On its path, at time t from the start of the step.
inline Vector3d placeAt(const Pile& pile, std::size_t i, double t)
{
  return pile.movers[i].p + t * (pile.movers[i].v + (0.5 * t) * pile.pathAcceleration(i));
}

inline Vector3d velocityAt(const Pile& pile, std::size_t i, double t)
{
  return pile.movers[i].v + t * pile.pathAcceleration(i);
}

/// The same with its spin; orientations are not told.
inline BallState stateAt(const Pile& pile, std::size_t i, double t)
{
  BallState state;
  state.p_WB = placeAt(pile, i, t);
  state.v_WB = velocityAt(pile, i, t);
  state.w_WB = pile.w[i];
  return state;
}

/// Time of the impact of two balls in this step, or kNever. Where both are under the same acceleration, their relative path is
/// a line. Most pairs part, or are too far from each other: they are told by products alone.
double pairImpact(const Pile& pile, const PairLink& link);

/// The same for a ball and a shape.
double bodyImpact(const WorldWithSolver& world, const BodyLink& link);
}  // namespace ping_pong
