#include "launch.h"

#include "touch.h"

namespace ping_pong::stability
{
namespace
{
constexpr double kAbove = 0.6;    // higher than any body of a stage [m]
constexpr double kBelow = -0.5;   // nothing to touch any more [m]
constexpr double kClear = 1e-10;  // an overlap that is none [m]

// A ball that stands still.
BallState standing(const Vector3d& p)
{
  BallState state;
  state.p_WB = p;
  return state;
}

Touch nearest(const Stage& stage, const Vector3d& p, double radius)
{
  Touch best;
  best.gap = Stage::kNoLimit;
  for (std::size_t b = 0; b < stage.bodies.size(); ++b)
    for (std::size_t s = 0; s < stage.bodies[b].shapes.size(); ++s)
    {
      const Touch touch = touchOf(stage.bodies[b], {b, s}, stage.bodies[b].pose, Twist(), standing(p), radius);
      if (touch.gap < best.gap) best = touch;
    }
  return best;
}

// Down from high above until the ball touches; false if it touches nothing.
bool lower(const Stage& stage, double radius, Vector3d& p)
{
  p.z() = kAbove;
  for (int i = 0; i < 1000 && p.z() > kBelow; ++i)
  {
    const Touch touch = nearest(stage, p, radius);
    p.z() -= touch.gap;
    if (touch.gap > 1e-9) continue;
    p -= touch.gap * touch.n_W;
    return deepest(stage.bodies, p, radius) < kClear;
  }
  return false;
}

// Onto the first `count` surfaces of the feature, one after the other and again; false if the ball does not fit there.
bool nestle(const Stage& stage, double radius, std::size_t count, Vector3d& p)
{
  p = stage.target;
  for (int round = 0; round < 500; ++round)
    for (std::size_t i = 0; i < count; ++i)
    {
      const ShapeName of = stage.feature[i];
      const Body& body = stage.bodies[of.body];
      const Touch touch = touchOf(body, of, body.pose, Twist(), standing(p), radius);
      p -= touch.gap * touch.n_W;
    }
  return deepest(stage.bodies, p, radius) < kClear;
}

Vector3d placeOnSurface(Dice& dice, const Stage& stage, double radius)
{
  Vector3d p;
  for (int tries = 0; tries < 20; ++tries)
  {
    p = dice.uniform(stage.low, stage.high);
    if (lower(stage, radius, p)) return p;
  }
  p.z() = kAbove;
  return p;
}

Vector3d placeInFeature(Dice& dice, const Stage& stage, double radius)
{
  const std::size_t count = 1 + static_cast<std::size_t>(dice.pick(static_cast<int>(stage.feature.size())));
  Vector3d p;
  return nestle(stage, radius, count, p) ? p : placeOnSurface(dice, stage, radius);
}

// In the tangent plane, more or less towards the trouble.
Vector3d heading(Dice& dice, const Stage& stage, const Vector3d& p, const Vector3d& n)
{
  Vector3d ahead = stage.target - p;
  ahead -= n.dot(ahead) * n;
  if (ahead.norm() < 1e-6) ahead = n.cross(dice.direction());
  const double off = 0.4 * dice.normal();
  return Eigen::AngleAxisd(off, n) * ahead.normalized();
}

BallState rolled(Dice& dice, const Stage& stage, double radius)
{
  BallState state = standing(placeOnSurface(dice, stage, radius));
  const Vector3d n = nearest(stage, state.p_WB, radius).n_W;
  const double speed = dice.log(0.02, 2.0);
  state.v_WB = speed * heading(dice, stage, state.p_WB, n);
  state.w_WB = n.cross(state.v_WB) / radius;
  if (dice.chance(0.3)) state.w_WB += dice.symmetric(100.0) * n;
  return state;
}

BallState slid(Dice& dice, const Stage& stage, double radius)
{
  BallState state = rolled(dice, stage, radius);
  const double spin = dice.chance(0.3) ? 0.0 : dice.log(1.0, 300.0);
  state.w_WB = spin * dice.direction();
  return state;
}

BallState dropped(Dice& dice, const Stage& stage, double radius)
{
  BallState state = standing(placeOnSurface(dice, stage, radius));
  state.p_WB.z() += dice.log(1e-4, 0.3);
  const double speed = dice.chance(0.5) ? 0.0 : dice.uniform(0.0, 0.3);
  state.v_WB = speed * heading(dice, stage, state.p_WB, Vector3d::UnitZ());
  const double spin = dice.chance(0.5) ? 0.0 : dice.log(1.0, 300.0);
  state.w_WB = spin * dice.direction();
  return state;
}

BallState thrown(Dice& dice, const Stage& stage, double radius)
{
  BallState state = dropped(dice, stage, radius);
  const double speed = dice.log(0.3, 4.0);
  state.v_WB = speed * (stage.target - state.p_WB + 0.02 * dice.direction()).normalized();
  return state;
}

BallState spun(Dice& dice, const Stage& stage, double radius)
{
  BallState state = standing(placeInFeature(dice, stage, radius));
  const double spin = dice.log(1.0, 600.0);
  state.w_WB = spin * dice.direction();
  return state;
}
}  // namespace

Launch drawLaunch(Dice& dice, const Stage& stage, double radius)
{
  const double which = dice.uniform(0.0, 1.0);
  if (which < 0.30) return {"rolled", rolled(dice, stage, radius)};
  if (which < 0.45) return {"slid", slid(dice, stage, radius)};
  if (which < 0.65) return {"dropped", dropped(dice, stage, radius)};
  if (which < 0.80) return {"thrown", thrown(dice, stage, radius)};
  if (which < 0.93) return {"spun", spun(dice, stage, radius)};
  return {"rest", standing(placeInFeature(dice, stage, radius))};
}
}  // namespace ping_pong::stability
