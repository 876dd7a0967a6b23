#include "state/squeeze.h"

#include "evolve/flight.h"

namespace ping_pong
{
void squeeze(Records& records, BallRecord& ball, BallState state, double t)
{
  records.any_squeezed = true;
  ball.owner = ball.ofSolver() ? BallOwner::NobodyOfSolver : BallOwner::Nobody;
  ball.supports = Supports();
  ball.expectNothing();
  ++ball.version;
  state.v_WB.setZero();
  ball.path = flyParabola(state, t, Vector3d::Zero());
}
}  // namespace ping_pong
