// Who is awake, and what that makes of the lists of neighbours.
#include <algorithm>

#include "solver/slabs.h"

namespace ping_pong
{
namespace
{
bool anyAwake(const ContactSolver& solver, const NeighbourPair& pair)
{
  return !solver.movers[pair.a].asleep || !solver.movers[pair.b].asleep;
}

void updateSlab(const ContactSolver& solver, SolverSlab& slab)
{
  if (!slab.active_void) return;
  slab.active_void = false;
  slab.awake.clear();
  slab.active_pairs.clear();
  slab.active_bodies.clear();
  for (const std::uint32_t i : slab.balls)
    if (!solver.movers[i].asleep) slab.awake.push_back(i);
  for (const std::uint32_t l : slab.pairs)
    if (anyAwake(solver, solver.pairs[l])) slab.active_pairs.push_back(l);
  for (const std::uint32_t l : slab.bodies)
    if (!solver.movers[solver.bodies[l].ball].asleep) slab.active_bodies.push_back(l);
}
}  // namespace

void updateActive(WorldWithSolver& world)
{
  const ContactSolver& solver = world.solver;
  const bool any =
      std::any_of(solver.slabs.begin(), solver.slabs.end(), [](const SolverSlab& slab) { return slab.active_void; });
  if (any) eachSlab(world, [&solver](SolverSlab& slab) { updateSlab(solver, slab); });
}

void ContactSolver::voidActive(std::size_t i)
{
  if (neighbours_void) return;  // all is known anew when they have been searched
  const std::size_t slab = slab_of[i];
  slabs[slab].active_void = lastSlab().active_void = true;
  if (slab > 0) slabs[slab - 1].active_void = true;
}

bool ContactSolver::anyAwake() const
{
  return neighbours_void || std::any_of(slabs.begin(), slabs.end(),
                                        [](const SolverSlab& slab) { return slab.active_void || !slab.awake.empty(); });
}
}  // namespace ping_pong
