// Who is awake, and what that makes of the links.
#include <algorithm>

#include "pile_shares.h"

namespace ping_pong
{
namespace
{
bool anyAwake(const Pile& pile, const PairLink& link)
{
  return !pile.movers[link.a].asleep || !pile.movers[link.b].asleep;
}

// What is kept, anew by who is awake.
void divideKept(const Pile& pile, PileShare& share)
{
  const auto earlier = [](const KeptPair& p, const KeptPair& q) { return p.link < q.link; };
  if (!std::is_sorted(share.kept.begin(), share.kept.end(), earlier)) std::sort(share.kept.begin(), share.kept.end(), earlier);
  share.all_kept.resize(share.kept.size() + share.kept_asleep.size());
  std::merge(share.kept.begin(), share.kept.end(), share.kept_asleep.begin(), share.kept_asleep.end(), share.all_kept.begin(), earlier);
  share.kept.clear();
  share.kept_asleep.clear();
  for (const KeptPair& kept : share.all_kept)
    (anyAwake(pile, pile.pairs[kept.link]) ? share.kept : share.kept_asleep).push_back(kept);
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
  divideKept(pile, share);
}
}  // namespace

void updateActive(WorldState& world)
{
  const Pile& pile = world.pile;
  const bool any = std::any_of(pile.shares.begin(), pile.shares.end(), [](const PileShare& share) { return share.active_void; });
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
