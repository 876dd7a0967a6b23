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

bool scattered(const Pile& pile)
{
  const std::size_t n = pile.movers.size();
  if (pile.share_of.size() != n || pile.grid.cell.size() != n || pile.slabs == 1)
    return false;  // not known since the last links
  std::size_t jumps = 0;
  for (std::size_t i = 1; i < n; ++i) jumps += pile.share_of[i] != pile.share_of[i - 1];
  return jumps > n / kScattered + 2 * pile.slabs;
}

// By slab, then by cell; the rest as it was.
void findOrder(Pile& pile)
{
  const auto placeOf = [&pile](std::uint32_t i) { return std::uint64_t{pile.share_of[i]} << 32 | pile.grid.cell[i]; };
  pile.old_slot.resize(pile.movers.size());
  std::iota(pile.old_slot.begin(), pile.old_slot.end(), 0u);
  std::sort(pile.old_slot.begin(), pile.old_slot.end(),
            [&](std::uint32_t i, std::uint32_t k)
            { return placeOf(i) != placeOf(k) ? placeOf(i) < placeOf(k) : i < k; });
  pile.new_slot.resize(pile.old_slot.size());
  for (std::uint32_t i = 0; i < pile.old_slot.size(); ++i) pile.new_slot[pile.old_slot[i]] = i;
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
  kept.push *= Lanes{-1.0f, -1.0f, -1.0f, 1.0f};
}
}  // namespace

void sortSlots(Pile& pile)
{
  if (!scattered(pile)) return;
  findOrder(pile);
  for (KeptPair& kept : pile.old_kept) rename(kept, pile.new_slot);
  for (std::vector<BodyLink>* links : {&pile.old_bodies, &pile.moving})
    for (BodyLink& link : *links) link.ball = pile.new_slot[link.ball];
  turnIntoSwaps(pile.old_slot);
  eachSlotList(pile, [&pile](auto& list) { swapAll(list, pile.old_slot); });
}
}  // namespace ping_pong
