#include "events/event_loop.h"

#include <cmath>

#include "detect/conservative_advancement.h"
#include "events/bounce_run.h"
#include "events/predict.h"
#include "evolve/flight.h"
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
constexpr double kSqueezeGap = 2e-5;  // room left to a ball that counts as squeezed [m]
constexpr double kOpposed = -0.999;   // cosine between normals of squeezing surfaces
constexpr std::size_t kEventsPerAdvance = 1000000;
constexpr std::size_t kEventsPerBall = 10000;

constexpr double kFromTheStart = -kNever;

void predictBalls(WorldState& world, const Window& window, std::size_t i, double resume = kFromTheStart)
{
  if (world.balls[i].transient) world.balls[i].transient->ball = Event();
  for (std::size_t m = 0; m < window.count; ++m)
    if (window.members[m] != i) predictBall(world, i, window.members[m], resume, window.end, *window.records);
}

void predictBodies(WorldState& world, const Window& window, std::size_t i, double t)
{
  predictStill(world, i, t);
  if (world.any_moving) predictMoving(world, i, t, window.smooth_until);
}

void predictAll(WorldState& world, const Window& window, std::size_t i, double t)
{
  predictBodies(world, window, i, t);
  if (window.count > 1) predictBalls(world, window, i);
}

void changePath(WorldState& world, const Window& window, std::size_t i, const BallState& state, double t)
{
  BallRecord& ball = world.balls[i];
  if (window.log) window.log->leavesPath(i, t);
  planPath(world, ball, state, t, window.smooth_until);
}

void restart(WorldState& world, const Window& window, std::size_t i, const BallState& state, double t)
{
  changePath(world, window, i, state, t);
  predictAll(world, window, i, t);
}

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

// --- resolve ---

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

// In a collapse, too quick for a rebound, a moving surface takes the ball along and does not throw it: no pumping up between paddle and table.
Surface lawOf(const WorldState& world, const BallRecord& ball, const BodyRecord& body, const Shape& shape)
{
  Surface law = world.surface(ball, shape);
  if (ball.instant_contacts > kManyQuick && body.moving) law.restitution = 0.0;
  return law;
}

// Surfaces that throw the ball at each other without end: it strikes all that it touches at once.
bool strikeTogether(WorldState& world, const Window& window, std::size_t i, const Event& event, double t)
{
  BallState state = world.balls[i].stateAt(t);
  if (!strikeAllTouched(world, *window.records, i, event, t, state)) return false;
  restart(world, window, i, state, t);
  return true;
}

void hitBody(WorldState& world, const Window& window, std::size_t i, const Event& event, double t)
{
  BallRecord& ball = world.balls[i];
  const BodyRecord& body = world.bodies[event.other];
  const Shape& shape = body.shapes()[event.shape];
  const BodyFrame frame = body.moving ? frameAt(body.motion, t - body.motion.start) : BodyFrame();
  BallState state = ball.stateAt(t);
  const Gap gap = gapOver(body, shape, state, ball.params().radius, t);
  const Vector3d u = body.moving ? frame.pointVelocity(state.p_WB - ball.params().radius * gap.n_W) : Vector3d::Zero();
  countCollapse(ball, t);
  if ((ball.instant_contacts > kHopelessInstants && body.moving) ||
      (ball.instant_contacts > kManyQuick && squeezedBetween(world, ball, state, gap, u, t)))
    return squeeze(*window.records, ball, state, t);
  const Surface law = lawOf(world, ball, body, shape);
  if (ball.quick_contacts > kManyQuick && law.restitutionAt(-gap.rate) < 1.0 &&
      strikeTogether(world, window, i, event, t))
    return;
  const BallState before = state;
  bounce(law, ball.params(), state, u, gap.n_W);
  if (worthAReport(ball, -gap.rate))
    recordContact(*window.records, ball, i, HitObject::shapeOf(event.other, event.shape),
                  {t, gap.n_W, u, before.p_WB, before.v_WB, state.v_WB, before.w_WB, state.w_WB,
                   impulseOf(ball, before.v_WB, state.v_WB)});
  comeToRest(world, ball, event, law, frame, state, -gap.rate, gap.n_W.dot(state.v_WB - u), t);
  restart(world, window, i, state, t);
}

// Speed of separation of two balls after they met with this closing speed. Where forces press them together, the end of a
// collapse is a small separation; else it is an elastic impact.
double separationSpeed(const BallRecord& a, const BallRecord& b, double closing, double restitution, bool pressed)
{
  if (closing <= kTouchSpeed) return pressed ? kResidualSeparation : std::max(closing, 0.0);
  if (std::min(a.quick_contacts, b.quick_contacts) <= kManyQuick) return restitution * closing;
  return pressed ? std::max(closing, kResidualSeparation) : closing;
}

void hitBall(WorldState& world, const Window& window, std::size_t i, std::size_t k, double t)
{
  BallRecord& a = world.balls[i];
  BallRecord& b = world.balls[k];
  if (window.log) window.log->met(i, k);
  BallState state_a = a.stateAt(t);
  BallState state_b = b.stateAt(t);
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
  changePath(world, window, i, state_a, t);
  changePath(world, window, k, state_b, t);
  predictAll(world, window, i, t);
  predictAll(world, window, k, t);
}

void handle(WorldState& world, const Window& window, std::size_t i)
{
  BallRecord& ball = world.balls[i];
  if (&nextEvent(ball) == &ball.next && runBounces(world, window, i))
  {
    if (window.count > 1) predictBalls(world, window, i);
    return;
  }
  const Event event = nextEvent(ball);  // a copy: the original goes when the path does
  const bool with_ball = ball.transient && &nextEvent(ball) == &ball.transient->ball;
  const double t = event.time;
  const bool at_horizon = event.kind == Event::Kind::Horizon;
  if (at_horizon || !stillTrue(world, event))
  {
    // Only what is void is looked for anew: the other answer keeps its bits.
    if (with_ball) return predictBalls(world, window, i, at_horizon ? t : kFromTheStart);
    return predictBodies(world, window, i, t);
  }
  switch (event.kind)
  {
    case Event::Kind::HitBody:
      return hitBody(world, window, i, event, t);
    case Event::Kind::HitBall:
      return hitBall(world, window, i, event.other, t);
    case Event::Kind::LeaveFace:
    case Event::Kind::Horizon:
    case Event::Kind::None:
      return restart(world, window, i, world.balls[i].stateAt(t), t);
  }
}

std::size_t earliestBall(const WorldState& world, const Window& window)
{
  std::size_t first = kNone;
  double time = kNever;
  for (std::size_t m = 0; m < window.count; ++m)
  {
    const double its = nextEvent(world.balls[window.members[m]]).time;
    if (its >= time) continue;
    time = its;
    first = window.members[m];
  }
  return first;
}
}  // namespace

bool runTogether(WorldState& world, const Window& window)
{
  StepStatus& status = window.records->status;
  const std::size_t limit = kEventsPerAdvance + kEventsPerBall * world.balls.size();
  const std::size_t last = status.events + limit - std::min(limit, world.status.events);
  std::size_t events = 0;
  for (std::size_t i = earliestBall(world, window); i != kNone; i = earliestBall(world, window))
  {
    if (nextEvent(world.balls[i]).time > window.end) return true;
    if (++events > window.most_events) return false;
    if (++status.events > last)
    {
      status.event_limit = true;
      return true;
    }
    handle(world, window, i);
  }
  return true;
}

}  // namespace ping_pong
