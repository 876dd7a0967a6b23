// Slots in the order of the places of their balls: what a thread works on lies side by side in memory, and neighbours are
// found in the same lines of the cache.
#include <algorithm>
#include <numeric>

#include "solver/slabs.h"

namespace ping_pong
{
namespace
{
constexpr std::size_t kScattered = 16;  // one in so many slots follows one of another slab

bool scattered(const ContactSolver& solver)
{
  const std::size_t n = solver.movers.size();
  if (solver.slab_of.size() != n || solver.grid.cell.size() != n || solver.slab_count == 1)
    return false;  // not known since the last search
  std::size_t jumps = 0;
  for (std::size_t i = 1; i < n; ++i) jumps += solver.slab_of[i] != solver.slab_of[i - 1];
  return jumps > n / kScattered + 2 * solver.slab_count;
}

// By slab, then by cell; the rest as it was.
void findOrder(ContactSolver& solver)
{
  const auto placeOf = [&solver](std::uint32_t i)
  { return std::uint64_t{solver.slab_of[i]} << 32 | solver.grid.cell[i]; };
  solver.old_slot.resize(solver.movers.size());
  std::iota(solver.old_slot.begin(), solver.old_slot.end(), 0u);
  std::sort(solver.old_slot.begin(), solver.old_slot.end(),
            [&](std::uint32_t i, std::uint32_t k)
            { return placeOf(i) != placeOf(k) ? placeOf(i) < placeOf(k) : i < k; });
  solver.new_slot.resize(solver.old_slot.size());
  for (std::uint32_t i = 0; i < solver.old_slot.size(); ++i) solver.new_slot[solver.old_slot[i]] = i;
}

// Each slot is filled by a swap with one behind it: where its ball is by then.
void turnIntoSwaps(std::vector<std::uint32_t>& from)
{
  for (std::uint32_t i = 0; i < from.size(); ++i)
    while (from[i] < i) from[i] = from[from[i]];
}

template <typename List>
void swapAll(List& list, const std::vector<std::uint32_t>& with)
{
  for (std::uint32_t i = 0; i < with.size(); ++i) std::swap(list[i], list[with[i]]);
}

// Normals point from b to a, and a comes first.
void rename(KeptPair& kept, const std::vector<std::uint32_t>& new_slot)
{
  kept.a = new_slot[kept.a];
  kept.b = new_slot[kept.b];
  if (kept.a < kept.b) return;
  std::swap(kept.a, kept.b);
  kept.impulse *= Lanes{-1.0f, -1.0f, -1.0f, 1.0f};
}
}  // namespace

void sortSlots(ContactSolver& solver)
{
  if (!scattered(solver)) return;
  findOrder(solver);
  for (KeptPair& kept : solver.old_kept) rename(kept, solver.new_slot);
  for (std::vector<BodyNeighbour>* neighbours : {&solver.old_bodies, &solver.moving})
    for (BodyNeighbour& neighbour : *neighbours) neighbour.ball = solver.new_slot[neighbour.ball];
  turnIntoSwaps(solver.old_slot);
  eachSlotList(solver, [&solver](auto& list) { swapAll(list, solver.old_slot); });
}
}  // namespace ping_pong
