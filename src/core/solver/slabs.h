// The pile cut into slabs that threads work on at the same time: the same slabs, in the same order, for any number of threads.
//
// A slab is at least as wide as two linked balls are apart, but for a few very fast ones. So a link of which one ball is in
// slab s has the other there or in slab s + 1, and belongs to s: work on the links of slabs s and s + 2 shares no ball. What
// links farther is in a share of its own, the last one.
#pragma once

#include "solver/solver_state.h"

namespace ping_pong
{
/// Cuts anew, across the horizontal axis along which balls are spread most: slabs of about as many balls each.
/// @param up  or down: the axis that is left out if the pile is wide enough
void cutPile(Pile& pile, const Vector3d& up);

/// As before the first step, with the memory that it has.
void clearShare(PileShare& share);

/// Before links are built: gives balls other slots, if they are scattered over the slabs of the last ones.
void sortSlots(Pile& pile);

/// Lists all links in their shares.
void shareLinks(Pile& pile);

inline PileShare& shareOf(Pile& pile, const PairLink& link)
{
  const std::size_t a = pile.share_of[link.a], b = pile.share_of[link.b];
  return a + 1 < b || b + 1 < a ? pile.lastShare() : pile.shares[std::min(a, b)];
}

/// Fewer balls are not shared among threads.
constexpr std::size_t kPileWorthSharing = 500;

/// Calls action(slab) for `count` slabs: the first one, and each `stride` after it.
template <typename Action>
void eachSlab(WorldWithSolver& world, std::size_t first, std::size_t stride, const Action& action)
{
  Pile& pile = world.pile;
  const std::size_t count = (pile.slabs + stride - 1 - first) / stride;
  world.workers.each(count, pile.movers.size() < kPileWorthSharing ? count : 1,
                     [&](std::size_t begin, std::size_t end, std::size_t)
                     {
                       for (std::size_t k = begin; k < end; ++k) action(pile.shares[first + k * stride]);
                     });
}

/// For work on balls, or that reads them and writes what belongs to the share: all slabs at once; the last share has no balls.
template <typename Action>
void eachShare(WorldWithSolver& world, const Action& action)
{
  eachSlab(world, 0, 1, action);
  action(world.pile.lastShare());
}

/// For work on links that writes to both of their balls: every other slab at once, then those between, then the last share.
template <typename Action>
void inTurns(WorldWithSolver& world, const Action& action)
{
  eachSlab(world, 0, 2, action);
  if (world.pile.slabs > 1) eachSlab(world, 1, 2, action);
  action(world.pile.lastShare());
}
}  // namespace ping_pong
