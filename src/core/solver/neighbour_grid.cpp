#include "solver/neighbour_grid.h"

#include <algorithm>
#include <cmath>

#include "solver/slabs.h"

namespace ping_pong
{
namespace
{
constexpr float kTouchSlack = 2e-4f;  // contacts are looked at that far before they touch [m]
constexpr double kLargeBox = 1.5;     // in mean edges
constexpr double kCellsPerBall = 2.0;
constexpr double kSpread = 3.0;  // the grid covers so many standard deviations; balls outside are in its outer cells

float reachOf(const Pile& pile, std::size_t i)
{
  return pile.margin + kTouchSlack + static_cast<float>(pile.radius(i));
}

void layOut(Pile& pile)
{
  const double n = static_cast<double>(pile.movers.size());
  Vector3d sum = Vector3d::Zero();
  double edge = 0.0;
  for (std::size_t i = 0; i < pile.movers.size(); ++i)
  {
    sum += pile.home[i];
    edge += 2.0 * std::max({halfEdge(pile, i, 0), halfEdge(pile, i, 1), halfEdge(pile, i, 2)});
  }
  const Vector3d mean = sum / n;
  Vector3d square = Vector3d::Zero();
  for (const Vector3d& home : pile.home) square += (home - mean).cwiseAbs2();
  const Vector3d half = kSpread * (square / n).cwiseSqrt();
  PileGrid& grid = pile.grid;
  grid.origin = mean - half;
  double size = kLargeBox * edge / n;
  grid.large_edge = static_cast<float>(size);
  for (;; size *= 1.25)
  {
    double cells = 1.0;
    for (int axis = 0; axis < 3; ++axis) cells *= std::floor(2.0 * half[axis] / size) + 1.0;
    if (cells <= kCellsPerBall * n + 1.0) break;
  }
  grid.cells_per_metre = 1.0 / size;
  for (int axis = 0; axis < 3; ++axis) grid.count[axis] = static_cast<int>(2.0 * half[axis] / size) + 1;
}

constexpr std::uint32_t kNoCell = ~0u;

void sortIntoCells(Pile& pile)
{
  PileGrid& grid = pile.grid;
  const std::size_t n = pile.movers.size();
  grid.start.assign(static_cast<std::size_t>(grid.count[0]) * grid.count[1] * grid.count[2] + 1, 0);
  grid.cell.resize(n);
  grid.large.clear();
  grid.strays.clear();
  for (std::size_t i = 0; i < n; ++i)
  {
    const PileGrid::Entry entry = entryOf(pile, i);
    grid.cell[i] = kNoCell;
    if (2.0f * entry.half.maxCoeff() > grid.large_edge)
    {
      grid.large.push_back(entry);
      continue;
    }
    const Vector3d centre = pile.home[i] + 0.5 * pile.sweep[i].cast<double>();
    const int x = grid.cellAt(centre[0], 0), y = grid.cellAt(centre[1], 1), z = grid.cellAt(centre[2], 2);
    grid.cell[i] = static_cast<std::uint32_t>((z * grid.count[1] + y) * grid.count[0] + x);
    ++grid.start[grid.cell[i]];
  }
  std::uint32_t total = 0;
  for (std::uint32_t& start : grid.start) start = total += start;  // ends; filled from behind they become starts
  grid.entries.resize(total);
  for (std::size_t i = n; i-- > 0;)
    if (grid.cell[i] != kNoCell) grid.entries[--grid.start[grid.cell[i]]] = entryOf(pile, i);
}

void link(std::vector<PairLink>& pairs, const PileGrid::Entry& a, const PileGrid::Entry& b)
{
  if (overlap(a, b)) pairs.push_back({std::min(a.slot, b.slot), std::max(a.slot, b.slot), 0, 0});
}

// Each cell of some rows with the half of its neighbours that comes after it; three cells in a row lie side by side.
void linkRows(const PileGrid& grid, int begin, int end, std::vector<PairLink>& pairs)
{
  const int nx = grid.count[0], ny = grid.count[1], nz = grid.count[2];
  const auto row = [&](std::uint32_t from, int x0, int x1, int y, int z)
  {
    if (y < 0 || y >= ny || z >= nz) return;
    const std::size_t line = static_cast<std::size_t>(z * ny + y) * static_cast<std::size_t>(nx);
    const std::uint32_t begin = grid.start[line + static_cast<std::size_t>(std::max(x0, 0))];
    const std::uint32_t end = grid.start[line + static_cast<std::size_t>(std::min(x1, nx - 1)) + 1];
    for (std::uint32_t other = begin; other < end; ++other) link(pairs, grid.entries[from], grid.entries[other]);
  };
  std::size_t cell = static_cast<std::size_t>(begin) * static_cast<std::size_t>(nx);
  for (int line = begin; line < end; ++line)
    for (int x = 0; x < nx; ++x, ++cell)
      for (std::uint32_t i = grid.start[cell]; i < grid.start[cell + 1]; ++i)
      {
        const int y = line % ny, z = line / ny;
        for (std::uint32_t k = i + 1; k < grid.start[cell + 1]; ++k) link(pairs, grid.entries[i], grid.entries[k]);
        if (x + 1 < nx) row(i, x + 1, x + 1, y, z);
        row(i, x - 1, x + 1, y + 1, z);
        for (int dy = -1; dy <= 1; ++dy) row(i, x - 1, x + 1, y + dy, z + 1);
      }
}

// In parts that threads can share: always the same ones, joined in their order.
void linkCells(Pile& pile, Workers& workers)
{
  const PileGrid& grid = pile.grid;
  const auto parts = static_cast<int>(pile.found.size()), rows = grid.count[1] * grid.count[2];
  workers.each(pile.found.size(), pile.movers.size() < kPileWorthSharing ? pile.found.size() : 1,
               [&](std::size_t begin, std::size_t end, std::size_t)
               {
                 for (int part = static_cast<int>(begin); part < static_cast<int>(end); ++part)
                 {
                   std::vector<PairLink>& found = pile.found[static_cast<std::size_t>(part)];
                   found.clear();
                   linkRows(grid, part * rows / parts, (part + 1) * rows / parts, found);
                 }
               });
  for (const std::vector<PairLink>& found : pile.found) pile.pairs.insert(pile.pairs.end(), found.begin(), found.end());
}

void linkLarge(Pile& pile)
{
  const std::vector<PileGrid::Entry>& large = pile.grid.large;
  for (std::size_t i = 0; i < large.size(); ++i)
  {
    for (std::size_t k = i + 1; k < large.size(); ++k) link(pile.pairs, large[i], large[k]);
    eachCellNear(pile.grid, large[i],
                 [&](std::size_t cell)
                 {
                   for (std::uint32_t other = pile.grid.start[cell]; other < pile.grid.start[cell + 1]; ++other)
                     link(pile.pairs, large[i], pile.grid.entries[other]);
                 });
  }
}
}  // namespace

int PileGrid::cellAt(double x, int axis) const
{
  return static_cast<int>(std::clamp((x - origin[axis]) * cells_per_metre, 0.0, count[axis] - 1.0));
}

float halfEdge(const Pile& pile, std::size_t i, int axis)
{
  return 0.5f * std::abs(pile.sweep[i][axis]) + reachOf(pile, i);
}

PileGrid::Entry entryOf(const Pile& pile, std::size_t i)
{
  PileGrid::Entry entry;
  entry.centre = (pile.home[i] - pile.grid.origin).cast<float>() + 0.5f * pile.sweep[i];
  // Far from the origin of the grid a float is coarse: the box grows by its rounding.
  for (int axis = 0; axis < 3; ++axis)
    entry.half[axis] = halfEdge(pile, i, axis) + 1e-6f * std::abs(entry.centre[axis]);
  entry.round = 0.5f * pile.sweep[i].norm() + reachOf(pile, i) + 2e-6f * entry.centre.cwiseAbs().maxCoeff();
  entry.slot = static_cast<std::uint32_t>(i);
  return entry;
}

void linkNear(Pile& pile, Workers& workers)
{
  layOut(pile);
  sortIntoCells(pile);
  linkCells(pile, workers);
  linkLarge(pile);
}
}  // namespace ping_pong
