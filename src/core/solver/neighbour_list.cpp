// Who may touch whom: pairs of balls whose ways for a while come near each other, until a ball leaves its way.
#include <algorithm>
#include <cmath>

#include "base/law_counter.h"
#include "solver/neighbour_grid.h"
#include "solver/slabs.h"

namespace ping_pong
{
namespace
{
using Eigen::Vector3f;

constexpr double kMargin = 0.08;     // around the way of a ball along which neighbours are searched, in mean radii
constexpr double kStepsAhead = 8.0;  // length of that way, in steps of length h,
constexpr double kRadiiAhead = 2.0;  // unless it is longer than this; one step at least
constexpr std::size_t kManyStrays = 1000;  // balls that may leave their boxes before all neighbours are searched anew,
constexpr std::size_t kStrayPart = 8;      // and one in so many of them

Vector3d endOfStep(const ContactSolver& solver, std::size_t i)
{
  const Vector3d a = solver.pathAcceleration(i);
  return solver.movers[i].p + solver.h * (solver.movers[i].v + (0.5 * solver.h) * a);
}

bool covered(const ContactSolver& solver, std::size_t i)
{
  const Vector3f way = (endOfStep(solver, i) - solver.home[i]).cast<float>();
  if (way.squaredNorm() <= solver.margin * solver.margin) return true;
  const Vector3f& displacement = solver.displacement[i];
  const float round = 0.5f * displacement.norm() + solver.margin;
  return ((way - displacement.cwiseMax(0.0f)).array() <= solver.margin).all() &&
         ((displacement.cwiseMin(0.0f) - way).array() <= solver.margin).all() &&
         (way - 0.5f * displacement).squaredNorm() <= round * round;
}

// A box around the way from home. After an impact in this step the way begins where it happened.
void coverWay(ContactSolver& solver, std::size_t i)
{
  const Mover& mover = solver.movers[i];
  const Vector3d a = solver.pathAcceleration(i);
  const double t = mover.clock;
  const Vector3d from = solver.movers[i].p + t * (mover.v + (0.5 * t) * a);
  solver.anchor[i] += (solver.home[i] - from).cast<float>();
  solver.home[i] = from;
  const double speed = mover.v.norm();
  const double reach = kRadiiAhead * solver.radius(i);
  const double ahead =
      std::max(solver.h, std::min(kStepsAhead * solver.h, speed > 0.0 ? reach / speed : kStepsAhead * solver.h));
  solver.displacement[i] = (ahead * (mover.v + (0.5 * ahead) * a)).cast<float>();
}

bool isNeighbour(const ContactSolver& solver, std::uint32_t ball, std::size_t body, std::size_t shape)
{
  for (std::uint32_t l = solver.first_body[ball]; l != ContactSolver::kEndOfList; l = solver.bodies[l].next)
    if (solver.bodies[l].body == body && solver.bodies[l].shape == shape) return true;
  return false;
}

// Adds the still bodies on its way that are not its neighbours yet.
void addBodyNeighbours(WorldWithSolver& world, std::uint32_t i)
{
  ContactSolver& solver = world.solver;
  const Vector3d centre = solver.home[i] + 0.5 * solver.displacement[i].cast<double>();
  const Vector3d half(halfEdge(solver, i, 0), halfEdge(solver, i, 1), halfEdge(solver, i, 2));
  Box box;
  box.low = centre - half;
  box.high = centre + half;
  for (std::size_t b = 0; b < world.bodies.size(); ++b)
  {
    if (world.bodies[b].moving) continue;
    for (std::size_t s = 0; s < world.bodies[b].boxes.size(); ++s)
    {
      if (!box.overlaps(world.bodies[b].boxes[s]) || isNeighbour(solver, i, b, s)) continue;
      solver.bodies.push_back({i, solver.first_body[i], static_cast<std::uint16_t>(b), static_cast<std::uint16_t>(s)});
      solver.first_body[i] = static_cast<std::uint32_t>(solver.bodies.size() - 1);
    }
  }
}

void findBodyNeighbours(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  solver.first_body.assign(solver.movers.size(), ContactSolver::kEndOfList);
  for (std::uint32_t i = 0; i < solver.movers.size(); ++i) addBodyNeighbours(world, i);
}

void listPair(ContactSolver& solver, std::uint32_t l)
{
  NeighbourPair& pair = solver.pairs[l];
  pair.next_a = solver.first_pair[pair.a];
  pair.next_b = solver.first_pair[pair.b];
  solver.first_pair[pair.a] = {l, 0};
  solver.first_pair[pair.b] = {l, 1};
}

void listPairs(ContactSolver& solver)
{
  solver.first_pair.assign(solver.movers.size(), PairEnd::endOfList());
  for (std::uint32_t l = static_cast<std::uint32_t>(solver.pairs.size()); l-- > 0;) listPair(solver, l);
}

// Pairs that were there before keep their impulses.
void restoreImpulses(ContactSolver& solver)
{
  solver.impulses.assign(solver.pairs.size(), Lanes{});
  solver.force_at_sleep.assign(solver.pairs.size(), -1.0f);
  for (const KeptPair& old : solver.old_kept)
    solver.anyPair(old.a,
                   [&](std::uint32_t l)
                   {
                     if (solver.pairs[l].a != old.a || solver.pairs[l].b != old.b) return false;
                     solver.impulses[l] = old.impulse;
                     solver.force_at_sleep[l] = old.force_at_sleep;
                     return true;
                   });
  solver.old_kept.clear();
  for (const BodyNeighbour& old : solver.old_bodies)
    for (std::uint32_t l = solver.first_body[old.ball]; l != ContactSolver::kEndOfList; l = solver.bodies[l].next)
      if (solver.bodies[l].body == old.body && solver.bodies[l].shape == old.shape)
        solver.bodies[l].impulse = old.impulse;
}

// --- a ball that leaves its box before the others ---

void addStrayPair(ContactSolver& solver, std::uint32_t i, const NeighbourGrid::Entry& mine,
                  const NeighbourGrid::Entry& other)
{
  const std::uint32_t k = other.slot;
  if (k == i || !overlap(mine, other)) return;
  if (solver.anyPair(i, [&](std::uint32_t l) { return solver.pairs[l].a == k || solver.pairs[l].b == k; })) return;
  const auto l = static_cast<std::uint32_t>(solver.pairs.size());
  solver.pairs.push_back({std::min(i, k), std::max(i, k), {}, {}});
  solver.impulses.push_back(Lanes{});
  solver.force_at_sleep.push_back(-1.0f);
  SolverSlab& slab = slabOf(solver, solver.pairs[l]);
  slab.pairs.push_back(l);
  slab.active_pairs.push_back(l);
  listPair(solver, l);
}

void coverStray(WorldWithSolver& world, std::uint32_t i)
{
  ContactSolver& solver = world.solver;
  coverWay(solver, i);
  const NeighbourGrid::Entry mine = entryOf(solver, i);
  const NeighbourGrid& grid = solver.grid;
  eachCellNear(grid, mine,
               [&](std::size_t cell)
               {
                 for (std::uint32_t e = grid.start[cell]; e < grid.start[cell + 1]; ++e)
                   addStrayPair(solver, i, mine, grid.entries[e]);
               });
  for (const NeighbourGrid::Entry& other : grid.large) addStrayPair(solver, i, mine, other);
  for (const NeighbourGrid::Entry& other : grid.strays) addStrayPair(solver, i, mine, other);
  solver.grid.strays.push_back(mine);
  const std::size_t before = solver.bodies.size();
  addBodyNeighbours(world, i);
  SolverSlab& slab = solver.slabs[solver.slab_of[i]];
  for (std::size_t l = before; l < solver.bodies.size(); ++l)
    for (std::vector<std::uint32_t>* list : {&slab.bodies, &slab.active_bodies})
      list->push_back(static_cast<std::uint32_t>(l));
}

bool manyStrays(const ContactSolver& solver, std::size_t more)
{
  return solver.grid.strays.size() + more > std::min(kManyStrays, solver.movers.size() / kStrayPart + 1);
}

// How many balls leave their boxes in this step.
std::size_t findLeaving(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  eachSlab(world,
           [&solver](SolverSlab& slab)
           {
             slab.leaving.clear();
             for (const std::uint32_t i : slab.awake)
               if (!covered(solver, i)) slab.leaving.push_back(i);
           });
  std::size_t leaving = 0;
  for (const SolverSlab& slab : solver.slabs) leaving += slab.leaving.size();
  return leaving;
}

unsigned versionsOf(const WorldWithSolver& world)
{
  unsigned sum = 0;
  for (const BodyRecord& body : world.bodies) sum += body.version;
  return sum;
}

void build(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  if (solver.movers.size() > 1) count(Law::BroadPhase);
  saveImpulses(solver);
  solver.old_bodies.swap(solver.bodies);
  solver.bodies.clear();
  sortSlots(solver);
  double radii = 0.0;
  for (std::size_t i = 0; i < solver.movers.size(); ++i) radii += solver.radius(i);
  solver.margin = static_cast<float>(kMargin * radii / static_cast<double>(solver.movers.size()));
  for (std::size_t i = 0; i < solver.movers.size(); ++i) coverWay(solver, i);
  findNeighbours(solver, world.workers);
  findBodyNeighbours(world);
  listPairs(solver);
  cutSlabs(solver, world.scene.forces.gravity);
  listBySlab(solver);
  restoreImpulses(solver);
  solver.neighbours_void = false;
  solver.body_versions = versionsOf(world);
}
}  // namespace

void saveImpulses(ContactSolver& solver)
{
  for (std::size_t l = 0; l < solver.pairs.size(); ++l)
    if (solver.impulses[l][3] > 0.0f || solver.force_at_sleep[l] >= 0.0f)
      solver.old_kept.push_back({solver.pairs[l].a, solver.pairs[l].b, solver.force_at_sleep[l], solver.impulses[l]});
  solver.pairs.clear();
}

void updateNeighbours(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  bool anew = solver.neighbours_void || solver.body_versions != versionsOf(world);
  if (!anew)
  {
    updateActive(world);
    anew = manyStrays(solver, findLeaving(world));
  }
  if (anew)
    build(world);
  else
    for (const SolverSlab& slab : solver.slabs)
      for (const std::uint32_t i : slab.leaving) coverStray(world, i);
  updateActive(world);
}

bool updateNeighboursAfterImpact(WorldWithSolver& world, std::uint32_t a, std::uint32_t b)
{
  ContactSolver& solver = world.solver;
  for (const std::uint32_t i : {a, b})
  {
    if (covered(solver, i)) continue;
    if (manyStrays(solver, 1))
    {
      build(world);
      updateActive(world);
      return true;
    }
    coverStray(world, i);
  }
  return false;
}
}  // namespace ping_pong
