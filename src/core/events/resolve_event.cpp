#include "events/resolve_event.h"

#include <cmath>

#include "detect/conservative_advancement.h"
#include "ping_pong_sim/resolve.h"
#include "resting/joint_impact.h"
#include "resting/plan_path.h"
#include "state/body_gap.h"
#include "state/collapse_guard.h"
#include "state/contact_log.h"
#include "state/hand_off_rule.h"
#include "state/squeeze.h"

namespace ping_pong
{
namespace
{
// Room that is left to a squeezed ball: no paddle goes farther between two contacts that count as all but simultaneous [m].
constexpr double kSqueezeGap = 2e-5;
constexpr double kOpposed = -0.999;  // cosine between normals of squeezing surfaces

// --- squeezed balls ---

// Touching a second surface that comes against the first: there is no way out but through one of them.
bool squeezedBetween(const WorldState& world, const BallRecord& ball, const BallState& state, const Gap& first,
                     const Vector3d& u_first, double t)
{
  for (const BodyRecord& body : world.bodies)
  {
    const BodyFrame frame = body.at(t);
    for (const Shape& shape : body.shapes())
    {
      const Gap other = gapTo(shape, frame, state.p_WB, state.v_WB, ball.params().radius);
      if (other.gap > kSqueezeGap || other.n_W.dot(first.n_W) > kOpposed) continue;
      const Vector3d u_other = frame.pointVelocity(state.p_WB - ball.params().radius * other.n_W);
      if (first.n_W.dot(u_first - u_other) > 0.0) return true;
    }
  }
  return false;
}

// --- impacts ---

// After a bounce: if all bounces to come are too small to count, the ball lies on the surface from now on.
void comeToRest(const WorldState& world, BallRecord& ball, const Event& event, const Surface& law,
                const BodyFrame& frame, BallState& state, double closing, double leaving, double t)
{
  if (leaving > kSurelyBounces) return;
  const BodyRecord& body = world.bodies[event.other];
  const Shape& shape = body.shapes()[event.shape];
  const Vector3d a = accelerationOnSupports(world, ball, state, t);
  const double press = -gapAcceleration(shape, frame, state.p_WB, state.v_WB, a);
  const Gap gap = gapTo(shape, frame, state.p_WB, state.v_WB, ball.params().radius);
  const bool pressed = closing <= kNoClosingSpeed;  // on it, without an impact
  const bool ends = pressed || bouncingEnds(gap.rate, press, touchTolerance(state.p_WB, ball.params().radius));
  // Surfaces that throw a ball at each other without end take it in the end: what is lost is below rounding of a rally.
  if (!ends && !(ball.quick_contacts > kManyQuick && gap.rate < kNoReboundSpeed)) return;
  ball.supports.add(event.other, event.shape);
  addTouched(world, ball, state, t);
  ball.supports.setSince(t +
                         (press > 0.0 ? timeOfRemainingBounces(std::max(gap.rate, 0.0), press, law.restitution) : 0.0));
  state.v_WB -= gap.rate * gap.n_W;
  state.p_WB -= gap.gap * gap.n_W;
}

// Where contacts are all but simultaneous a moving surface takes the ball along and does not throw it: no pumping up between
// paddle and table.
Surface lawOf(const WorldState& world, const BallRecord& ball, const BodyRecord& body, const Shape& shape)
{
  Surface law = world.surface(ball, shape);
  if (ball.instant_contacts > kManyQuick && body.moving) law.restitution = 0.0;
  return law;
}

void hitBody(WorldState& world, const Window& window, DueEvent& due)
{
  const std::size_t i = due.balls[0];
  const Event& event = due.event;
  const double t = event.time;
  BallRecord& ball = world.balls[i];
  const BodyRecord& body = world.bodies[event.other];
  const Shape& shape = body.shapes()[event.shape];
  const BodyFrame frame = body.moving ? frameAt(body.motion, t - body.motion.start) : BodyFrame();
  BallState& state = due.states[0];
  const Gap gap = gapOver(body, shape, state, ball.params().radius, t);
  const Vector3d u = body.moving ? frame.pointVelocity(state.p_WB - ball.params().radius * gap.n_W) : Vector3d::Zero();
  countCollapse(ball, t);
  if ((ball.instant_contacts > kHopelessInstants && body.moving) ||
      (ball.instant_contacts > kManyQuick && squeezedBetween(world, ball, state, gap, u, t)))
  {
    due.count = 0;
    return squeeze(*window.records, ball, state, t);
  }
  const Surface law = lawOf(world, ball, body, shape);
  // Surfaces that throw the ball at each other without end: it strikes all that it touches at once.
  if (ball.quick_contacts > kManyQuick && law.restitutionAt(-gap.rate) < 1.0 &&
      strikeAllTouched(world, *window.records, i, event, t, state))
    return;
  const BallState before = state;
  bounce(law, ball.params(), state, u, gap.n_W);
  if (worthAReport(ball, -gap.rate))
    recordContact(*window.records, ball, i, HitObject::shapeOf(event.other, event.shape),
                  {t, gap.n_W, u, before.p_WB, before.v_WB, state.v_WB, before.w_WB, state.w_WB,
                   impulseOf(ball, before.v_WB, state.v_WB)});
  comeToRest(world, ball, event, law, frame, state, -gap.rate, gap.n_W.dot(state.v_WB - u), t);
}

// Speed of separation of two balls after they met with this closing speed. Where forces press them together, the end of a
// collapse is a small separation; else it is an elastic impact.
double separationSpeed(const BallRecord& a, const BallRecord& b, double closing, double restitution, bool pressed)
{
  if (closing <= kTouchSpeed) return pressed ? kResidualSeparation : std::max(closing, 0.0);
  if (std::min(a.quick_contacts, b.quick_contacts) <= kManyQuick) return restitution * closing;
  return pressed ? std::max(closing, kResidualSeparation) : closing;
}

void hitBall(WorldState& world, const Window& window, DueEvent& due)
{
  const auto [i, k] = due.balls;
  BallRecord& a = world.balls[i];
  BallRecord& b = world.balls[k];
  const double t = due.event.time;
  if (window.log) window.log->met(i, k);
  BallState &state_a = due.states[0], &state_b = due.states[1];
  const Vector3d n = (state_a.p_WB - state_b.p_WB).normalized();
  const double closing = -n.dot(state_a.v_WB - state_b.v_WB);
  countCollapse(a, t);
  countCollapse(b, t);
  const Surface& law = world.surface(a, b);
  const Vector3d pull = a.path.acceleration(t - a.path.start) - b.path.acceleration(t - b.path.start);
  if (law.restitutionAt(closing) < 1.0)
    for (BallRecord* ball : {&a, &b}) window.records->frequent_contacts |= countFrequent(*ball, t);
  const double speed = separationSpeed(a, b, closing, law.restitutionAt(closing), n.dot(pull) < 0.0);
  const BallState before_a = state_a;
  const Vector3d p_WC = state_a.p_WB - a.params().radius * n;
  const Vector3d v_other = state_b.v_WB + state_b.w_WB.cross(p_WC - state_b.p_WB);
  const Vector3d impulse = part(law, speed, a.params(), state_a, b.params(), state_b, n);
  if (worthAReport(a, closing))
    recordContact(*window.records, a, i, HitObject::ballOf(b.id),
                  {t, n, v_other, before_a.p_WB, before_a.v_WB, state_a.v_WB, before_a.w_WB, state_a.w_WB, impulse});
}
}  // namespace

void resolve(WorldState& world, const Window& window, DueEvent& due)
{
  switch (due.event.kind)
  {
    case Event::Kind::HitBody:
      return hitBody(world, window, due);
    case Event::Kind::HitBall:
      return hitBall(world, window, due);
    case Event::Kind::LeaveFace:
    case Event::Kind::Horizon:
    case Event::Kind::None:
      return;
  }
}
}  // namespace ping_pong
