#include "events/bounce_run_level.h"

#include "base/law_counter.h"
#include "detect/conservative_advancement.h"
#include "events/predict.h"
#include "resting/plan_path.h"
#include "state/collapse_guard.h"
#include "state/contact_log.h"

namespace ping_pong
{
namespace
{
// Between bounces; what does not change on the way stands in the path.
struct Flight1
{
  double start, x, y, z, v;  // v along z
};

Vector3d placeOf(const Flight1& flight)
{
  return {flight.x, flight.y, flight.z};
}

// What the next bounce leaves.
struct Bounce
{
  Flight1 after;
  double closing;
  double next;  // time of the bounce after it, kNever if this one is not ordinary
};

// The same operations as in bounce_run.cpp, without those that multiply by the zeros and ones of (0, 0, 1).
Bounce bounceAt(double t, const Flight1& now, const Segment& path, double radius, const LevelGround& ground)
{
  const double half_a = path.c[2].z();
  const double s = t - now.start;
  const double before = now.v + (2.0 * s) * half_a;
  Bounce bounce;
  bounce.closing = -before;
  bounce.next = kNever;
  if (!(bounce.closing > 2.0 * kResidualSeparation)) return bounce;
  const double v = before + (1.0 + ground.law.restitutionAt(bounce.closing)) * bounce.closing;
  bounce.after = {t, now.x + s * path.c[1].x(), now.y + s * path.c[1].y(), now.z + s * (now.v + s * half_a), v};
  const Vector3d p = placeOf(bounce.after);
  const double tolerance = touchTolerance(p, radius);
  if (v <= kSurelyBounces && bouncingEnds(v, -ground.a, tolerance)) return bounce;
  const double gap = p.z() - ground.z - radius;
  if (!(v > kNoSeparationSpeed)) return bounce;
  double step = safeStep(std::max(gap, 0.0), v, 2.0 * half_a);
  if (gap <= tolerance) step = std::max(step, kFirstAdvance);
  if (t + step <= t + kHorizon) bounce.next = t + step;
  return bounce;
}

Vector3d withZ(const Vector3d& v, double z)
{
  return {v.x(), v.y(), z};
}

// After so many bounces, the next one at time t.
void storePath(BallRecord& ball, const Flight1& now, double t, std::size_t bounces)
{
  Segment& path = ball.path;
  path.start = now.start;
  path.c[0] = placeOf(now);
  path.c[1] = {path.c[1].x() + 0.0, path.c[1].y() + 0.0, now.v};  // no -0, as in bounce_run.cpp
  ball.version += static_cast<std::uint32_t>(bounces);
  ball.next.time = t;
}

// From the first bounce to the last, where the path begins: the longest flight bulges most above the ground, see boxOf().
Box boxOfBounces(const Segment& path, const Flight1& first, double radius, const LevelGround& ground, double longest)
{
  Box way;
  way.low = path.c[0].cwiseMin(placeOf(first)).array() - radius;
  way.high = path.c[0].cwiseMax(placeOf(first)).array() + radius;
  way.low.z() = std::min(way.low.z(), ground.z);
  way.high.z() -= 0.25 * longest * longest * path.c[2].z();
  return way;
}
}  // namespace

std::size_t bounceOnLevel(WorldState& world, const Window& window, std::size_t i, const LevelGround& ground,
                          std::size_t most)
{
  BallRecord& ball = world.balls[i];
  Segment& path = ball.path;
  const double radius = ball.params().radius;
  Flight1 now{path.start, path.c[0].x(), path.c[0].y(), path.c[0].z(), path.c[1].z()};
  Flight1 first{};  // from the first bounce on
  double t = ball.next.time, longest = 0.0;
  std::size_t bounces = 0;
  while (bounces < most && t <= window.end && t - ball.last_contact >= kQuickTime)
  {
    const Bounce bounce = bounceAt(t, now, path, radius, ground);
    if (!(bounce.next < kNever)) break;
    count(Law::Restitution);
    count(Law::MeetHalfSpace);
    countCollapse(ball, t);
    if (bounces == 0 && window.log) window.log->leavesPath(i, t);
    const Vector3d v_before = withZ(path.c[1], -bounce.closing), v_after = withZ(path.c[1], bounce.after.v);
    recordContact(*window.records, ball, i, HitObject::shapeOf(ball.next.other, ball.next.shape),
                  {t, Vector3d::UnitZ(), Vector3d::Zero(), placeOf(bounce.after), v_before, v_after, Vector3d::Zero(),
                   Vector3d::Zero(), impulseOf(ball, v_before, v_after)});
    if (bounces++ == 0)
      first = bounce.after;
    else
      longest = std::max(longest, t - now.start);
    now = bounce.after;
    t = bounce.next;
  }
  if (bounces == 0) return 0;
  storePath(ball, now, t, bounces);
  if (window.log && bounces > 1)
    window.log->flewInBox(i, boxOfBounces(path, first, radius, ground, longest), now.start);
  return bounces;
}
}  // namespace ping_pong
