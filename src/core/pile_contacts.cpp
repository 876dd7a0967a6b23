// Contacts that carry load: projected Gauss-Seidel iteration on impulses (Jean and Moreau, "Unilaterality and dry friction in
// the dynamics of rigid body collections", 1992; "sequential impulses" in games), warm started. A contact may not close further
// than its gap within the step; friction stays in Coulomb's cone. No contact pushes balls apart: what little overlap is left by
// an iteration that was cut short is taken out of the places, not given to the velocities.
#include <algorithm>
#include <cmath>

#include "pile.h"
#include "world_state.h"

namespace ping_pong
{
namespace
{
using Eigen::Vector3f;

constexpr int kMostIterations = 40;
constexpr double kGoodEnough = 0.02;    // change of a velocity that is not passed on, in least impacts
constexpr double kSlop = 2e-6;          // overlap that stays [m]
constexpr double kPushOut = 0.2;        // part of the rest that is taken out in a step
constexpr double kForgets = 5e-4;       // deeper than this the last impulses are no guide [m]
constexpr double kWakingForce = 0.3;    // change of a force on a sleeping ball that wakes it up, in its weight

double reachOf(const Pile& pile) { return 4.0 * pile.least_impact * pile.h + 1e-6; }

// Half of the way of the forces before the contacts, the rest after; with something that carries the ball all of it.
Vector3d kick(const Pile& pile, std::size_t i)
{
  return (pile.movers[i].was_loaded ? pile.h : 0.5 * pile.h) * pile.flightAcceleration(i);
}

void applyNormal(Mover& a, Mover& b, const Vector3d& n, double impulse)
{
  a.v += (static_cast<double>(a.inverse_mass) * impulse) * n;
  b.v -= (static_cast<double>(b.inverse_mass) * impulse) * n;
}

void applySlip(const Pile& pile, Mover& ball, const Vector3d& n, const Vector3d& impulse, double sign)
{
  const double per_mass = ball.inverse_mass;
  ball.v += (sign * per_mass) * impulse;
  ball.w -= (per_mass * pile.kinds[ball.kind].spin_per_impulse) * n.cross(impulse);
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
  if (link.held < 0.0f) link.held = force;
  const double weight = pile.params(sleeper).mass * pile.flightAcceleration(sleeper).norm();
  if (std::abs(force - link.held) > kWakingForce * weight) pile.waking.push_back(sleeper);
}

void gatherPair(WorldState& world, std::uint32_t l)
{
  Pile& pile = world.pile;
  PairLink& link = pile.pairs[l];
  Mover &a = pile.movers[link.a], &b = pile.movers[link.b];
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
  const double mass = 1.0 / static_cast<double>(a.inverse_mass + b.inverse_mass);
  if (const double out = pushOut(gap_at_start); out > 0.0)
  {
    pile.p[link.a] += (out * static_cast<double>(a.inverse_mass) * mass) * n;
    pile.p[link.b] -= (out * static_cast<double>(b.inverse_mass) * mass) * n;
  }
  if (gap_at_start < -kForgets) link.push = Push();
  Touch& touch = pile.touches.emplace_back();
  touch.n = n.cast<float>();
  touch.target = target(n.dot(u), distance - reach, gap_at_start, pile.h);
  touch.normal_mass = static_cast<float>(mass);
  const double give = static_cast<double>(a.inverse_mass) * pile.kinds[a.kind].give +
                      static_cast<double>(b.inverse_mass) * pile.kinds[b.kind].give;
  touch.slip_mass = static_cast<float>(1.0 / give);
  touch.friction = static_cast<float>(world.scene.surfaces.at(pile.params(link.a).material, pile.params(link.b).material).friction);
  touch.link = l;
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
  pile.p[i] += pushOut(gap_at_start) * gap.n_W;
  if (gap_at_start < -kForgets) link.push = Push();
  BodyTouch& touch = pile.body_touches.emplace_back();
  touch.n = gap.n_W.cast<float>();
  touch.target = target(gap.n_W.dot(mover.v), gap.gap, gap_at_start, pile.h);
  touch.normal_mass = 1.0f / mover.inverse_mass;
  touch.slip_mass = static_cast<float>(1.0 / (static_cast<double>(mover.inverse_mass) * pile.kinds[mover.kind].give));
  const double middle = pile.start + 0.5 * pile.h - body.motion.start;
  touch.u = body.moving ? Vector3f(frameAt(body.motion, middle).pointVelocity(end - radius * gap.n_W).cast<float>())
                        : Vector3f(Vector3f::Zero());
  touch.friction = static_cast<float>(world.scene.surfaces.at(pile.params(i).material, shape.material).friction);
  touch.moving = body.moving;
  touch.material = shape.material;
  touch.link = l;
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

Push& pushOf(Pile& pile, const BodyTouch& touch)
{
  return touch.moving ? pile.moving[touch.link].push : pile.bodies[touch.link].push;
}

std::uint32_t ballOf(const Pile& pile, const BodyTouch& touch)
{
  return touch.moving ? pile.moving[touch.link].ball : pile.bodies[touch.link].ball;
}

// --- solving ---

// What friction adds, and keeps within the cone.
Vector3d slipImpulse(const Touch& touch, Push& push, const Vector3d& slip)
{
  Vector3f wanted = push.tangent - touch.slip_mass * slip.cast<float>();
  const float most = touch.friction * push.normal;
  const float needed = wanted.norm();
  if (needed > most) wanted *= most / needed;
  const Vector3f more = wanted - push.tangent;
  push.tangent = wanted;
  return more.cast<double>();
}

// What the normal impulse gains or loses; it never pulls.
double normalImpulse(const Touch& touch, Push& push, double normal_velocity)
{
  const float before = push.normal;
  push.normal = std::max(0.0f, before + touch.normal_mass * (touch.target - static_cast<float>(normal_velocity)));
  return static_cast<double>(push.normal - before);
}

void warmStart(Pile& pile)
{
  for (const BodyTouch& touch : pile.body_touches)
  {
    Push& push = pushOf(pile, touch);
    if (push.normal == 0.0f) continue;
    Mover& ball = pile.movers[ballOf(pile, touch)];
    const Vector3d n = touch.n.cast<double>();
    push.tangent -= touch.n.dot(push.tangent) * touch.n;
    ball.v += static_cast<double>(ball.inverse_mass * push.normal) * n;
    applySlip(pile, ball, n, push.tangent.cast<double>(), 1.0);
  }
  for (const Touch& touch : pile.touches)
  {
    PairLink& link = pile.pairs[touch.link];
    if (link.push.normal == 0.0f) continue;
    const Vector3d n = touch.n.cast<double>();
    link.push.tangent -= touch.n.dot(link.push.tangent) * touch.n;
    applyNormal(pile.movers[link.a], pile.movers[link.b], n, link.push.normal);
    const Vector3d slip = link.push.tangent.cast<double>();
    applySlip(pile, pile.movers[link.a], n, slip, 1.0);
    applySlip(pile, pile.movers[link.b], n, slip, -1.0);
  }
}

void solveBody(Pile& pile, const BodyTouch& touch, double small)
{
  Push& push = pushOf(pile, touch);
  Mover& ball = pile.movers[ballOf(pile, touch)];
  const Vector3d n = touch.n.cast<double>();
  const double impulse = normalImpulse(touch, push, n.dot(ball.v));
  const double per_mass = ball.inverse_mass;
  ball.v += (per_mass * impulse) * n;
  double change = std::abs(impulse);
  if (touch.friction > 0.0f && (push.normal > 0.0f || !push.tangent.isZero(0.0f)))
  {
    const BallKind& kind = pile.kinds[ball.kind];
    const Vector3d u = ball.v - touch.u.cast<double>();
    const Vector3d slip = u - n.dot(u) * n - kind.params.radius * ball.w.cross(n);
    const Vector3d sideways = slipImpulse(touch, push, slip);
    applySlip(pile, ball, n, sideways, 1.0);
    change += sideways.norm();
  }
  if (change * per_mass > small) ball.stamp = pile.counter;
}

void solvePair(Pile& pile, const Touch& touch, double small)
{
  PairLink& link = pile.pairs[touch.link];
  Mover &a = pile.movers[link.a], &b = pile.movers[link.b];
  const Vector3d n = touch.n.cast<double>();
  const double impulse = normalImpulse(touch, link.push, n.dot(a.v - b.v));
  applyNormal(a, b, n, impulse);
  double change = std::abs(impulse);
  if (touch.friction > 0.0f && (link.push.normal > 0.0f || !link.push.tangent.isZero(0.0f)))
  {
    const Vector3d u = a.v - b.v;
    const Vector3d spin = pile.radius(link.a) * a.w + pile.radius(link.b) * b.w;
    const Vector3d sideways = slipImpulse(touch, link.push, u - n.dot(u) * n - spin.cross(n));
    applySlip(pile, a, n, sideways, 1.0);
    applySlip(pile, b, n, sideways, -1.0);
    change += sideways.norm();
  }
  if (change * static_cast<double>(std::max(a.inverse_mass, b.inverse_mass)) > small) a.stamp = b.stamp = pile.counter;
}

// Every touch once; then those of balls that changed, forwards and backwards in turn, until nothing changes any more.
void iterate(Pile& pile)
{
  const double small = kGoodEnough * pile.least_impact;
  std::uint32_t since = 0;
  for (int iteration = 0; iteration < kMostIterations; ++iteration)
  {
    const std::uint32_t now = ++pile.counter;
    bool any = false;
    const auto changed = [&](std::uint32_t i) { return pile.movers[i].stamp >= since; };
    const auto pair = [&](const Touch& touch) {
      const PairLink& link = pile.pairs[touch.link];
      if (!changed(link.a) && !changed(link.b)) return;
      solvePair(pile, touch, small);
      any |= pile.movers[link.a].stamp == now;
    };
    for (const BodyTouch& touch : pile.body_touches)
    {
      const std::uint32_t i = ballOf(pile, touch);
      if (!changed(i)) continue;
      solveBody(pile, touch, small);
      any |= pile.movers[i].stamp == now;
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
  Mover& ball = pile.movers[ballOf(pile, touch)];
  const BallKind& kind = pile.kinds[ball.kind];
  const Surface& law = world.scene.surfaces.at(kind.params.material, touch.material);
  if (law.rolling_resistance == 0.0 && law.spin_friction == 0.0) return;
  const double load = static_cast<double>(pushOf(pile, touch).normal * ball.inverse_mass);  // [m/s]
  const Vector3d n = touch.n.cast<double>();
  const Vector3d u = ball.v - touch.u.cast<double>();
  const Vector3d along = u - n.dot(u) * n;
  if (const double speed = along.norm(); speed > 0.0)
  {
    const Vector3d less = (-std::min(1.0, law.rolling_resistance * load / speed)) * along;
    ball.v += less;
    ball.w += n.cross(less) / kind.params.radius;
  }
  const double spin = n.dot(ball.w);
  const double most = law.spin_friction * load * kind.spin_per_impulse;
  ball.w -= std::clamp(spin, -most, most) * n;
}

void markLoaded(Pile& pile)
{
  for (const std::uint32_t i : pile.awake) pile.movers[i].loaded = false;
  for (const BodyTouch& touch : pile.body_touches)
    if (pushOf(pile, touch).normal > 0.0f) pile.movers[ballOf(pile, touch)].loaded = true;
  for (const Touch& touch : pile.touches)
  {
    const PairLink& link = pile.pairs[touch.link];
    if (link.push.normal == 0.0f) continue;
    for (const std::uint32_t i : {link.a, link.b})
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
  for (const Touch& touch : pile.touches) watch(pile, pile.pairs[touch.link]);
  markLoaded(pile);
}
}  // namespace ping_pong
