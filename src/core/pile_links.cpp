// Who may touch whom: balls sorted into the cells of a grid by the boxes that they can sweep for a while.
#include <algorithm>
#include <cmath>

#include "count.h"
#include "pile.h"
#include "world_state.h"

namespace ping_pong
{
namespace
{
using Eigen::Vector3f;

constexpr double kMargin = 0.08;      // that links cover around the way of a ball, in mean radii
constexpr double kStepsAhead = 8.0;   // way that links cover, in steps of length h,
constexpr double kRadiiAhead = 2.0;   // unless it is longer than this; one step at least
constexpr float kTouchSlack = 2e-4f;  // contacts are looked at that far before they touch [m]
constexpr double kLargeBox = 1.5;     // in mean edges
constexpr std::size_t kManyStrays = 1000;  // balls that may leave their boxes before all are linked anew,
constexpr std::size_t kStrayPart = 20;     // and one in so many of them
constexpr double kCellsPerBall = 2.0;
constexpr double kSpread = 3.0;       // the grid covers so many standard deviations; balls outside are in its outer cells

Vector3d endOfStep(const Pile& pile, std::size_t i)
{
  const Vector3d a = pile.pathAcceleration(i);
  return pile.p[i] + pile.h * (pile.movers[i].v + (0.5 * pile.h) * a);
}

bool covered(const Pile& pile, std::size_t i)
{
  const Vector3f way = (endOfStep(pile, i) - pile.home[i]).cast<float>();
  const Vector3f& sweep = pile.sweep[i];
  return ((way - sweep.cwiseMax(0.0f)).array() <= pile.margin).all() &&
         ((sweep.cwiseMin(0.0f) - way).array() <= pile.margin).all();
}

// A box around the way from home. After an impact in this step the way begins where it happened.
void coverWay(Pile& pile, std::size_t i)
{
  const Mover& mover = pile.movers[i];
  const Vector3d a = pile.pathAcceleration(i);
  const double t = mover.clock;
  const Vector3d from = pile.p[i] + t * (mover.v + (0.5 * t) * a);
  pile.anchor[i] += (pile.home[i] - from).cast<float>();
  pile.home[i] = from;
  const double speed = mover.v.norm();
  const double reach = kRadiiAhead * pile.radius(i);
  const double ahead = std::max(pile.h, std::min(kStepsAhead * pile.h, speed > 0.0 ? reach / speed : kStepsAhead * pile.h));
  pile.sweep[i] = (ahead * (mover.v + (0.5 * ahead) * a)).cast<float>();
}

// --- the grid ---

float halfEdge(const Pile& pile, std::size_t i, int axis)
{
  return 0.5f * std::abs(pile.sweep[i][axis]) + pile.margin + kTouchSlack + static_cast<float>(pile.radius(i));
}

void layOut(Pile& pile)
{
  const double n = static_cast<double>(pile.p.size());
  Vector3d sum = Vector3d::Zero();
  double edge = 0.0;
  for (std::size_t i = 0; i < pile.p.size(); ++i)
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

PileGrid::Entry entryOf(const Pile& pile, std::size_t i)
{
  PileGrid::Entry entry;
  entry.centre = (pile.home[i] - pile.grid.origin).cast<float>() + 0.5f * pile.sweep[i];
  // Far from the origin of the grid a float is coarse: the box grows by its rounding.
  for (int axis = 0; axis < 3; ++axis) entry.half[axis] = halfEdge(pile, i, axis) + 1e-6f * std::abs(entry.centre[axis]);
  entry.slot = static_cast<std::uint32_t>(i);
  return entry;
}

constexpr std::uint32_t kNoCell = ~0u;

void sortIntoCells(Pile& pile)
{
  PileGrid& grid = pile.grid;
  const std::size_t n = pile.p.size();
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

bool overlap(const PileGrid::Entry& a, const PileGrid::Entry& b)
{
  return ((a.centre - b.centre).cwiseAbs().array() <= (a.half + b.half).array()).all();
}

void link(Pile& pile, const PileGrid::Entry& a, const PileGrid::Entry& b)
{
  if (overlap(a, b)) pile.pairs.push_back({std::min(a.slot, b.slot), std::max(a.slot, b.slot), {}, -1.0f});
}

// Each cell with the half of its neighbours that comes after it; three cells in a row lie side by side.
void linkCells(Pile& pile)
{
  const PileGrid& grid = pile.grid;
  const int nx = grid.count[0], ny = grid.count[1], nz = grid.count[2];
  const auto row = [&](std::uint32_t from, int x0, int x1, int y, int z) {
    if (y < 0 || y >= ny || z >= nz) return;
    const std::size_t line = static_cast<std::size_t>(z * ny + y) * static_cast<std::size_t>(nx);
    const std::uint32_t begin = grid.start[line + static_cast<std::size_t>(std::max(x0, 0))];
    const std::uint32_t end = grid.start[line + static_cast<std::size_t>(std::min(x1, nx - 1)) + 1];
    for (std::uint32_t other = begin; other < end; ++other) link(pile, grid.entries[from], grid.entries[other]);
  };
  std::size_t cell = 0;
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x, ++cell)
        for (std::uint32_t i = grid.start[cell]; i < grid.start[cell + 1]; ++i)
        {
          for (std::uint32_t k = i + 1; k < grid.start[cell + 1]; ++k) link(pile, grid.entries[i], grid.entries[k]);
          if (x + 1 < nx) row(i, x + 1, x + 1, y, z);
          row(i, x - 1, x + 1, y + 1, z);
          for (int dy = -1; dy <= 1; ++dy) row(i, x - 1, x + 1, y + dy, z + 1);
        }
}

// Every cell that may hold the centre of a box that overlaps this one.
template <typename Action>
void eachCellNear(const PileGrid& grid, const PileGrid::Entry& entry, const Action& action)
{
  std::array<int, 3> low, high;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double centre = grid.origin[axis] + static_cast<double>(entry.centre[axis]);
    const double reach = static_cast<double>(entry.half[axis] + 0.5f * grid.large_edge);
    low[axis] = grid.cellAt(centre - reach, axis);
    high[axis] = grid.cellAt(centre + reach, axis);
  }
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x)
        action(static_cast<std::size_t>((z * grid.count[1] + y) * grid.count[0] + x));
}

void linkLarge(Pile& pile)
{
  const std::vector<PileGrid::Entry>& large = pile.grid.large;
  for (std::size_t i = 0; i < large.size(); ++i)
  {
    for (std::size_t k = i + 1; k < large.size(); ++k) link(pile, large[i], large[k]);
    eachCellNear(pile.grid, large[i], [&](std::size_t cell) {
      for (std::uint32_t other = pile.grid.start[cell]; other < pile.grid.start[cell + 1]; ++other)
        link(pile, large[i], pile.grid.entries[other]);
    });
  }
}

bool linked(const Pile& pile, std::uint32_t ball, std::size_t body, std::size_t shape)
{
  for (std::uint32_t l = pile.first_body[ball]; l != Pile::kEndOfChain; l = pile.body_chain[l])
    if (pile.bodies[l].body == body && pile.bodies[l].shape == shape) return true;
  return false;
}

// With the still bodies on its way that it is not linked with yet.
void linkWithBodies(WorldState& world, std::uint32_t i)
{
  Pile& pile = world.pile;
  const Vector3d centre = pile.home[i] + 0.5 * pile.sweep[i].cast<double>();
  const Vector3d half(halfEdge(pile, i, 0), halfEdge(pile, i, 1), halfEdge(pile, i, 2));
  Box box;
  box.low = centre - half;
  box.high = centre + half;
  for (std::size_t b = 0; b < world.bodies.size(); ++b)
  {
    if (world.bodies[b].moving) continue;
    for (std::size_t s = 0; s < world.bodies[b].boxes.size(); ++s)
    {
      if (!box.overlaps(world.bodies[b].boxes[s]) || linked(pile, i, b, s)) continue;
      pile.body_chain.push_back(pile.first_body[i]);
      pile.first_body[i] = static_cast<std::uint32_t>(pile.bodies.size());
      pile.bodies.push_back({i, static_cast<std::uint16_t>(b), static_cast<std::uint16_t>(s), {}});
    }
  }
}

void linkBodies(WorldState& world)
{
  Pile& pile = world.pile;
  pile.body_chain.clear();
  pile.first_body.assign(pile.p.size(), Pile::kEndOfChain);
  for (std::uint32_t i = 0; i < pile.p.size(); ++i) linkWithBodies(world, i);
}

void chainPair(Pile& pile, std::uint32_t l)
{
  const std::uint32_t a = pile.pairs[l].a, b = pile.pairs[l].b;
  pile.chain[l] = {pile.first_link[a], pile.first_link[b]};
  pile.first_link[a] = 2 * l;
  pile.first_link[b] = 2 * l + 1;
}

void chainPairs(Pile& pile)
{
  pile.first_link.assign(pile.p.size(), Pile::kEndOfChain);
  pile.chain.resize(pile.pairs.size());
  for (std::uint32_t l = static_cast<std::uint32_t>(pile.pairs.size()); l-- > 0;) chainPair(pile, l);
}

// Links that were there before keep what they know.
void remember(Pile& pile)
{
  for (const PairLink& old : pile.old_pairs)
  {
    if (old.push.normal == 0.0f && old.held < 0.0f) continue;
    for (std::uint32_t l = pile.first_link[old.a]; l != Pile::kEndOfChain; l = pile.chain[l / 2][l % 2])
      if (l % 2 == 0 && pile.pairs[l / 2].b == old.b) pile.pairs[l / 2] = old;
  }
  for (const BodyLink& old : pile.old_bodies)
    for (std::uint32_t l = pile.first_body[old.ball]; l != Pile::kEndOfChain; l = pile.body_chain[l])
      if (pile.bodies[l].body == old.body && pile.bodies[l].shape == old.shape) pile.bodies[l].push = old.push;
}

// --- a ball that leaves its box before the others ---

void linkStray(Pile& pile, std::uint32_t i, const PileGrid::Entry& mine, const PileGrid::Entry& other)
{
  const std::uint32_t k = other.slot;
  if (k == i || !overlap(mine, other)) return;
  for (std::uint32_t l = pile.first_link[i]; l != Pile::kEndOfChain; l = pile.chain[l / 2][l % 2])
    if (pile.pairs[l / 2].a == k || pile.pairs[l / 2].b == k) return;
  pile.active_pairs.push_back(static_cast<std::uint32_t>(pile.pairs.size()));
  pile.pairs.push_back({std::min(i, k), std::max(i, k), {}, -1.0f});
  pile.chain.emplace_back();
  chainPair(pile, static_cast<std::uint32_t>(pile.pairs.size() - 1));
}

void stray(WorldState& world, std::uint32_t i)
{
  Pile& pile = world.pile;
  coverWay(pile, i);
  const PileGrid::Entry mine = entryOf(pile, i);
  const PileGrid& grid = pile.grid;
  eachCellNear(grid, mine, [&](std::size_t cell) {
    for (std::uint32_t e = grid.start[cell]; e < grid.start[cell + 1]; ++e) linkStray(pile, i, mine, grid.entries[e]);
  });
  for (const PileGrid::Entry& other : grid.large) linkStray(pile, i, mine, other);
  for (const PileGrid::Entry& other : grid.strays) linkStray(pile, i, mine, other);
  pile.grid.strays.push_back(mine);
  const std::size_t before = pile.bodies.size();
  linkWithBodies(world, i);
  for (std::size_t l = before; l < pile.bodies.size(); ++l) pile.active_bodies.push_back(static_cast<std::uint32_t>(l));
}

bool manyStrays(const Pile& pile)
{
  return pile.grid.strays.size() >= std::min(kManyStrays, pile.p.size() / kStrayPart + 1);
}

unsigned versionsOf(const WorldState& world)
{
  unsigned sum = 0;
  for (const BodyRecord& body : world.bodies) sum += body.version;
  return sum;
}

void build(WorldState& world)
{
  Pile& pile = world.pile;
  if (pile.p.size() > 1) count(Law::BroadPhase);
  double radii = 0.0;
  for (std::size_t i = 0; i < pile.p.size(); ++i) radii += pile.radius(i);
  pile.margin = static_cast<float>(kMargin * radii / static_cast<double>(pile.p.size()));
  for (std::size_t i = 0; i < pile.p.size(); ++i) coverWay(pile, i);
  pile.old_pairs.swap(pile.pairs);
  pile.old_bodies.swap(pile.bodies);
  pile.pairs.clear();
  pile.bodies.clear();
  layOut(pile);
  sortIntoCells(pile);
  linkCells(pile);
  linkLarge(pile);
  linkBodies(world);
  chainPairs(pile);
  remember(pile);
  pile.links_void = false;
  pile.active_void = true;
  pile.body_versions = versionsOf(world);
}
}  // namespace

