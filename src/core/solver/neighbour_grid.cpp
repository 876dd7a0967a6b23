#include "solver/neighbour_grid.h"

#include <algorithm>
#include <cmath>

#include "solver/slabs.h"

namespace ping_pong
{
namespace
{
constexpr float kContactSlack = 2e-4f;  // contacts are looked at that far before they touch [m]
constexpr double kLargeBox = 1.5;       // in mean edges: one box that is longer would make all cells longer
constexpr double kCellsPerBall = 2.0;   // at most: each costs memory and a look, empty or not
constexpr double kSpread = 3.0;  // the grid covers so many standard deviations; balls outside are in its outer cells

float reachOf(const ContactSolver& solver, std::size_t i)
{
  return solver.margin + kContactSlack + static_cast<float>(solver.radius(i));
}

void layOut(ContactSolver& solver)
{
  const double n = static_cast<double>(solver.movers.size());
  Vector3d sum = Vector3d::Zero();
  double edge = 0.0;
  for (std::size_t i = 0; i < solver.movers.size(); ++i)
  {
    sum += solver.home[i];
    edge += 2.0 * std::max({halfEdge(solver, i, 0), halfEdge(solver, i, 1), halfEdge(solver, i, 2)});
  }
  const Vector3d mean = sum / n;
  Vector3d square = Vector3d::Zero();
  for (const Vector3d& home : solver.home) square += (home - mean).cwiseAbs2();
  const Vector3d half = kSpread * (square / n).cwiseSqrt();
  NeighbourGrid& grid = solver.grid;
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

void sortIntoCells(ContactSolver& solver)
{
  NeighbourGrid& grid = solver.grid;
  const std::size_t n = solver.movers.size();
  grid.start.assign(static_cast<std::size_t>(grid.count[0]) * grid.count[1] * grid.count[2] + 1, 0);
  grid.cell.resize(n);
  grid.large.clear();
  grid.strays.clear();
  for (std::size_t i = 0; i < n; ++i)
  {
    const NeighbourGrid::Entry entry = entryOf(solver, i);
    grid.cell[i] = kNoCell;
    if (2.0f * entry.half.maxCoeff() > grid.large_edge)
    {
      grid.large.push_back(entry);
      continue;
    }
    const Vector3d centre = solver.home[i] + 0.5 * solver.displacement[i].cast<double>();
    const int x = grid.cellAt(centre[0], 0), y = grid.cellAt(centre[1], 1), z = grid.cellAt(centre[2], 2);
    grid.cell[i] = static_cast<std::uint32_t>((z * grid.count[1] + y) * grid.count[0] + x);
    ++grid.start[grid.cell[i]];
  }
  std::uint32_t total = 0;
  for (std::uint32_t& start : grid.start) start = total += start;  // ends; filled from behind they become starts
  grid.entries.resize(total);
  for (std::size_t i = n; i-- > 0;)
    if (grid.cell[i] != kNoCell) grid.entries[--grid.start[grid.cell[i]]] = entryOf(solver, i);
}

void addIfNear(std::vector<NeighbourPair>& pairs, const NeighbourGrid::Entry& a, const NeighbourGrid::Entry& b)
{
  if (overlap(a, b)) pairs.push_back({std::min(a.slot, b.slot), std::max(a.slot, b.slot), {}, {}});
}

// Each cell of some rows with the half of its neighbours that comes after it; three cells in a row lie side by side.
void searchRows(const NeighbourGrid& grid, int begin, int end, std::vector<NeighbourPair>& pairs)
{
  const int nx = grid.count[0], ny = grid.count[1], nz = grid.count[2];
  const auto row = [&](std::uint32_t from, int x0, int x1, int y, int z)
  {
    if (y < 0 || y >= ny || z >= nz) return;
    const std::size_t line = static_cast<std::size_t>(z * ny + y) * static_cast<std::size_t>(nx);
    const std::uint32_t begin = grid.start[line + static_cast<std::size_t>(std::max(x0, 0))];
    const std::uint32_t end = grid.start[line + static_cast<std::size_t>(std::min(x1, nx - 1)) + 1];
    for (std::uint32_t other = begin; other < end; ++other) addIfNear(pairs, grid.entries[from], grid.entries[other]);
  };
  std::size_t cell = static_cast<std::size_t>(begin) * static_cast<std::size_t>(nx);
  for (int line = begin; line < end; ++line)
    for (int x = 0; x < nx; ++x, ++cell)
      for (std::uint32_t i = grid.start[cell]; i < grid.start[cell + 1]; ++i)
      {
        const int y = line % ny, z = line / ny;
        for (std::uint32_t k = i + 1; k < grid.start[cell + 1]; ++k) addIfNear(pairs, grid.entries[i], grid.entries[k]);
        if (x + 1 < nx) row(i, x + 1, x + 1, y, z);
        row(i, x - 1, x + 1, y + 1, z);
        for (int dy = -1; dy <= 1; ++dy) row(i, x - 1, x + 1, y + dy, z + 1);
      }
}

// In parts that threads can share: always the same ones, joined in their order.
void searchCells(ContactSolver& solver, Workers& workers)
{
  const NeighbourGrid& grid = solver.grid;
  const auto parts = static_cast<int>(solver.found.size()), rows = grid.count[1] * grid.count[2];
  workers.each(solver.found.size(), solver.movers.size() < kBallsWorthThreads ? solver.found.size() : 1,
               [&](std::size_t begin, std::size_t end, std::size_t)
               {
                 for (int part = static_cast<int>(begin); part < static_cast<int>(end); ++part)
                 {
                   std::vector<NeighbourPair>& found = solver.found[static_cast<std::size_t>(part)];
                   found.clear();
                   searchRows(grid, part * rows / parts, (part + 1) * rows / parts, found);
                 }
               });
  for (const std::vector<NeighbourPair>& found : solver.found)
    solver.pairs.insert(solver.pairs.end(), found.begin(), found.end());
}

void searchLarge(ContactSolver& solver)
{
  const std::vector<NeighbourGrid::Entry>& large = solver.grid.large;
  for (std::size_t i = 0; i < large.size(); ++i)
  {
    for (std::size_t k = i + 1; k < large.size(); ++k) addIfNear(solver.pairs, large[i], large[k]);
    eachCellNear(solver.grid, large[i],
                 [&](std::size_t cell)
                 {
                   for (std::uint32_t other = solver.grid.start[cell]; other < solver.grid.start[cell + 1]; ++other)
                     addIfNear(solver.pairs, large[i], solver.grid.entries[other]);
                 });
  }
}
}  // namespace

int NeighbourGrid::cellAt(double x, int axis) const
{
  return static_cast<int>(std::clamp((x - origin[axis]) * cells_per_metre, 0.0, count[axis] - 1.0));
}

float halfEdge(const ContactSolver& solver, std::size_t i, int axis)
{
  return 0.5f * std::abs(solver.displacement[i][axis]) + reachOf(solver, i);
}

NeighbourGrid::Entry entryOf(const ContactSolver& solver, std::size_t i)
{
  NeighbourGrid::Entry entry;
  entry.centre = (solver.home[i] - solver.grid.origin).cast<float>() + 0.5f * solver.displacement[i];
  // Far from the origin of the grid a float is coarse: the box grows by its rounding.
  for (int axis = 0; axis < 3; ++axis)
    entry.half[axis] = halfEdge(solver, i, axis) + 1e-6f * std::abs(entry.centre[axis]);
  entry.round = 0.5f * solver.displacement[i].norm() + reachOf(solver, i) + 2e-6f * entry.centre.cwiseAbs().maxCoeff();
  entry.slot = static_cast<std::uint32_t>(i);
  return entry;
}

void findNeighbours(ContactSolver& solver, Workers& workers)
{
  layOut(solver);
  sortIntoCells(solver);
  searchCells(solver, workers);
  searchLarge(solver);
}
}  // namespace ping_pong
