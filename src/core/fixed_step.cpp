#include "fixed_step.h"

#include <cmath>

#include "ping_pong_sim/resolve.h"

namespace ping_pong
{
namespace
{
bool finite(const BallState& state)
{
  return state.p_WB.allFinite() && state.v_WB.allFinite();
}

void record(WorldState& world, Contact contact, const BallRecord& ball, double t)
{
  contact.time = t;
  contact.ball = ball.id;
  contact.impulse = ball.params.mass * (contact.v_after - contact.v_before);
  world.contacts.push_back(contact);
  ++world.status.contacts;
}

// Closest point, push out, reflect with loss.
void collideWithBodies(WorldState& world, const BallRecord& ball, BallState& state, double t)
{
  for (std::size_t b = 0; b < world.bodies.size(); ++b)
  {
    const BodyRecord& body = world.bodies[b];
    const BodyFrame frame = frameAt(body.frame(), t - body.frame().start);
    for (std::size_t s = 0; s < body.shapes().size(); ++s)
    {
      const Shape& shape = body.shapes()[s];
      const Gap gap = gapTo(shape, frame, state.p_WB, state.v_WB, ball.params.radius);
      if (gap.gap >= 0.0) continue;
      state.p_WB -= gap.gap * gap.n_W;
      if (gap.rate >= 0.0) continue;
      Contact contact;
      contact.body = b;
      contact.shape = s;
      contact.n_W = gap.n_W;
      contact.p_WC = state.p_WB - ball.params.radius * gap.n_W;
      contact.v_other = frame.pointVelocity(contact.p_WC);
      contact.v_before = state.v_WB;
      contact.w_before = state.w_WB;
      bounce(world.surface(ball, shape), ball.params, state, contact.v_other, gap.n_W);
      contact.v_after = state.v_WB;
      contact.w_after = state.w_WB;
      record(world, contact, ball, t);
    }
  }
}

void collidePair(WorldState& world, const BallRecord& a, BallState& state_a, const BallRecord& b, BallState& state_b,
                 double t)
{
  const Vector3d d = state_a.p_WB - state_b.p_WB;
  const double distance = d.norm();
  const double overlap = a.params.radius + b.params.radius - distance;
  if (overlap <= 0.0) return;
  const Vector3d n = distance > 0.0 ? Vector3d(d / distance) : Vector3d(Vector3d::UnitZ());
  const double share = b.params.mass / (a.params.mass + b.params.mass);  // the lighter ball gives way further
  state_a.p_WB += share * overlap * n;
  state_b.p_WB -= (1.0 - share) * overlap * n;
  const double closing = -n.dot(state_a.v_WB - state_b.v_WB);
  if (closing <= 0.0) return;
  Contact contact;
  contact.with_ball = true;
  contact.other_ball = b.id;
  contact.n_W = n;
  contact.p_WC = state_a.p_WB - a.params.radius * n;
  contact.v_other = state_b.v_WB + state_b.w_WB.cross(contact.p_WC - state_b.p_WB);
  contact.v_before = state_a.v_WB;
  contact.w_before = state_a.w_WB;
  const Surface& law = world.surface(a, b);
  part(law, law.restitutionAt(closing) * closing, a.params, state_a, b.params, state_b, n);
  contact.v_after = state_a.v_WB;
  contact.w_after = state_a.w_WB;
  record(world, contact, a, t);
}

// The path of a sampled ball is a straight line from its last state; only its start is ever read.
void store(WorldState& world, BallRecord& ball, const BallState& state, double t)
{
  if (finite(state))
    ball.path = flyParabola(state, t, Vector3d::Zero());
  else
    world.status.not_finite = true;
  ball.path.start = t;
}

void step(WorldState& world, std::vector<BallState>& states, double from, double h, double to)
{
  const bool semi_implicit = world.scene.method == Method::EulerSemiImplicit;
  for (std::size_t i = 0; i < states.size(); ++i)
  {
    states[i] = world.balls[i].stateAt(from);
    const FlightModel model(world.scene.forces, world.balls[i].params);
    semi_implicit ? stepSemiImplicit(states[i], model, h) : stepExplicit(states[i], model, h);
    collideWithBodies(world, world.balls[i], states[i], to);
  }
  for (std::size_t i = 0; i < states.size(); ++i)
    for (std::size_t k = i + 1; k < states.size(); ++k)
      collidePair(world, world.balls[i], states[i], world.balls[k], states[k], to);
  for (std::size_t i = 0; i < states.size(); ++i) store(world, world.balls[i], states[i], to);
}
}  // namespace

void runFixedStep(WorldState& world, double end)
{
  std::vector<BallState> states(world.balls.size());
  const double duration = end - world.time;
  const long count = std::max(1L, std::lround(std::ceil(duration / world.scene.dt - 1e-9)));
  double from = world.time;
  for (long i = 1; i <= count; ++i)
  {
    const double to = i == count ? end : world.time + duration * static_cast<double>(i) / static_cast<double>(count);
    step(world, states, from, duration / static_cast<double>(count), to);
    from = to;
  }
}
}  // namespace ping_pong
