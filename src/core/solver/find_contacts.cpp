#include <algorithm>
#include <cmath>

#include "geometry/tangential.h"
#include "solver/contact_forces.h"
#include "solver/seams.h"

namespace ping_pong
{
namespace
{
using Eigen::Vector3f;

constexpr double kCaught =
    1.0;  // part of the way in a step by which a contact with a third ball may bring two together
constexpr double kSqueezed = 5e-4;       // a ball that is deeper in a body has no room [m]
constexpr std::size_t kMoreFound = 256;  // places at a time; what an earlier step has left there is overwritten
constexpr double kSamePlace = 1e-12;     // two balls nearer than this have no direction [m]
constexpr double kForgets = 2e-3;        // deeper than this the last impulses are no guide [m]

// How near a pair has to come to be in contact, on its own: balls that others push may come nearer yet.
double reachOf(const ContactSolver& solver)
{
  return 4.0 * solver.least_impact * solver.h + 1e-6;
}

bool hitInThisStep(const ContactSolver& solver, std::size_t i)
{
  return solver.movers[i].last_impact >= solver.step_mark;
}

// One of them has fallen asleep, or none does any more: see ContactSolver::force_at_sleep.
void updateForceAtSleep(ContactSolver& solver, std::uint32_t l, bool one_sleeps)
{
  float& force_at_sleep = solver.force_at_sleep[l];
  if (!one_sleeps)
    force_at_sleep = -1.0f;
  else if (force_at_sleep < 0.0f)
    force_at_sleep = solver.impulses[l][3] / static_cast<float>(solver.h);
}

void clearContact(ContactSolver& solver, SolverSlab& slab, std::uint32_t l, bool one_sleeps)
{
  if (one_sleeps) wakeIfForceChanged(solver, slab, l, 0.0f);
  solver.force_at_sleep[l] = -1.0f;
  solver.impulses[l] = Lanes{};
}

void findPairContact(ContactSolver& solver, SolverSlab& slab, std::uint32_t l)
{
  const NeighbourPair& pair = solver.pairs[l];
  const Mover &a = solver.movers[pair.a], &b = solver.movers[pair.b];
  const double reach = solver.reach(pair.a, pair.b);
  const Vector3d d = a.p - b.p;
  const Vector3d u = a.v - b.v;
  Vector3d d_end = d + solver.h * u;
  const double square = d_end.squaredNorm();
  const double fast = std::sqrt(2.0 * (a.v.squaredNorm() + b.v.squaredNorm()));  // no less than the sum of their speeds
  const double most = reach + reachOf(solver) + kCaught * solver.h * fast;
  const bool one_sleeps = a.asleep != b.asleep;
  updateForceAtSleep(solver, l, one_sleeps);
  if (square > most * most) return clearContact(solver, slab, l, one_sleeps);
  if (square < kSamePlace * kSamePlace) d_end = kSamePlace * Vector3d::UnitZ();
  const bool hit = hitInThisStep(solver, pair.a) || hitInThisStep(solver, pair.b);
  const double room =
      hit ? 0.0 : std::min(d.squaredNorm() - reach * reach, 0.0);  // what there was at the start does not count
  const bool forgets = room < -kForgets * (2.0 * reach - kForgets);
  const ConstraintIndex index = slab.open_pairs.add(slab.pair_batches, pair.a, pair.b);
  if (slab.found.size() <= index.value)
  {
    slab.found.resize(index.value + kMoreFound);
    slab.pair_of.resize(index.value + kMoreFound);
  }
  slab.pair_of[index.value] = l;
  FoundPair& found = slab.found[index.value];
  found.way = lanesOf(d_end, square - reach * reach);
  found.u = lanesOf(u, room);
  found.impulse = forgets ? Lanes{} : solver.impulses[l];
}

// Any ball may be thrown at a body by the fastest one.
double reachOfBodies(const ContactSolver& solver)
{
  double squared = 0.0;
  for (const SolverSlab& slab : solver.slabs) squared = std::max(squared, slab.fastest_squared);
  return reachOf(solver) + kCaught * solver.h * std::sqrt(squared);
}

// A surface takes over from the one that it continues: with the impulses that the ball had there in the last step.
void transferImpulses(ContactSolver& solver, SolverSlab& slab, std::uint32_t from, std::uint32_t to)
{
  BodyNeighbour& old = solver.bodies[from];
  if (!(old.impulse[3] > 0.0f)) return;
  if (to > from)
    solver.bodies[to].impulse += old.impulse;
  else
    for (const BodyConstraint& constraint : slab.body_constraints)  // it has been found
    {
      if (constraint.moving || constraint.neighbour != to) continue;
      ConstraintBatch& batch = slab.body_batches[constraint.index.batch()];
      const std::size_t lane = constraint.index.lane();
      batch.tangent.set(lane,
                        Vector3f(batch.tangent.at(lane) + Vector3f(old.impulse[0], old.impulse[1], old.impulse[2])));
      batch.normal[lane] += old.impulse[3];
    }
  old.impulse = Lanes{};
}

// Room at the start of the step. A shape to which the ball has come across a seam continues the one that it lay on before.
double roomAtStart(const WorldWithSolver& world, const BodyNeighbour& neighbour)
{
  const ContactSolver& solver = world.solver;
  if (hitInThisStep(solver, neighbour.ball)) return 0.0;
  const Vector3d& p = solver.movers[neighbour.ball].p;
  const Proximity near = nearestOf(world, neighbour, p, 0.0);
  if (!near.flat())
    if (const Seam seam = seamWith(world, neighbour, near, p, 0.0); seam.there)
      return seam.surface.distance - solver.radius(neighbour.ball);
  return near.distance - solver.radius(neighbour.ball);
}

// A constraint of a ball, at its place at the end of the step, and what of a shape is nearest to it there.
void addConstraint(WorldWithSolver& world, SolverSlab& slab, std::uint32_t l, const BodyNeighbour& neighbour,
                   const Vector3d& end, const Proximity& near)
{
  ContactSolver& solver = world.solver;
  const std::uint32_t i = neighbour.ball;
  const Mover& mover = solver.movers[i];
  const BodyRecord& body = world.bodies[neighbour.body];
  const MaterialId material = body.shapes()[neighbour.shape].material;
  const double radius = solver.radius(i);
  const double overlap = std::max(-roomAtStart(world, neighbour), 0.0);
  slab.squeezed += solver.moving.empty() && overlap > kSqueezed;
  solver.changes[i].p.head<3>() += (overlapCorrection(overlap) * near.normal).cast<float>();
  const SolverBallType& type = solver.ball_types[mover.type];
  const double middle = solver.start + 0.5 * solver.h - body.motion.start;
  const Vector3d u =
      body.moving ? frameAt(body.motion, middle).pointVelocity(end - radius * near.normal) : Vector3d(Vector3d::Zero());
  const ConstraintIndex index = slab.open_bodies.add(slab.body_batches, i, ConstraintBatch::kBody);
  slab.body_constraints.push_back({u, l, index, i, material, body.moving});
  ConstraintBatch& batch = slab.body_batches[index.batch()];
  const std::size_t lane = index.lane();
  const Vector3d v = mover.v - u;
  const Vector3f n = near.normal.cast<float>();
  batch.n.set(lane, n);
  batch.slip.set(lane,
                 Vector3f(tangential(v, near.normal).cast<float>() - solver.changes[i].before.head<3>().cross(n)));
  const Lanes impulse = overlap > kForgets ? Lanes{} : neighbour.impulse;
  batch.tangent.set(lane, Vector3f(impulse[0], impulse[1], impulse[2]));
  batch.normal[lane] = impulse[3];
  batch.target[lane] = static_cast<float>(-(overlap + (near.distance - radius)) / solver.h);
  batch.normal_mass[lane] = static_cast<float>(type.params.mass);
  batch.slip_mass[lane] = static_cast<float>(type.params.mass / type.slip_per_impulse);
  batch.friction[lane] = static_cast<float>(world.scene.surfaces.at(type.params.material, material).friction);
}

void findBodyContact(WorldWithSolver& world, SolverSlab& slab, std::uint32_t l, BodyNeighbour& neighbour, double reach)
{
  ContactSolver& solver = world.solver;
  const Mover& mover = solver.movers[neighbour.ball];
  const bool moving = world.bodies[neighbour.body].moving;
  const Vector3d end = mover.p + solver.h * mover.v;
  const Proximity near = nearestOf(world, neighbour, end, solver.h);
  if (near.distance - solver.radius(neighbour.ball) > reach)
  {
    neighbour.impulse = Lanes{};
    return;
  }
  if (!near.flat())
    if (const Seam seam = seamWith(world, neighbour, near, end, solver.h); seam.there)
    {
      if (!moving) transferImpulses(solver, slab, l, seam.neighbour);
      return;
    }
  if (moving && mover.asleep)
  {
    solver.wake(neighbour.ball);
    clearChange(solver, neighbour.ball);
  }
  addConstraint(world, slab, l, neighbour, end, near);
}

void findInSlab(WorldWithSolver& world, SolverSlab& slab, double reach_of_bodies)
{
  ContactSolver& solver = world.solver;
  for (const std::uint32_t l : slab.active_bodies) findBodyContact(world, slab, l, solver.bodies[l], reach_of_bodies);
  for (const std::uint32_t l : slab.active_pairs) findPairContact(solver, slab, l);
}
}  // namespace

void findContacts(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  const double reach = reachOfBodies(solver);
  for (std::uint32_t l = 0; l < solver.moving.size(); ++l)
    findBodyContact(world, solver.slabs[solver.slab_of[solver.moving[l].ball]], l, solver.moving[l], reach);
  updateActive(world);  // who meets a body that moves is awake
  inRedBlackOrder(world,
                  [&world, reach](SolverSlab& slab)
                  {
                    findInSlab(world, slab, reach);
                    startConstraints(world, slab);
                  });
}
}  // namespace ping_pong
