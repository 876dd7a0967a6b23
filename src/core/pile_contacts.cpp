// Contacts that carry load: projected Gauss-Seidel iteration on impulses (Jean and Moreau, "Unilaterality and dry friction in
// the dynamics of rigid body collections", 1992; "sequential impulses" in games), warm started. A contact may not close further
// than its gap within the step; friction stays in Coulomb's cone. No contact pushes balls apart: what little overlap is left by
// an iteration that was cut short is taken out of the places, not given to the velocities.
//
// Impulses, and what they change of the velocities, have 24 bits.
#include "pile_contacts.h"

#include <algorithm>
#include <cmath>

#include "count.h"

namespace ping_pong
{
namespace
{
using Eigen::Vector4f;

constexpr int kMostSweeps = 12;
constexpr double kGoodEnough = 0.03;    // change of a velocity that is not passed on, in least impacts,
constexpr double kCreep = 6e-4;         // or less: a pile that creeps faster does not fall asleep [m/s]
constexpr double kWakingForce = 0.3;    // change of a force on a sleeping ball that wakes it up: so much of its weight,
constexpr double kWakingPart = 0.5;     // and so much of the force; deep in a pile forces sway by more than a weight

// In free flight the forces act for half of the step before the contacts and for half after them; on a ball that something
// carries, for all of it before them. Whoever is caught owes the second half to the next step.
Vector3d kick(const Pile& pile, std::size_t i)
{
  const Mover& mover = pile.movers[i];
  const double halves = (mover.was_loaded ? 2.0 : 1.0) + (mover.half_owed ? 1.0 : 0.0);
  return (0.5 * halves * pile.h) * pile.flightAcceleration(i);
}

// What acts before the contacts.
void startContacts(Pile& pile, PileShare& share)
{
  share.touches.clear();
  share.held.clear();
  share.body_touches.clear();
  share.waking.clear();
  for (const std::uint32_t i : share.awake)
  {
    Mover& mover = pile.movers[i];
    mover.was_loaded = mover.loaded;
    mover.v += kick(pile, i);
    pile.changes[i].fast = static_cast<float>(mover.v.norm());
    clearChange(pile, i);
  }
}

// --- one touch ---

// What the normal impulse gains or loses; it never pulls.
float normalImpulse(Touch& touch, float along)
{
  const float before = touch.normal;
  touch.normal = std::max(0.0f, before + touch.normal_mass * (touch.target - along));
  return touch.normal - before;
}

// What friction adds, and keeps within the cone.
Vector4f slipImpulse(Touch& touch, const Vector4f& slip)
{
  const Vector4f before = touch.tangent;
  touch.tangent -= touch.slip_mass * slip;
  const float most = touch.friction * touch.normal;
  const float needed = touch.tangent.squaredNorm();
  if (needed > most * most) touch.tangent *= most / std::sqrt(needed);
  return touch.tangent - before;
}

// Where nothing presses, nothing rubs.
bool idle(const Touch& touch, float impulse) { return impulse == 0.0f && touch.normal == 0.0f; }

// Both return whether a velocity has changed by more than the root of `small`.
bool solveBody(Pile& pile, BodyTouch& touch, float small)
{
  Change& ball = pile.changes[touch.a];
  const float along = touch.n.dot(ball.v);
  const float impulse = normalImpulse(touch, along);
  if (idle(touch, impulse)) return false;
  float square = impulse * impulse;
  Vector4f all = impulse * touch.n;
  if (touch.friction > 0.0f)
  {
    const Vector4f across = slipImpulse(touch, touch.slip + ball.v - along * touch.n - ball.rim.cross3(touch.n));
    square += across.squaredNorm();
    all += across;
    ball.rim -= ball.rim_per_impulse * touch.n.cross3(across);
  }
  ball.v += ball.per_impulse * all;
  return square * ball.per_impulse * ball.per_impulse > small;
}

bool solvePair(Change& a, Change& b, Touch& touch, float small)
{
  const Vector4f n = touch.n;
  const Vector4f u = a.v - b.v;
  const float along = n.dot(u);
  const float impulse = normalImpulse(touch, along);
  if (idle(touch, impulse)) return false;
  float square = impulse * impulse;
  Vector4f all = impulse * n;
  if (touch.friction > 0.0f)
  {
    const Vector4f rims = a.rim + b.rim;
    const Vector4f across = slipImpulse(touch, touch.slip + u - along * n - rims.cross3(n));
    square += across.squaredNorm();
    all += across;
    const Vector4f turn = n.cross3(across);
    a.rim -= a.rim_per_impulse * turn;
    b.rim -= b.rim_per_impulse * turn;
  }
  a.v += a.per_impulse * all;
  b.v -= b.per_impulse * all;
  const float lighter = std::max(a.per_impulse, b.per_impulse);
  return square * lighter * lighter > small;
}

void warmStart(Pile& pile, PileShare& share)
{
  const auto start = [&pile](Touch& touch, bool pair) {
    if (touch.normal == 0.0f) return;
    touch.tangent -= touch.n.dot(touch.tangent) * touch.n;
    const Vector4f all = touch.normal * touch.n + touch.tangent, turn = touch.n.cross3(touch.tangent);
    Change& a = pile.changes[touch.a];
    a.v += a.per_impulse * all;
    a.rim -= a.rim_per_impulse * turn;
    if (!pair) return;
    Change& b = pile.changes[touch.b];
    b.v -= b.per_impulse * all;
    b.rim -= b.rim_per_impulse * turn;
  };
  for (BodyTouch& touch : share.body_touches) start(touch, false);
  for (Touch& touch : share.touches) start(touch, true);
}

// A sweep over the touches of a slab, those left out whose balls have not changed.
struct Sweep
{
  std::uint32_t since;  // on the counter of the pile: changes that touches do not know
  std::uint32_t now;
  float small;          // square of a change of a velocity that is not passed on [m^2/s^2]
};

void sweep(Pile& pile, PileShare& share, const Sweep& it, bool forwards)
{
  for (BodyTouch& touch : share.body_touches)
  {
    if (pile.changes[touch.a].sweep < it.since || !solveBody(pile, touch, it.small)) continue;
    pile.changes[touch.a].sweep = share.changed = it.now;
  }
  const auto pair = [&](Touch& touch) {
    Change &a = pile.changes[touch.a], &b = pile.changes[touch.b];
    if ((a.sweep < it.since && b.sweep < it.since) || !solvePair(a, b, touch, it.small)) return;
    a.sweep = b.sweep = share.changed = it.now;
  };
  if (forwards)
    std::for_each(share.touches.begin(), share.touches.end(), pair);
  else
    std::for_each(share.touches.rbegin(), share.touches.rend(), pair);
}

// Nobody who writes to a ball of this share has changed any. (Those who do are not at work at the same time.)
bool quiet(const Pile& pile, const PileShare& share, std::uint32_t since)
{
  const std::size_t s = static_cast<std::size_t>(&share - pile.shares.data());
  if (s >= pile.slabs) return false;
  return share.changed < since && pile.shares.back().changed < since && (s == 0 || pile.shares[s - 1].changed < since) &&
         (s + 1 == pile.slabs || pile.shares[s + 1].changed < since);
}

// Every touch once; then those of balls that changed, forwards and backwards in turn, until nothing changes any more.
void iterate(WorldState& world)
{
  Pile& pile = world.pile;
  const float least = static_cast<float>(std::min(kGoodEnough * pile.least_impact, kCreep)), small = least * least;
  std::uint32_t before = 0;
  for (int k = 0; k < kMostSweeps; ++k)
  {
    const std::uint32_t now = ++pile.counter;
    inTurns(world,
            [&](PileShare& share)
            {
              if (!quiet(pile, share, before)) sweep(pile, share, {before, now, small}, k % 2 == 0);
            });
    if (std::none_of(pile.shares.begin(), pile.shares.end(), [&](const PileShare& share) { return share.changed == now; })) break;
    before = now;
  }
}

void takeChanges(Pile& pile, const PileShare& share)
{
  for (const std::uint32_t i : share.awake)
  {
    const Change& change = pile.changes[i];
    pile.movers[i].v += change.v.head<3>().cast<double>();
    pile.movers[i].loaded = false;
    pile.w[i] += change.rim.head<3>().cast<double>() / pile.radius(i);
  }
}

// Rolling resistance c_r N against the roll, spin friction c_s N against the spin about the normal; see docs/physics.md.
void resist(WorldState& world, const BodyTouch& touch)
{
  Pile& pile = world.pile;
  Mover& ball = pile.movers[touch.a];
  Vector3d& w = pile.w[touch.a];
  const BallKind& kind = pile.kinds[ball.kind];
  const Surface& law = world.scene.surfaces.at(kind.params.material, touch.material);
  if (law.rolling_resistance == 0.0 && law.spin_friction == 0.0) return;
  const double load = static_cast<double>(touch.normal * pile.changes[touch.a].per_impulse);  // [m/s]
  const Vector3d n = touch.n.head<3>().cast<double>();
  const Vector3d u = ball.v - touch.u;
  const Vector3d along = u - n.dot(u) * n;
  if (const double speed = along.norm(); law.rolling_resistance > 0.0 && speed > 0.0)
  {
    count(Law::RollingResistance);
    const Vector3d less = (-std::min(1.0, law.rolling_resistance * load / speed)) * along;
    ball.v += less;
    w += n.cross(less) / kind.params.radius;
  }
  if (law.spin_friction == 0.0) return;
  count(Law::SpinFriction);
  const double spin = n.dot(w);
  const double most = law.spin_friction * load * kind.spin_per_impulse;
  w -= std::clamp(spin, -most, most) * n;
}

Push pushOf(const Touch& touch) { return {touch.normal, touch.tangent.head<3>()}; }

// For the next step, and to tell whom something carries.
void keepPushes(Pile& pile, PileShare& share)
{
  for (const BodyTouch& touch : share.body_touches)
  {
    if (!touch.moving) pile.bodies[touch.link].push = pushOf(touch);
    if (touch.normal > 0.0f) pile.movers[touch.a].loaded = true;
  }
  share.kept.clear();
  for (std::size_t k = 0; k < share.touches.size(); ++k)
  {
    const Touch& touch = share.touches[k];
    share.kept.push_back({touch.link, pushOf(touch), share.held[k]});
    if (share.held[k] >= 0.0f) watch(pile, share, pile.pairs[touch.link], touch.normal, share.held[k]);
    if (touch.normal == 0.0f) continue;
    pile.untouched[touch.a] = pile.untouched[touch.b] = 0.0f;
    for (const std::uint32_t i : {touch.a, touch.b})
      if (!pile.movers[i].asleep) pile.movers[i].loaded = true;
  }
}
}  // namespace

void clearChange(Pile& pile, std::uint32_t i)
{
  const BallKind& kind = pile.kinds[pile.movers[i].kind];
  Change& change = pile.changes[i];
  change.v.setZero();
  change.rim.setZero();
  change.per_impulse = static_cast<float>(kind.inverse_mass);
  change.rim_per_impulse = static_cast<float>(kind.inverse_mass / kind.params.inertia);
}

void watch(Pile& pile, PileShare& share, const PairLink& link, float normal, float held)
{
  const std::uint32_t sleeper = pile.movers[link.a].asleep ? link.a : link.b;
  const float force = normal / static_cast<float>(pile.h);
  const double weight = pile.params(sleeper).mass * pile.flightAcceleration(sleeper).norm();
  if (std::abs(force - held) > std::max(kWakingForce * weight, kWakingPart * static_cast<double>(held))) share.waking.push_back(sleeper);
}

void solveContacts(WorldState& world)
{
  Pile& pile = world.pile;
  eachShare(world, [&pile](PileShare& share) { startContacts(pile, share); });
  gatherTouches(world);
  inTurns(world, [&pile](PileShare& share) { warmStart(pile, share); });
  iterate(world);
  eachShare(world,
            [&](PileShare& share)
            {
              takeChanges(pile, share);
              for (const BodyTouch& touch : share.body_touches) resist(world, touch);
            });
  inTurns(world, [&pile](PileShare& share) { keepPushes(pile, share); });
}
}  // namespace ping_pong
