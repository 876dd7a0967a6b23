#include "methods/fixed_step.h"

#include <cmath>

#include "base/law_counter.h"
#include "evolve/flight.h"
#include "evolve/integrators.h"
#include "ping_pong_sim/resolve.h"
#include "state/body_gap.h"
#include "state/contact_log.h"

namespace ping_pong
{
namespace
{
// Between steps a ball is the start of its path: c[0], c[1] and w_WB. Its orientation is worked out when somebody asks
// for it; until then turns add up, up to this: beyond, their rounding would show.
constexpr double kLongestTurn = 10.0;  // [rad]

// The end of a step of length h [s].
struct Instant
{
  double t, h;
};

using Step = void (*)(Flight&, const FlightModel&, double);

void applyPendingRotation(Segment& path)
{
  if (!path.higher) return;
  path.q_WB = turned(path.q_WB, path.higher->pending_rotation, 1.0);
  path.higher->pending_rotation.setZero();
}

BallState stateOf(const BallRecord& ball)
{
  return {ball.path.c[0], ball.path.q_WB, ball.path.c[1], ball.path.w_WB};
}

void store(BallRecord& ball, const BallState& state)
{
  Segment& path = ball.path;
  if (path.w_WB != state.w_WB) applyPendingRotation(path);  // from now on it turns about another axis
  path.c[0] = state.p_WB;
  path.c[1] = state.v_WB;
  path.w_WB = state.w_WB;
}

// A ball that lies falls anew in every step, by what gravity adds in one: that is no impact to be reported.
bool worthAReport(const WorldState& world, double closing, double h)
{
  constexpr double kRounding = 1e-3;
  return closing * closing > (1.0 + kRounding) * h * h * world.scene.forces.gravity.squaredNorm();
}

void record(WorldState& world, const BallRecord& ball, const HitObject& other, double t, const BallState& before,
            const BallState& after, const Vector3d& n, const Vector3d& u)
{
  const std::size_t i = static_cast<std::size_t>(&ball - world.balls.data());
  recordContact(world, ball, i, other,
                {t, n, u, before.p_WB, before.v_WB, after.v_WB, before.w_WB, after.w_WB,
                 impulseOf(ball, before.v_WB, after.v_WB)});
}

// --- evolve ---

template <Step step>
void fly(WorldState& world, double h)
{
  for (BallRecord& ball : world.balls)
  {
    Segment& path = ball.path;
    Flight after{path.c[0], path.c[1], path.w_WB};
    step(after, ball.model(), h);
    if (!std::isfinite(after.p.sum() + after.v.sum()))  // the ball keeps its last finite state
    {
      world.status.not_finite = true;
      continue;
    }
    path.c[0] = after.p;
    path.c[1] = after.v;
    if (path.w_WB.isZero(0.0)) continue;
    Vector3d& pending_rotation = path.higher.make().pending_rotation;
    pending_rotation += turnIn(path.w_WB, ball.model().spinDecay(), h);
    path.w_WB = after.w;
    if (pending_rotation.squaredNorm() > kLongestTurn * kLongestTurn) applyPendingRotation(path);
  }
}

// --- detect and resolve ---

// The ball is clear of a box along the axes of W, which contains a shape: true for most shapes of a scene, and cheapest.
bool clearOf(const Box& box, const Vector3d& p_WB, double radius)
{
  const auto beyond = [&](int i) { return p_WB[i] - radius >= box.high[i] || p_WB[i] + radius <= box.low[i]; };
  return beyond(2) || beyond(0) || beyond(1);
}

// The same with the box that is turned with the shape: true for nearly every step, and cheap. Place and shape in the body
// frame.
bool clearOf(const Shape& shape, const Vector3d& p_BQ, double radius)
{
  if (shape.kind == ShapeKind::HalfSpace) return shape.R_BS.col(2).dot(p_BQ - shape.p_BS) >= radius;
  const Vector3d q = shape.R_BS.transpose() * (p_BQ - shape.p_BS);
  return ((q.cwiseAbs() - shape.half_size).array() >= radius).any();
}

// Closest point, push out, reflect with loss.
void collideWithShape(WorldState& world, BallRecord& ball, std::size_t b, std::size_t s, const BodyFrame& frame,
                      const Instant& now)
{
  const Shape& shape = world.bodies[b].shapes()[s];
  BallState state = stateOf(ball);
  const Gap gap = gapOver(world.bodies[b], shape, state, ball.params().radius, now.t);
  if (gap.gap >= 0.0) return;
  state.p_WB -= gap.gap * gap.n_W;
  if (gap.rate >= 0.0) return store(ball, state);
  const Vector3d p_WC = state.p_WB - ball.params().radius * gap.n_W;
  const Vector3d u = world.bodies[b].moving ? frame.pointVelocity(p_WC) : Vector3d::Zero();
  const BallState before = state;
  bounce(world.surface(ball, shape), ball.params(), state, u, gap.n_W);
  store(ball, state);
  if (worthAReport(world, -gap.rate, now.h))
    record(world, ball, HitObject::shapeOf(b, s), now.t, before, state, gap.n_W, u);
}

void collideWithMoving(WorldState& world, std::size_t b, const BodyFrame& frame, const Instant& now)
{
  const std::vector<Shape>& shapes = world.bodies[b].body.shapes;
  for (BallRecord& ball : world.balls)
    for (std::size_t s = 0; s < shapes.size(); ++s)
    {
      count(meetingLaw(shapes[s].kind));
      count(Law::MeetMoving);
      const Vector3d p_BQ = frame.R_WB.transpose() * (ball.path.c[0] - frame.p_WB);
      if (!clearOf(shapes[s], p_BQ, ball.params().radius)) collideWithShape(world, ball, b, s, frame, now);
    }
}

void collideWithStill(WorldState& world, std::size_t b, const Instant& now)
{
  static const BodyFrame kStill;
  const BodyRecord& body = world.bodies[b];
  for (BallRecord& ball : world.balls)
    for (std::size_t s = 0; s < body.placed.size(); ++s)
    {
      count(meetingLaw(body.placed[s].kind));
      const double radius = ball.params().radius;
      if (!clearOf(body.boxes[s], ball.path.c[0], radius) && !clearOf(body.placed[s], ball.path.c[0], radius))
        collideWithShape(world, ball, b, s, kStill, now);
    }
}

void collideWithBodies(WorldState& world, const Instant& now)
{
  for (std::size_t b = 0; b < world.bodies.size(); ++b)
  {
    const BodyMotion& motion = world.bodies[b].motion;
    if (world.bodies[b].moving)
      collideWithMoving(world, b, frameAt(motion, now.t - motion.start), now);
    else
      collideWithStill(world, b, now);
  }
}

void collidePair(WorldState& world, BallRecord& a, BallRecord& b, const Instant& now)
{
  BallState state_a = stateOf(a), state_b = stateOf(b);
  const Vector3d d = state_a.p_WB - state_b.p_WB;
  const double distance = d.norm();
  const double overlap = a.params().radius + b.params().radius - distance;
  const Vector3d n = distance > 0.0 ? Vector3d(d / distance) : Vector3d(Vector3d::UnitZ());
  const double part_of_a = b.params().mass / (a.params().mass + b.params().mass);  // the lighter ball gives way further
  state_a.p_WB += part_of_a * overlap * n;
  state_b.p_WB -= (1.0 - part_of_a) * overlap * n;
  const double closing = -n.dot(state_a.v_WB - state_b.v_WB);
  const BallState before = state_a;
  const Vector3d p_WC = state_a.p_WB - a.params().radius * n;
  const Vector3d v_other = state_b.v_WB + state_b.w_WB.cross(p_WC - state_b.p_WB);
  if (closing > 0.0)
  {
    const Surface& law = world.surface(a, b);
    part(law, law.restitutionAt(closing) * closing, a.params(), state_a, b.params(), state_b, n);
  }
  store(a, state_a);
  store(b, state_b);
  if (closing > 0.0 && worthAReport(world, closing, now.h))
    record(world, a, HitObject::ballOf(b.id), now.t, before, state_a, n, v_other);
}

void collidePairs(WorldState& world, const Instant& now)
{
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    for (std::size_t k = i + 1; k < world.balls.size(); ++k)
    {
      count(Law::PairSearch);
      BallRecord& a = world.balls[i];
      BallRecord& b = world.balls[k];
      const double reach = a.params().radius + b.params().radius;
      if ((a.path.c[0] - b.path.c[0]).squaredNorm() < reach * reach) collidePair(world, a, b, now);
    }
}

template <Step step>
void run(WorldState& world, double end)
{
  const double duration = end - world.time;
  const long count = std::max(1L, std::lround(std::ceil(duration / world.scene.dt - 1e-9)));
  const double h = duration / static_cast<double>(count);
  for (long i = 1; i <= count; ++i)
  {
    const Instant now{i == count ? end : world.time + h * static_cast<double>(i), h};
    fly<step>(world, h);
    collideWithBodies(world, now);
    collidePairs(world, now);
  }
  for (BallRecord& ball : world.balls) ball.path.start = end;
}
}  // namespace

void runEulerExplicit(WorldWithWindows& world, double end)
{
  run<stepExplicit>(world, end);
}
void runEulerSemiImplicit(WorldWithWindows& world, double end)
{
  run<stepSemiImplicit>(world, end);
}
void runVerlet(WorldWithWindows& world, double end)
{
  run<stepVerlet>(world, end);
}
void runRk4(WorldWithWindows& world, double end)
{
  run<stepRk4>(world, end);
}
}  // namespace ping_pong
