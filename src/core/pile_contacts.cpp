// Contacts that carry load: projected Gauss-Seidel iteration on impulses (Jean and Moreau, "Unilaterality and dry friction in
// the dynamics of rigid body collections", 1992; "sequential impulses" in games), warm started. A contact may not close further
// than its gap within the step; friction stays in Coulomb's cone. No contact pushes balls apart: what little overlap is left by
// an iteration that was cut short is taken out of the places, not given to the velocities.
#include <algorithm>
#include <cmath>

#include "count.h"
#include "pile.h"
#include "world_state.h"

namespace ping_pong
{
namespace
{
using Eigen::Vector3f;

constexpr int kMostIterations = 8;
constexpr double kGoodEnough = 0.1;    // change of a velocity that is not passed on, in least impacts
constexpr double kSlop = 2e-6;          // overlap that stays [m]
constexpr double kPushOut = 0.2;        // part of the rest that is taken out in a step
constexpr double kForgets = 5e-4;       // deeper than this the last impulses are no guide [m]
constexpr double kWakingForce = 0.3;    // change of a force on a sleeping ball that wakes it up, in its weight

double reachOf(const Pile& pile) { return 4.0 * pile.least_impact * pile.h + 1e-6; }

// In free flight the forces act for half of the step before the contacts and for half after them; on a ball that something
// carries, for all of it before them. Whoever is caught owes the second half to the next step.
Vector3d kick(const Pile& pile, std::size_t i)
{
  const Mover& mover = pile.movers[i];
  const double halves = (mover.was_loaded ? 2.0 : 1.0) + (mover.half_owed ? 1.0 : 0.0);
  return (0.5 * halves * pile.h) * pile.flightAcceleration(i);
}

// --- gathering ---

// Least normal velocity: closes the gap within the step and no more, and leaves an overlap that was there as it is.
float target(double normal_velocity, double gap_at_end, double gap_at_start, double h)
{
  return static_cast<float>(normal_velocity - (gap_at_end - std::min(gap_at_start, 0.0)) / h);
}

// Part of an overlap that is taken out now [m].
double pushOut(double gap_at_start) { return kPushOut * std::max(-gap_at_start - kSlop, 0.0); }

bool hitInThisStep(const Pile& pile, std::size_t i) { return pile.movers[i].stamp >= pile.step_mark; }

// One of them sleeps: a force that changes, comes or goes wakes it up.
void watch(Pile& pile, PairLink& link)
{
  const bool a_sleeps = pile.movers[link.a].asleep;
  if (a_sleeps == pile.movers[link.b].asleep)
  {
    link.held = -1.0f;
    return;
  }
  const std::uint32_t sleeper = a_sleeps ? link.a : link.b;
  const float force = link.push.normal / static_cast<float>(pile.h);
  const double weight = pile.params(sleeper).mass * pile.flightAcceleration(sleeper).norm();
  if (std::abs(force - link.held) > kWakingForce * weight) pile.waking.push_back(sleeper);
}

void gatherPair(WorldState& world, std::uint32_t l)
{
  Pile& pile = world.pile;
  PairLink& link = pile.pairs[l];
  Mover &a = pile.movers[link.a], &b = pile.movers[link.b];
  if (a.asleep != b.asleep && link.held < 0.0f) link.held = link.push.normal / static_cast<float>(pile.h);
  const double reach = pile.radius(link.a) + pile.radius(link.b);
  const Vector3d d = pile.p[link.a] - pile.p[link.b];
  const Vector3d u = a.v - b.v;
  const Vector3d d_end = d + pile.h * u;
  const double most = reach + reachOf(pile);
  if (d_end.squaredNorm() > most * most)
  {
    link.push = Push();
    watch(pile, link);
    return;
  }
  const double distance = d_end.norm();
  const Vector3d n = distance > 0.0 ? Vector3d(d_end / distance) : Vector3d(Vector3d::UnitZ());
  const bool hit = hitInThisStep(pile, link.a) || hitInThisStep(pile, link.b);
  const double gap_at_start = hit ? 0.0 : d.norm() - reach;
  const double inverse_a = pile.inverseMass(link.a), inverse_b = pile.inverseMass(link.b);
  const double mass = 1.0 / (inverse_a + inverse_b);
  if (const double out = pushOut(gap_at_start); out > 0.0)
  {
    pile.p[link.a] += (out * inverse_a * mass) * n;
    pile.p[link.b] -= (out * inverse_b * mass) * n;
  }
  if (gap_at_start < -kForgets) link.push = Push();
  Touch& touch = pile.touches.emplace_back();
  touch.n = n.cast<float>();
  touch.target = target(n.dot(u), distance - reach, gap_at_start, pile.h);
  touch.normal_mass = static_cast<float>(mass);
  touch.slip_mass = static_cast<float>(1.0 / (inverse_a * pile.kinds[a.kind].give + inverse_b * pile.kinds[b.kind].give));
  touch.inverse_a = static_cast<float>(inverse_a);
  touch.inverse_b = static_cast<float>(inverse_b);
  touch.friction = static_cast<float>(world.scene.surfaces.at(pile.params(link.a).material, pile.params(link.b).material).friction);
  touch.link = l;
  touch.a = link.a;
  touch.b = link.b;
  touch.push = link.push;
}

void gatherBody(WorldState& world, std::uint32_t l, BodyLink& link)
{
  Pile& pile = world.pile;
  const std::uint32_t i = link.ball;
  Mover& mover = pile.movers[i];
  const BodyRecord& body = world.bodies[link.body];
  const Shape& shape = body.shapes()[link.shape];
  const double radius = pile.radius(i);
  const Vector3d end = pile.p[i] + pile.h * mover.v;
  const auto gapAt = [&](const Vector3d& p, double t) {
    return body.moving ? gapTo(shape, frameAt(body.motion, pile.start + t - body.motion.start), p, Vector3d::Zero(), radius)
                       : gapTo(shape, p, Vector3d::Zero(), radius);
  };
  const Gap gap = gapAt(end, pile.h);
  if (gap.gap > reachOf(pile))
  {
    link.push = Push();
    return;
  }
  const double gap_at_start = hitInThisStep(pile, i) ? 0.0 : gapAt(pile.p[i], 0.0).gap;
  if (body.moving) pile.wake(i);
  pile.squeezed += gap_at_start < -kForgets;
  pile.p[i] += pushOut(gap_at_start) * gap.n_W;
  if (gap_at_start < -kForgets) link.push = Push();
  BodyTouch& touch = pile.body_touches.emplace_back();
  touch.n = gap.n_W.cast<float>();
  touch.target = target(gap.n_W.dot(mover.v), gap.gap, gap_at_start, pile.h);
  const BallKind& kind = pile.kinds[mover.kind];
  touch.normal_mass = static_cast<float>(kind.params.mass);
  touch.slip_mass = static_cast<float>(kind.params.mass / kind.give);
  touch.inverse_a = touch.inverse_b = static_cast<float>(kind.inverse_mass);
  const double middle = pile.start + 0.5 * pile.h - body.motion.start;
  touch.u = body.moving ? Vector3f(frameAt(body.motion, middle).pointVelocity(end - radius * gap.n_W).cast<float>())
                        : Vector3f(Vector3f::Zero());
  touch.friction = static_cast<float>(world.scene.surfaces.at(pile.params(i).material, shape.material).friction);
  touch.moving = body.moving;
  touch.material = shape.material;
  touch.link = l;
  touch.a = touch.b = i;
  touch.push = link.push;
}

void gather(WorldState& world)
{
  Pile& pile = world.pile;
  pile.touches.clear();
  pile.body_touches.clear();
  for (std::uint32_t l = 0; l < pile.moving.size(); ++l) gatherBody(world, l, pile.moving[l]);
  for (const std::uint32_t l : pile.active_bodies) gatherBody(world, l, pile.bodies[l]);
  for (const std::uint32_t l : pile.active_pairs) gatherPair(world, l);
}

// --- solving ---

// What the normal impulse gains or loses; it never pulls.
float normalImpulse(Touch& touch, double normal_velocity)
{
  const float before = touch.push.normal;
  touch.push.normal =
      std::max(0.0f, before + touch.normal_mass * (touch.target - static_cast<float>(normal_velocity)));
  return touch.push.normal - before;
}

// What friction adds, and keeps within the cone.
Vector3f slipImpulse(Touch& touch, const Vector3f& slip)
{
  const Vector3f before = touch.push.tangent;
  touch.push.tangent -= touch.slip_mass * slip;
  const float most = touch.friction * touch.push.normal;
  const float needed = touch.push.tangent.squaredNorm();
  if (needed > most * most) touch.push.tangent *= most / std::sqrt(needed);
  return touch.push.tangent - before;
}

bool slips(const Touch& touch)
{
  return touch.friction > 0.0f && (touch.push.normal > 0.0f || !touch.push.tangent.isZero(0.0f));
}

// Impulse along n and across it on one ball: the first, or the second with the opposite sign.
void apply(const Pile& pile, Mover& ball, const Touch& touch, float normal, const Vector3f& across, bool first)
{
  const float per_mass = first ? touch.inverse_a : touch.inverse_b;
  ball.v += ((first ? per_mass : -per_mass) * (normal * touch.n + across)).cast<double>();
  const float spin = per_mass * static_cast<float>(pile.kinds[ball.kind].spin_per_impulse);
  ball.w -= (spin * touch.n.cross(across)).cast<double>();
}

void applyNormal(Mover& ball, const Touch& touch, float gain)
{
  ball.v += (gain * touch.n).cast<double>();
}

void warmStart(Pile& pile)
{
  const auto start = [&pile](Touch& touch, bool pair) {
    if (touch.push.normal == 0.0f) return;
    touch.push.tangent -= touch.n.dot(touch.push.tangent) * touch.n;
    apply(pile, pile.movers[touch.a], touch, touch.push.normal, touch.push.tangent, true);
    if (pair) apply(pile, pile.movers[touch.b], touch, touch.push.normal, touch.push.tangent, false);
  };
  for (BodyTouch& touch : pile.body_touches) start(touch, false);
  for (Touch& touch : pile.touches) start(touch, true);
}

// Both return whether a velocity has changed by more than `small`.
bool solveBody(Pile& pile, BodyTouch& touch, float small)
{
  Mover& ball = pile.movers[touch.a];
  Vector3f u = ball.v.cast<float>();
  const float impulse = normalImpulse(touch, touch.n.dot(u));
  float change = std::abs(impulse);
  if (slips(touch))
  {
    const float radius = static_cast<float>(pile.radius(touch.a));
    u -= touch.u;
    const Vector3f slip = u - touch.n.dot(u) * touch.n - radius * ball.w.cast<float>().cross(touch.n);
    const Vector3f across = slipImpulse(touch, slip);
    apply(pile, ball, touch, impulse, across, true);
    change += across.norm();
  }
  else
    applyNormal(ball, touch, touch.inverse_a * impulse);
  return change * touch.inverse_a > small;
}

bool solvePair(Pile& pile, Touch& touch, float small)
{
  Mover &a = pile.movers[touch.a], &b = pile.movers[touch.b];
  const Vector3f u = (a.v - b.v).cast<float>();
  const float along = touch.n.dot(u);
  const float impulse = normalImpulse(touch, along);
  float change = std::abs(impulse);
  if (slips(touch))
  {
    const float radius_a = static_cast<float>(pile.radius(touch.a)), radius_b = static_cast<float>(pile.radius(touch.b));
    const Vector3f spin = radius_a * a.w.cast<float>() + radius_b * b.w.cast<float>();
    const Vector3f across = slipImpulse(touch, u - along * touch.n - spin.cross(touch.n));
    apply(pile, a, touch, impulse, across, true);
    apply(pile, b, touch, impulse, across, false);
    change += across.norm();
  }
  else
  {
    applyNormal(a, touch, touch.inverse_a * impulse);
    applyNormal(b, touch, -touch.inverse_b * impulse);
  }
  return change * std::max(touch.inverse_a, touch.inverse_b) > small;
}

// Every touch once; then those of balls that changed, forwards and backwards in turn, until nothing changes any more.
void iterate(Pile& pile)
{
  const float small = static_cast<float>(kGoodEnough * pile.least_impact);
  std::uint32_t since = 0;
  for (int iteration = 0; iteration < kMostIterations; ++iteration)
  {
    const std::uint32_t now = ++pile.counter;
    bool any = false;
    const auto changed = [&](std::uint32_t i) { return pile.movers[i].stamp >= since; };
    const auto pair = [&](Touch& touch) {
      if ((!changed(touch.a) && !changed(touch.b)) || !solvePair(pile, touch, small)) return;
      pile.movers[touch.a].stamp = pile.movers[touch.b].stamp = now;
      any = true;
    };
    for (BodyTouch& touch : pile.body_touches)
    {
      if (!changed(touch.a) || !solveBody(pile, touch, small)) continue;
      pile.movers[touch.a].stamp = now;
      any = true;
    }
    if (iteration % 2 == 0)
      std::for_each(pile.touches.begin(), pile.touches.end(), pair);
    else
      std::for_each(pile.touches.rbegin(), pile.touches.rend(), pair);
    if (!any) break;
    since = now;
  }
}

// Rolling resistance c_r N against the roll, spin friction c_s N against the spin about the normal; see docs/physics.md.
void resist(WorldState& world, const BodyTouch& touch)
{
  Pile& pile = world.pile;
  Mover& ball = pile.movers[touch.a];
  const BallKind& kind = pile.kinds[ball.kind];
  const Surface& law = world.scene.surfaces.at(kind.params.material, touch.material);
  if (law.rolling_resistance == 0.0 && law.spin_friction == 0.0) return;
  const double load = static_cast<double>(touch.push.normal * touch.inverse_a);  // [m/s]
  const Vector3d n = touch.n.cast<double>();
  const Vector3d u = ball.v - touch.u.cast<double>();
  const Vector3d along = u - n.dot(u) * n;
  if (const double speed = along.norm(); law.rolling_resistance > 0.0 && speed > 0.0)
  {
    count(Law::RollingResistance);
    const Vector3d less = (-std::min(1.0, law.rolling_resistance * load / speed)) * along;
    ball.v += less;
    ball.w += n.cross(less) / kind.params.radius;
  }
  if (law.spin_friction == 0.0) return;
  count(Law::SpinFriction);
  const double spin = n.dot(ball.w);
  const double most = law.spin_friction * load * kind.spin_per_impulse;
  ball.w -= std::clamp(spin, -most, most) * n;
}

// For the next step, and to tell whom something carries.
void keepPushes(Pile& pile)
{
  for (const std::uint32_t i : pile.awake) pile.movers[i].loaded = false;
  for (const BodyTouch& touch : pile.body_touches)
  {
    if (!touch.moving) pile.bodies[touch.link].push = touch.push;
    if (touch.push.normal > 0.0f) pile.movers[touch.a].loaded = true;
  }
  for (const Touch& touch : pile.touches)
  {
    PairLink& link = pile.pairs[touch.link];
    link.push = touch.push;
    watch(pile, link);
    if (touch.push.normal == 0.0f) continue;
    pile.untouched[touch.a] = pile.untouched[touch.b] = 0.0f;
    for (const std::uint32_t i : {touch.a, touch.b})
      if (!pile.movers[i].asleep) pile.movers[i].loaded = true;
  }
}
}  // namespace

void solveContacts(WorldState& world)
{
  Pile& pile = world.pile;
  for (const std::uint32_t i : pile.awake)
  {
    Mover& mover = pile.movers[i];
    mover.was_loaded = mover.loaded;
    mover.v += kick(pile, i);
  }
  pile.waking.clear();
  gather(world);
  warmStart(pile);
  iterate(pile);
  for (const BodyTouch& touch : pile.body_touches) resist(world, touch);
  keepPushes(pile);
}
}  // namespace ping_pong
