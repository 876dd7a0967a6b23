#include "resting/joint_impact.h"

#include "resting/at_once.h"
#include "resting/plan_path.h"
#include "state/body_gap.h"
#include "state/collapse_guard.h"
#include "state/contact_log.h"

namespace ping_pong
{
namespace
{
constexpr double kTogether = 1e-9;  // a surface this near is struck, too [m]

bool isTouched(const Gap& gap)
{
  return std::abs(gap.gap) <= kTogether && gap.rate <= kNoReboundSpeed;
}

Supports touchedSurfaces(const WorldState& world, const BallRecord& ball, const Event& event, const BallState& state,
                         double t)
{
  Supports touched;
  touched.add(event.other, event.shape);
  for (std::size_t b = 0; b < world.bodies.size(); ++b)
  {
    const BodyRecord& body = world.bodies[b];
    for (std::size_t s = 0; s < body.shapes().size(); ++s)
      if (isTouched(gapOver(body, body.shapes()[s], state, ball.params().radius, t))) touched.add(b, s);
  }
  return touched;
}

// A contact for each surface, with its own impulse; velocities are those before and after all of them.
void record(const WorldState& world, Records& records, std::size_t i, const ConstrainedBall& constrained,
            const SupportForces& impulses, double t, const BallState& before, const BallState& after)
{
  const BallRecord& ball = world.balls[i];
  for (std::size_t k = 0; k < constrained.count; ++k)
  {
    if (!worthAReport(ball, impulses[k].load)) continue;
    const Supports::Surface& surface = ball.supports[k];
    const BodyRecord& body = world.bodies[surface.body];
    const Vector3d n = gapOver(body, body.shapes()[surface.shape], before, constrained.radius, t).n_W;
    const Vector3d u =
        body.moving ? body.at(t).pointVelocity(before.p_WB - constrained.radius * n) : Vector3d(Vector3d::Zero());
    const Vector3d impulse = ball.params().mass * (impulses[k].load * n + impulses[k].friction);
    recordContact(records, ball, i, HitObject::shapeOf(surface.body, surface.shape),
                  {t, n, u, before.p_WB, before.v_WB, after.v_WB, before.w_WB, after.w_WB, impulse});
  }
}
}  // namespace

bool strikeAllTouched(WorldState& world, Records& records, std::size_t i, const Event& event, double t,
                      BallState& state)
{
  BallRecord& ball = world.balls[i];
  Supports touched = touchedSurfaces(world, ball, event, state, t);
  if (touched.count() < 2) return false;
  std::swap(ball.supports, touched);
  const ConstrainedBall constrained = constrainedBall(world, ball, state.p_WB, t);
  BallMotion motion = motionOf(state, constrained.radius);
  SupportForces impulses;
  if (!strikeAll(constrained, t, motion, impulses))
  {
    std::swap(ball.supports, touched);
    return false;
  }
  const BallState before = state;
  state.v_WB = motion.v;
  state.w_WB = motion.s / constrained.radius;
  record(world, records, i, constrained, impulses, t, before, state);
  ball.supports.setSince(t);
  return true;
}
}  // namespace ping_pong
