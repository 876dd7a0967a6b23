// Who is awake, and what that makes of the links.
#include <algorithm>

#include "solver/slabs.h"

namespace ping_pong
{
namespace
{
bool anyAwake(const Pile& pile, const PairLink& link)
{
  return !pile.movers[link.a].asleep || !pile.movers[link.b].asleep;
}

void updateShare(const Pile& pile, PileShare& share)
{
  if (!share.active_void) return;
  share.active_void = false;
  share.awake.clear();
  share.active_pairs.clear();
  share.active_bodies.clear();
  for (const std::uint32_t i : share.balls)
    if (!pile.movers[i].asleep) share.awake.push_back(i);
  for (const std::uint32_t l : share.pairs)
    if (anyAwake(pile, pile.pairs[l])) share.active_pairs.push_back(l);
  for (const std::uint32_t l : share.bodies)
    if (!pile.movers[pile.bodies[l].ball].asleep) share.active_bodies.push_back(l);
}
}  // namespace

void updateActive(WorldWithSolver& world)
{
  const Pile& pile = world.pile;
  const bool any =
      std::any_of(pile.shares.begin(), pile.shares.end(), [](const PileShare& share) { return share.active_void; });
  if (any) eachShare(world, [&pile](PileShare& share) { updateShare(pile, share); });
}

void Pile::voidActive(std::size_t i)
{
  if (links_void) return;  // all is known anew when they are built
  const std::size_t slab = share_of[i];
  shares[slab].active_void = lastShare().active_void = true;
  if (slab > 0) shares[slab - 1].active_void = true;
}

bool Pile::anyAwake() const
{
  return links_void || std::any_of(shares.begin(), shares.end(),
                                   [](const PileShare& share) { return share.active_void || !share.awake.empty(); });
}
}  // namespace ping_pong
