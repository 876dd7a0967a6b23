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

double placeOf(const ContactSolver& solver, std::size_t i, int axis)
{
  return solver.home[i][axis] + 0.5 * static_cast<double>(solver.displacement[i][axis]);
}

struct Spread
{
  Vector3d mean = Vector3d::Zero(), deviation = Vector3d::Zero();
};

Spread spreadOf(const ContactSolver& solver)
{
  const double n = static_cast<double>(solver.movers.size());
  Spread spread;
  for (const Vector3d& home : solver.home) spread.mean += home / n;
  for (const Vector3d& home : solver.home) spread.deviation += (home - spread.mean).cwiseAbs2() / n;
  spread.deviation = spread.deviation.cwiseSqrt();
  return spread;
}

// Impulses travel along the axis of gravity above all: an iteration through a slab follows them from layer to layer.
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

  Histogram(const ContactSolver& solver, const Spread& spread, int axis)
  {
    const double half = kSpread * spread.deviation[axis],
                 bin = static_cast<double>(solver.grid.large_edge) / kBinsInAWidth;
    origin = spread.mean[axis] - half;
    bins_per_metre = 1.0 / std::max(bin, 2.0 * half / static_cast<double>(kMostBins));
    bins = static_cast<std::size_t>(2.0 * half * bins_per_metre) + 1;
    for (std::size_t i = 0; i < solver.movers.size(); ++i) ++count[binOf(placeOf(solver, i, axis))];
  }
  std::size_t binOf(double place) const
  {
    return static_cast<std::size_t>(std::clamp((place - origin) * bins_per_metre, 0.0, static_cast<double>(bins - 1)));
  }
};

// The slab of each bin: a slab ends where it has its part of the balls and is wide enough.
std::array<std::uint8_t, kMostBins + 1> slabsOfBins(const Histogram& histogram, std::size_t balls)
{
  const std::size_t most = std::clamp<std::size_t>(balls / kFewestBalls, 1, ContactSolver::kMostSlabs);
  std::array<std::uint8_t, kMostBins + 1> slab_of_bin{};
  std::size_t before = 0, seen = 0, first = 0, now = 0;
  for (std::size_t bin = 0; bin < histogram.bins; ++bin)
  {
    slab_of_bin[bin] = static_cast<std::uint8_t>(now);
    seen += histogram.count[bin];
    const bool enough = (seen - before) * (most - now) >= balls - before && bin + 1 - first >= kBinsInAWidth;
    const bool room_for_another = now + 1 < most && histogram.bins - (bin + 1) >= kBinsInAWidth;
    if (!enough || !room_for_another) continue;
    ++now;
    before = seen;
    first = bin + 1;
  }
  return slab_of_bin;
}

}  // namespace

void clearSlab(SolverSlab& slab)
{
  for (std::vector<std::uint32_t>* list : {&slab.balls, &slab.awake, &slab.pairs, &slab.bodies, &slab.active_pairs,
                                           &slab.active_bodies, &slab.leaving, &slab.waking})
    list->clear();
  slab.body_constraints.clear();
  slab.pair_batches.clear();
  slab.body_batches.clear();
  slab.ahead.clear();
  slab.active_void = false;
}

void cutSlabs(ContactSolver& solver, const Vector3d& up)
{
  const Spread spread = spreadOf(solver);
  const int axis = widestAxis(spread, up);
  const Histogram histogram(solver, spread, axis);
  const std::array<std::uint8_t, kMostBins + 1> slab_of_bin = slabsOfBins(histogram, solver.movers.size());
  solver.slab_count = slab_of_bin[histogram.bins - 1] + std::size_t{1};
  for (SolverSlab& slab : solver.slabs) clearSlab(slab);
  for (std::size_t k = 0; k < solver.slab_count; ++k) solver.slabs[k].active_void = true;
  solver.lastSlab().active_void = true;
  solver.slab_of.resize(solver.movers.size());
  for (std::uint32_t i = 0; i < solver.movers.size(); ++i)
  {
    solver.slab_of[i] = slab_of_bin[histogram.binOf(placeOf(solver, i, axis))];
    solver.slabs[solver.slab_of[i]].balls.push_back(i);
  }
}

void listBySlab(ContactSolver& solver)
{
  for (std::uint32_t l = 0; l < solver.pairs.size(); ++l) slabOf(solver, solver.pairs[l]).pairs.push_back(l);
  for (std::uint32_t l = 0; l < solver.bodies.size(); ++l)
    solver.slabs[solver.slab_of[solver.bodies[l].ball]].bodies.push_back(l);
}
}  // namespace ping_pong
