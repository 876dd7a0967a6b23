// The solver cut into slabs that threads work on at the same time: the same slabs, in the same order, for any number of threads.
//
// A slab is at least as wide as two neighbours are apart, but for a few very fast ones. So a pair of which one ball is in
// slab s has the other there or in slab s + 1, and belongs to s: the pairs of slabs s and s + 2 have no ball in common. What
// reaches farther is in a slab of its own, the last one.
#pragma once

#include "solver/solver_state.h"

namespace ping_pong
{
/// Cuts anew, across the horizontal axis along which balls are spread most: slabs of about as many balls each.
/// @param up  or down: the axis that is left out if the heap is wide enough
void cutSlabs(ContactSolver& solver, const Vector3d& up);

/// As before the first step, with the memory that it has.
void clearSlab(SolverSlab& slab);

/// Before neighbours are searched: gives balls other slots, if they are scattered over the slabs of the last ones.
void sortSlots(ContactSolver& solver);

/// Lists all neighbours in their slabs.
void listBySlab(ContactSolver& solver);

inline SolverSlab& slabOf(ContactSolver& solver, const NeighbourPair& pair)
{
  const std::size_t a = solver.slab_of[pair.a], b = solver.slab_of[pair.b];
  return a + 1 < b || b + 1 < a ? solver.lastSlab() : solver.slabs[std::min(a, b)];
}

/// Fewer balls are not shared among threads.
constexpr std::size_t kBallsWorthThreads = 500;

/// Calls action(slab) for `count` slabs: the first one, and each `stride` after it.
template <typename Action>
void eachStridedSlab(WorldWithSolver& world, std::size_t first, std::size_t stride, const Action& action)
{
  ContactSolver& solver = world.solver;
  const std::size_t count = (solver.slab_count + stride - 1 - first) / stride;
  world.workers.each(count, solver.movers.size() < kBallsWorthThreads ? count : 1,
                     [&](std::size_t begin, std::size_t end, std::size_t)
                     {
                       for (std::size_t k = begin; k < end; ++k) action(solver.slabs[first + k * stride]);
                     });
}

/// For work on balls, or that reads them and writes what belongs to the slab: all slabs at once; the last one has no balls.
template <typename Action>
void eachSlab(WorldWithSolver& world, const Action& action)
{
  eachStridedSlab(world, 0, 1, action);
  action(world.solver.lastSlab());
}

/// For work on pairs that writes to both of their balls: every other slab at once, then those between, then the last one.
template <typename Action>
void inRedBlackOrder(WorldWithSolver& world, const Action& action)
{
  eachStridedSlab(world, 0, 2, action);
  if (world.solver.slab_count > 1) eachStridedSlab(world, 1, 2, action);
  action(world.solver.lastSlab());
}
}  // namespace ping_pong
