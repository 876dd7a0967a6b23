#include "events/bounce_run.h"

#include "base/law_counter.h"
#include "detect/fall_on_plane.h"
#include "events/bounce_run_level.h"
#include "events/predict.h"
#include "geometry/tangential.h"
#include "resting/plan_path.h"
#include "state/collapse_guard.h"
#include "state/contact_log.h"

namespace ping_pong
{
namespace
{
constexpr std::size_t kBouncesAtATime = 1000;  // the limit of events is looked at in between

// What does not change from bounce to bounce.
struct Ground
{
  const Shape& plane;
  const Surface& law;
  Vector3d n;
  Vector3d a;       // of the ball
  double press;     // -n.a
  bool only_shape;  // there is nothing else to hit
};

Ground groundOf(const WorldState& world, const BallRecord& ball, const Event& event)
{
  const BodyRecord& body = world.bodies[event.other];
  const Shape& plane = body.placed[event.shape];
  const Vector3d n = plane.R_BS.col(2);
  const Vector3d a = ball.model().acceleration(Vector3d::Zero(), Vector3d::Zero());
  return {plane, world.surface(ball, plane), n, a, -n.dot(a), world.bodies.size() == 1 && body.placed.size() == 1};
}

bool bouncesOn(const WorldState& world, const BallRecord& ball, const Event& event)
{
  if (event.kind != Event::Kind::HitBody || world.any_moving || ball.path.degree != 2 || !ball.model().constant())
    return false;
  const BodyRecord& body = world.bodies[event.other];
  return body.version == event.version && body.placed[event.shape].kind == ShapeKind::HalfSpace &&
         ball.supports.none() && ball.path.w_WB.isZero(0.0) && ball.path.pending_rotation().isZero(0.0) &&
         ball.instant_contacts < kManyQuick;
}

bool slips(const Ground& ground, const Vector3d& v)
{
  return ground.law.friction != 0.0 && !tangential(v, ground.n).isZero(0.0);
}

// Whether all bounces to come are too small to count: then the ball comes to lie.
bool comesToRest(const Ground& ground, const Vector3d& p, const Vector3d& v, double radius)
{
  const double rate = ground.n.dot(v);
  return rate <= kSurelyBounces && bouncingEnds(rate, ground.press, touchTolerance(p, radius));
}

bool othersInTheWay(const WorldState& world, const BallRecord& ball, const Ground& ground, double t, double next)
{
  if (ground.only_shape) return false;
  Box way = boxOf(ball, t, next);
  way.low.array() -= kSlack;
  way.high.array() += kSlack;
  for (const BodyRecord& body : world.bodies)
    for (std::size_t s = 0; s < body.placed.size(); ++s)
      if (&body.placed[s] != &ground.plane && way.overlaps(body.boxes[s])) return true;
  return false;
}

// The acceleration and its bounds are what they were.
void setPath(BallRecord& ball, const Vector3d& p, const Vector3d& v, double t)
{
  ball.path.start = t;
  ball.path.c[0] = p;
  ball.path.c[1] = v;
  ++ball.version;
}

void predictBounce(WorldState& world, std::size_t i, const Ground& ground, double t)
{
  BallRecord& ball = world.balls[i];
  const Detection found = fallOnPlane(ball.path, ball.params().radius, ground.n, ground.plane, t, t + kHorizon);
  if (!found.found() || othersInTheWay(world, ball, ground, t, found.time)) return predictStill(world, i, t);
  count(Law::MeetHalfSpace);
  ball.next.time = found.time;  // the rest is what it was
}

// One bounce; false, with nothing changed, if it is not such a one.
bool bounceOnce(WorldState& world, const Window& window, std::size_t i, const Ground& ground)
{
  BallRecord& ball = world.balls[i];
  const double t = ball.next.time;
  const double s = t - ball.path.start;
  const auto& c = ball.path.c;
  const Vector3d p = c[0] + s * (c[1] + s * c[2]);
  const Vector3d before = c[1] + (2.0 * s) * c[2];
  const double closing = -ground.n.dot(before);
  if (!(closing > 0.0) || slips(ground, before)) return false;
  const Vector3d after = before + ((1.0 + ground.law.restitutionAt(closing)) * closing) * ground.n;
  if (comesToRest(ground, p, after, ball.params().radius)) return false;
  count(Law::Restitution);
  countCollapse(ball, t);
  if (worthAReport(ball, closing))
    recordContact(*window.records, ball, i, HitObject::shapeOf(ball.next.other, ball.next.shape),
                  {t, ground.n, Vector3d::Zero(), p, before, after, Vector3d::Zero(), Vector3d::Zero(),
                   impulseOf(ball, before, after)});
  if (window.log) window.log->leavesPath(i, t);
  setPath(ball, p, after, t);
  predictBounce(world, i, ground, t);
  return true;
}

// What bounceOnLevel() takes for granted, besides what runBounces() does.
bool level(const Ground& ground, const BallRecord& ball)
{
  return ground.only_shape && ground.n == Vector3d::UnitZ() && ground.a.x() == 0.0 && ground.a.y() == 0.0 &&
         !slips(ground, ball.path.c[1]);
}

bool onTheSame(const Event& now, const Event& before)
{
  return now.kind == before.kind && now.other == before.other && now.shape == before.shape;
}
}  // namespace

bool runBounces(WorldState& world, const Window& window, std::size_t i)
{
  BallRecord& ball = world.balls[i];
  if (!bouncesOn(world, ball, ball.next)) return false;
  const Event first = ball.next;
  const Ground ground = groundOf(world, ball, first);
  const std::size_t most = window.count == 1 ? kBouncesAtATime : 1;
  std::size_t bounces = 0;
  if (most > 1 && level(ground, ball))
    bounces = bounceOnLevel(world, window, i, {ground.plane.p_BS.z(), ground.law, ground.a.z()}, most);
  while (bounces < most && ball.next.time <= window.end && onTheSame(ball.next, first) &&
         bounceOnce(world, window, i, ground))
    ++bounces;
  if (bounces > 1) window.records->status.events += bounces - 1;  // one has been counted by the caller
  return bounces > 0;
}
}  // namespace ping_pong
