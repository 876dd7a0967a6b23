#include "solver/slabs.h"

#include <algorithm>
#include <cmath>

namespace ping_pong
{
namespace
{
constexpr std::size_t kFewestBalls = 32;  // in a slab, about
constexpr std::size_t kBinsInAWidth = 4;  // the least width of a slab, in bins of the histogram
constexpr std::size_t kMostBins = 1024;
constexpr double kSpread = 3.0;  // bins cover so many standard deviations; balls outside are in the outer ones

double placeOf(const Pile& pile, std::size_t i, int axis)
{
  return pile.home[i][axis] + 0.5 * static_cast<double>(pile.sweep[i][axis]);
}

struct Spread
{
  Vector3d mean = Vector3d::Zero(), deviation = Vector3d::Zero();
};

Spread spreadOf(const Pile& pile)
{
  const double n = static_cast<double>(pile.movers.size());
  Spread spread;
  for (const Vector3d& home : pile.home) spread.mean += home / n;
  for (const Vector3d& home : pile.home) spread.deviation += (home - spread.mean).cwiseAbs2() / n;
  spread.deviation = spread.deviation.cwiseSqrt();
  return spread;
}

// Impulses travel along the axis of gravity above all: a sweep through a slab follows them from layer to layer.
int widestAxis(const Spread& spread, const Vector3d& up)
{
  int axis;
  Vector3d wide = spread.deviation;
  int vertical;
  if (up.cwiseAbs().maxCoeff(&vertical) > 0.0) wide[vertical] = -1.0;
  wide.maxCoeff(&axis);
  return axis;
}

// Balls along the axis, counted in bins.
struct Histogram
{
  double origin = 0.0, bins_per_metre = 0.0;
  std::size_t bins = 1;
  std::array<std::uint32_t, kMostBins + 1> count{};

  Histogram(const Pile& pile, const Spread& spread, int axis)
  {
    const double half = kSpread * spread.deviation[axis],
                 bin = static_cast<double>(pile.grid.large_edge) / kBinsInAWidth;
    origin = spread.mean[axis] - half;
    bins_per_metre = 1.0 / std::max(bin, 2.0 * half / static_cast<double>(kMostBins));
    bins = static_cast<std::size_t>(2.0 * half * bins_per_metre) + 1;
    for (std::size_t i = 0; i < pile.movers.size(); ++i) ++count[binOf(placeOf(pile, i, axis))];
  }
  std::size_t binOf(double place) const
  {
    return static_cast<std::size_t>(std::clamp((place - origin) * bins_per_metre, 0.0, static_cast<double>(bins - 1)));
  }
};

// The slab of each bin: a slab ends where it has its share of the balls and is wide enough.
std::array<std::uint8_t, kMostBins + 1> slabsOf(const Histogram& histogram, std::size_t balls)
{
  const std::size_t most = std::clamp<std::size_t>(balls / kFewestBalls, 1, Pile::kMostSlabs);
  std::array<std::uint8_t, kMostBins + 1> slab{};
  std::size_t before = 0, seen = 0, first = 0, now = 0;
  for (std::size_t bin = 0; bin < histogram.bins; ++bin)
  {
    slab[bin] = static_cast<std::uint8_t>(now);
    seen += histogram.count[bin];
    const bool enough = (seen - before) * (most - now) >= balls - before && bin + 1 - first >= kBinsInAWidth;
    const bool room_for_another = now + 1 < most && histogram.bins - (bin + 1) >= kBinsInAWidth;
    if (!enough || !room_for_another) continue;
    ++now;
    before = seen;
    first = bin + 1;
  }
  return slab;
}

}  // namespace

void clearShare(PileShare& share)
{
  for (std::vector<std::uint32_t>* list : {&share.balls, &share.awake, &share.pairs, &share.bodies, &share.active_pairs,
                                           &share.active_bodies, &share.leaving, &share.waking})
    list->clear();
  share.body_touches.clear();
  share.pair_batches.clear();
  share.body_batches.clear();
  share.ahead.clear();
  share.active_void = false;
}

void cutPile(Pile& pile, const Vector3d& up)
{
  const Spread spread = spreadOf(pile);
  const int axis = widestAxis(spread, up);
  const Histogram histogram(pile, spread, axis);
  const std::array<std::uint8_t, kMostBins + 1> slab = slabsOf(histogram, pile.movers.size());
  pile.slabs = slab[histogram.bins - 1] + std::size_t{1};
  for (PileShare& share : pile.shares) clearShare(share);
  for (std::size_t k = 0; k < pile.slabs; ++k) pile.shares[k].active_void = true;
  pile.lastShare().active_void = true;
  pile.share_of.resize(pile.movers.size());
  for (std::uint32_t i = 0; i < pile.movers.size(); ++i)
  {
    pile.share_of[i] = slab[histogram.binOf(placeOf(pile, i, axis))];
    pile.shares[pile.share_of[i]].balls.push_back(i);
  }
}

void shareLinks(Pile& pile)
{
  for (std::uint32_t l = 0; l < pile.pairs.size(); ++l) shareOf(pile, pile.pairs[l]).pairs.push_back(l);
  for (std::uint32_t l = 0; l < pile.bodies.size(); ++l)
    pile.shares[pile.share_of[pile.bodies[l].ball]].bodies.push_back(l);
}
}  // namespace ping_pong
