// Contacts that carry load: projected Gauss-Seidel iteration on impulses (Jean and Moreau, "Unilaterality and dry friction in
// the dynamics of rigid body collections", 1992; "sequential impulses" in games), warm started. A contact may not close further
// than its gap within the step; friction stays in Coulomb's cone. No contact pushes balls apart: what little overlap is left by
// an iteration that was cut short is taken out of the places, not given to the velocities.
//
// Impulses, and what they change of the velocities, have 24 bits.
#include "solver/contact_forces.h"

#include <algorithm>
#include <cmath>

#include "base/law_counter.h"
#include "geometry/tangential.h"

namespace ping_pong
{
namespace
{
using Eigen::Vector3f;

constexpr double kWakingForce = 0.3;  // change of a force on a sleeping ball that wakes it up: so much of its weight,
constexpr double kWakingPart = 0.5;   // and so much of the force; deep in a pile forces sway by more than a weight

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
  share.body_touches.clear();
  share.pair_batches.clear();
  share.body_batches.clear();
  share.open_pairs = share.open_bodies = OpenBatches();
  share.waking.clear();
  share.fastest_squared = 0.0;
  for (const std::uint32_t i : share.awake)
  {
    Mover& mover = pile.movers[i];
    mover.was_loaded = mover.loaded;
    mover.v += kick(pile, i);
    clearChange(pile, i);
    share.fastest_squared = std::max(share.fastest_squared, mover.v.squaredNorm());
  }
}

void takeChanges(Pile& pile, const PileShare& share)
{
  for (const std::uint32_t i : share.awake)
  {
    const Change& change = pile.changes[i];
    pile.movers[i].v += change.v.head<3>().cast<double>();
    pile.movers[i].p += change.p.head<3>().cast<double>();
    pile.w[i] += change.rim.head<3>().cast<double>() / pile.radius(i);
  }
}

// Rolling resistance c_r N against the roll, spin friction c_s N against the spin about the normal; see docs/physics.md.
void resist(WorldWithSolver& world, const PileShare& share, const BodyTouch& touch)
{
  Pile& pile = world.pile;
  Mover& ball = pile.movers[touch.ball];
  Vector3d& w = pile.w[touch.ball];
  const BallKind& kind = pile.kinds[ball.kind];
  const Surface& law = world.scene.surfaces.at(kind.params.material, touch.material);
  if (law.rolling_resistance == 0.0 && law.spin_friction == 0.0) return;
  const TouchBatch& batch = share.body_batches[touch.place.batch()];
  const std::size_t lane = touch.place.lane();
  const double load = static_cast<double>(batch.normal[lane] * pile.changes[touch.ball].v.w());  // [m/s]
  const Vector3d n = batch.n.at(lane).cast<double>();
  const Vector3d u = ball.v - touch.u;
  const Vector3d along = tangential(u, n);
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

// For the next step, and to tell whom something carries.
void keepBodies(Pile& pile, const PileShare& share)
{
  for (const BodyTouch& touch : share.body_touches)
  {
    const TouchBatch& batch = share.body_batches[touch.place.batch()];
    const std::size_t lane = touch.place.lane();
    const float normal = batch.normal[lane];
    if (!touch.moving) pile.bodies[touch.link].push = lanesOf(batch.tangent.at(lane), static_cast<double>(normal));
    if (normal > 0.0f) pile.pushed[touch.ball] |= Pile::kCarried;
  }
}

void keepPairs(Pile& pile, PileShare& share)
{
  for (std::size_t p = 0; p < share.pair_batches.size(); ++p)
  {
    const TouchBatch& batch = share.pair_batches[p];
    const std::array<Lanes, kLanes> pushes = recordsOf(batch.tangent, batch.normal);
    for (std::size_t k = 0; k < kLanes && batch.has(k); ++k)
    {
      const std::uint32_t l = share.pair_links[kLanes * p + k];
      pile.pushes[l] = pushes[k];
      if (pile.held[l] >= 0.0f) watch(pile, share, l, batch.normal[k]);
      const std::uint8_t how = batch.normal[k] > 0.0f ? Pile::kCarried | Pile::kTouched : 0;
      pile.pushed[batch.a[k]] |= how;
      pile.pushed[batch.b[k]] |= how;
    }
  }
}
}  // namespace

void clearChange(Pile& pile, std::uint32_t i)
{
  const BallKind& kind = pile.kinds[pile.movers[i].kind];
  Change& change = pile.changes[i];
  change.v << Vector3f::Zero(), static_cast<float>(kind.inverse_mass);
  change.rim << Vector3f::Zero(), static_cast<float>(kind.inverse_mass / kind.params.inertia);
  change.before << (kind.params.radius * pile.w[i]).cast<float>(), 0.0f;
  change.p.setZero();
  pile.pushed[i] = 0;
}

void watch(const Pile& pile, PileShare& share, std::uint32_t l, float normal)
{
  const float held = pile.held[l];
  const double change = std::abs(static_cast<double>(normal) / pile.h - static_cast<double>(held));
  if (change <= kWakingPart * static_cast<double>(held)) return;
  const PairLink& link = pile.pairs[l];
  const std::uint32_t sleeper = pile.movers[link.a].asleep ? link.a : link.b;
  const double weight = pile.params(sleeper).mass * pile.flightAcceleration(sleeper).norm();
  if (change > kWakingForce * weight) share.waking.push_back(sleeper);
}

void takeContacts(WorldWithSolver& world, const PileShare& share)
{
  takeChanges(world.pile, share);
  for (const BodyTouch& touch : share.body_touches) resist(world, share, touch);
}

void solveContacts(WorldWithSolver& world)
{
  Pile& pile = world.pile;
  eachShare(world, [&pile](PileShare& share) { startContacts(pile, share); });
  gatherTouches(world);
  iterate(world);
  inTurns(world,
          [&pile](PileShare& share)
          {
            keepBodies(pile, share);
            keepPairs(pile, share);
          });
}
}  // namespace ping_pong
