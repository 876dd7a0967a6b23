#include "evolve/integrators.h"

#include "evolve/flight.h"

namespace ping_pong
{
void stepRk4(Flight& ball, const FlightModel& model, double h)
{
  const Vector3d v = ball.v;
  const Vector3d w_half = slowed(ball.w, model, 0.5 * h);
  const Vector3d a1 = model.acceleration(v, ball.w);
  ball.w = slowed(ball.w, model, h);
  if (model.constant())
  {
    ball.p += h * (v + 0.5 * h * a1);
    ball.v += h * a1;
    return;
  }
  const Vector3d a2 = model.acceleration(v + 0.5 * h * a1, w_half);
  const Vector3d a3 = model.acceleration(v + 0.5 * h * a2, w_half);
  const Vector3d a4 = model.acceleration(v + h * a3, ball.w);
  ball.p += h * (v + h / 6.0 * (a1 + a2 + a3));
  ball.v += h / 6.0 * (a1 + 2.0 * (a2 + a3) + a4);
}

Segment flyRk4(const BallState& state, double start, const FlightModel& model, double h)
{
  const Vector3d a = model.acceleration(state.v_WB, state.w_WB);
  Segment path = flyParabola(state, start, a);
  path.end = start + h;
  if (model.spinDecay() != 0.0) path.higher.make().spin_decay = model.spinDecay();
  if (model.constant()) return path;
  Flight end{state.p_WB, state.v_WB, state.w_WB};
  stepRk4(end, model, h);
  const Vector3d p = end.p - path.position(h);        // what the parabola misses: c3 h^3 + c4 h^4
  const Vector3d v = h * (end.v - path.velocity(h));  // 3 c3 h^3 + 4 c4 h^4
  path.degree = 4;
  HigherCoefficients& higher = path.higher.make();
  higher.c[0] = (4.0 * p - v) / (h * h * h);
  higher.c[1] = (v - 3.0 * p) / (h * h * h * h);
  path.boundAcceleration();
  return path;
}

Vector3d turnIn(const Vector3d& w_WB, double spin_decay, double h)
{
  if (spin_decay == 0.0) return h * w_WB;
  count(Law::SpinDecay);
  return -std::expm1(-spin_decay * h) / spin_decay * w_WB;
}
}  // namespace ping_pong