int PileGrid::cellAt(double x, int axis) const
{
  return static_cast<int>(std::clamp((x - origin[axis]) * cells_per_metre, 0.0, count[axis] - 1.0));
}

void updateLinks(WorldState& world)
{
  Pile& pile = world.pile;
  bool anew = pile.links_void || pile.body_versions != versionsOf(world);
  updateActive(pile);
  for (std::size_t k = 0; k < pile.awake.size() && !anew; ++k)
  {
    if (covered(pile, pile.awake[k])) continue;
    anew = manyStrays(pile);
    if (!anew) stray(world, pile.awake[k]);
  }
  if (anew) build(world);
  updateActive(pile);
}

bool updateLinksAfterImpact(WorldState& world, std::uint32_t a, std::uint32_t b)
{
  Pile& pile = world.pile;
  for (const std::uint32_t i : {a, b})
  {
    if (covered(pile, i)) continue;
    if (manyStrays(pile))
    {
      build(world);
      updateActive(pile);
      return true;
    }
    stray(world, i);
  }
  return false;
}

void updateActive(Pile& pile)
{
  if (!pile.active_void) return;
  pile.active_void = false;
  pile.awake.clear();
  pile.active_pairs.clear();
  pile.active_bodies.clear();
  for (std::uint32_t i = 0; i < pile.movers.size(); ++i)
    if (!pile.movers[i].asleep) pile.awake.push_back(i);
  if (pile.awake.empty()) return;
  for (std::uint32_t l = 0; l < pile.pairs.size(); ++l)
    if (!pile.movers[pile.pairs[l].a].asleep || !pile.movers[pile.pairs[l].b].asleep) pile.active_pairs.push_back(l);
  for (std::uint32_t l = 0; l < pile.bodies.size(); ++l)
    if (!pile.movers[pile.bodies[l].ball].asleep) pile.active_bodies.push_back(l);
}
}  // namespace ping_pong
