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
constexpr double kWakingPart = 0.5;   // and so much of the force; deep in a heap forces sway by more than a weight

// In free flight the forces act for half of the step before the contacts and for half after them; on a ball that something
// carries, for all of it before them. The second half for a ball that is caught is due in the next step.
Vector3d kick(const ContactSolver& solver, std::size_t i)
{
  const Mover& mover = solver.movers[i];
  const double halves = (mover.was_carried ? 2.0 : 1.0) + (mover.half_kick_due ? 1.0 : 0.0);
  return (0.5 * halves * solver.h) * solver.flightAcceleration(i);
}

// What acts before the contacts.
void startContacts(ContactSolver& solver, SolverSlab& slab)
{
  slab.body_constraints.clear();
  slab.pair_batches.clear();
  slab.body_batches.clear();
  slab.open_pairs = slab.open_bodies = OpenBatches();
  slab.waking.clear();
  slab.fastest_squared = 0.0;
  for (const std::uint32_t i : slab.awake)
  {
    Mover& mover = solver.movers[i];
    mover.was_carried = mover.carried;
    mover.v += kick(solver, i);
    clearChange(solver, i);
    slab.fastest_squared = std::max(slab.fastest_squared, mover.v.squaredNorm());
  }
}

void applyChanges(ContactSolver& solver, const SolverSlab& slab)
{
  for (const std::uint32_t i : slab.awake)
  {
    const Change& change = solver.changes[i];
    solver.movers[i].v += change.v.head<3>().cast<double>();
    solver.movers[i].p += change.p.head<3>().cast<double>();
    solver.w[i] += change.surface_velocity.head<3>().cast<double>() / solver.radius(i);
  }
}

// Rolling resistance c_r N against the roll, spin friction c_s N against the spin about the normal; see docs/physics.md.
void resist(WorldWithSolver& world, const SolverSlab& slab, const BodyConstraint& constraint)
{
  ContactSolver& solver = world.solver;
  Mover& ball = solver.movers[constraint.ball];
  Vector3d& w = solver.w[constraint.ball];
  const SolverBallType& type = solver.ball_types[ball.type];
  const Surface& law = world.scene.surfaces.at(type.params.material, constraint.material);
  if (law.rolling_resistance == 0.0 && law.spin_friction == 0.0) return;
  const ConstraintBatch& batch = slab.body_batches[constraint.index.batch()];
  const std::size_t lane = constraint.index.lane();
  const double load = static_cast<double>(batch.normal[lane] * solver.changes[constraint.ball].v.w());  // [m/s]
  const Vector3d n = batch.n.at(lane).cast<double>();
  const Vector3d u = ball.v - constraint.u;
  const Vector3d along = tangential(u, n);
  if (const double speed = along.norm(); law.rolling_resistance > 0.0 && speed > 0.0)
  {
    count(Law::RollingResistance);
    const Vector3d less = (-std::min(1.0, law.rolling_resistance * load / speed)) * along;
    ball.v += less;
    w += n.cross(less) / type.params.radius;
  }
  if (law.spin_friction == 0.0) return;
  count(Law::SpinFriction);
  const double spin = n.dot(w);
  const double most = law.spin_friction * load * type.spin_per_impulse;
  w -= std::clamp(spin, -most, most) * n;
}

// For the next step, and to tell whom something carries.
void keepBodies(ContactSolver& solver, const SolverSlab& slab)
{
  for (const BodyConstraint& constraint : slab.body_constraints)
  {
    const ConstraintBatch& batch = slab.body_batches[constraint.index.batch()];
    const std::size_t lane = constraint.index.lane();
    const float normal = batch.normal[lane];
    if (!constraint.moving)
      solver.bodies[constraint.neighbour].impulse = lanesOf(batch.tangent.at(lane), static_cast<double>(normal));
    if (normal > 0.0f) solver.carried_by[constraint.ball] |= ContactSolver::kCarried;
  }
}

void keepPairs(ContactSolver& solver, SolverSlab& slab)
{
  for (std::size_t p = 0; p < slab.pair_batches.size(); ++p)
  {
    const ConstraintBatch& batch = slab.pair_batches[p];
    const std::array<Lanes, kLanes> impulses = recordsOf(batch.tangent, batch.normal);
    for (std::size_t k = 0; k < kLanes && batch.has(k); ++k)
    {
      const std::uint32_t l = slab.pair_of[kLanes * p + k];
      solver.impulses[l] = impulses[k];
      if (solver.force_at_sleep[l] >= 0.0f) wakeIfForceChanged(solver, slab, l, batch.normal[k]);
      const std::uint8_t how = batch.normal[k] > 0.0f ? ContactSolver::kCarried | ContactSolver::kByBall : 0;
      solver.carried_by[batch.a[k]] |= how;
      solver.carried_by[batch.b[k]] |= how;
    }
  }
}
}  // namespace

void clearChange(ContactSolver& solver, std::uint32_t i)
{
  const SolverBallType& type = solver.ball_types[solver.movers[i].type];
  Change& change = solver.changes[i];
  change.v << Vector3f::Zero(), static_cast<float>(type.inverse_mass);
  change.surface_velocity << Vector3f::Zero(), static_cast<float>(type.inverse_mass / type.params.inertia);
  change.before << (type.params.radius * solver.w[i]).cast<float>(), 0.0f;
  change.p.setZero();
  solver.carried_by[i] = 0;
}

void wakeIfForceChanged(const ContactSolver& solver, SolverSlab& slab, std::uint32_t l, float normal)
{
  const float force_at_sleep = solver.force_at_sleep[l];
  const double change = std::abs(static_cast<double>(normal) / solver.h - static_cast<double>(force_at_sleep));
  if (change <= kWakingPart * static_cast<double>(force_at_sleep)) return;
  const NeighbourPair& pair = solver.pairs[l];
  const std::uint32_t sleeper = solver.movers[pair.a].asleep ? pair.a : pair.b;
  const double weight = solver.params(sleeper).mass * solver.flightAcceleration(sleeper).norm();
  if (change > kWakingForce * weight) slab.waking.push_back(sleeper);
}

void applyContacts(WorldWithSolver& world, const SolverSlab& slab)
{
  applyChanges(world.solver, slab);
  for (const BodyConstraint& constraint : slab.body_constraints) resist(world, slab, constraint);
}

void solveContacts(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  eachSlab(world, [&solver](SolverSlab& slab) { startContacts(solver, slab); });
  findContacts(world);
  iterate(world);
  inRedBlackOrder(world,
                  [&solver](SolverSlab& slab)
                  {
                    keepBodies(solver, slab);
                    keepPairs(solver, slab);
                  });
}
}  // namespace ping_pong
