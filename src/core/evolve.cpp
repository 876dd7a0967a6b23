#include "ping_pong_sim/evolve.h"

#include <cmath>

namespace ping_pong
{
Vector3d freeAcceleration(const Forces& forces)
{
  return forces.gravity;
}

Segment fly(const BallState& state, double start, const Forces& forces)
{
  Segment path;
  path.start = start;
  path.degree = 2;
  path.c[0] = state.p_WB;
  path.c[1] = state.v_WB;
  path.c[2] = 0.5 * freeAcceleration(forces);
  path.q_WB = state.q_WB;
  path.w_WB = state.w_WB;
  return path;
}

void stepExplicit(BallState& state, const Forces& forces, double h)
{
  state.p_WB += state.v_WB * h;
  state.v_WB += freeAcceleration(forces) * h;
  state.q_WB = turned(state.q_WB, state.w_WB, h);
}

void stepSemiImplicit(BallState& state, const Forces& forces, double h)
{
  state.v_WB += freeAcceleration(forces) * h;
  state.p_WB += state.v_WB * h;
  state.q_WB = turned(state.q_WB, state.w_WB, h);
}

Quaterniond turned(const Quaterniond& q, const Vector3d& w, double s)
{
  const double speed = w.norm();
  if (speed == 0.0 || s == 0.0) return q;
  const Vector3d axis = w / speed;
  const double half = 0.5 * speed * s;
  const Quaterniond turn(std::cos(half), std::sin(half) * axis.x(), std::sin(half) * axis.y(),
                         std::sin(half) * axis.z());
  return (turn * q).normalized();
}
}  // namespace ping_pong
