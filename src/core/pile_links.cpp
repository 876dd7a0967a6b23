// Who may touch whom: links of balls whose ways for a while come near each other, until a ball leaves its way.
#include <algorithm>
#include <cmath>

#include "count.h"
#include "pile_grid.h"
#include "world_state.h"

namespace ping_pong
{
namespace
{
using Eigen::Vector3f;

constexpr double kMargin = 0.08;      // that links cover around the way of a ball, in mean radii
constexpr double kStepsAhead = 8.0;   // way that links cover, in steps of length h,
constexpr double kRadiiAhead = 2.0;   // unless it is longer than this; one step at least
constexpr std::size_t kManyStrays = 1000;  // balls that may leave their boxes before all are linked anew,
constexpr std::size_t kStrayPart = 8;      // and one in so many of them

Vector3d endOfStep(const Pile& pile, std::size_t i)
{
  const Vector3d a = pile.pathAcceleration(i);
  return pile.movers[i].p + pile.h * (pile.movers[i].v + (0.5 * pile.h) * a);
}

bool covered(const Pile& pile, std::size_t i)
{
  const Vector3f way = (endOfStep(pile, i) - pile.home[i]).cast<float>();
  if (way.squaredNorm() <= pile.margin * pile.margin) return true;
  const Vector3f& sweep = pile.sweep[i];
  const float round = 0.5f * sweep.norm() + pile.margin;
  return ((way - sweep.cwiseMax(0.0f)).array() <= pile.margin).all() &&
         ((sweep.cwiseMin(0.0f) - way).array() <= pile.margin).all() && (way - 0.5f * sweep).squaredNorm() <= round * round;
}

// A box around the way from home. After an impact in this step the way begins where it happened.
void coverWay(Pile& pile, std::size_t i)
{
  const Mover& mover = pile.movers[i];
  const Vector3d a = pile.pathAcceleration(i);
  const double t = mover.clock;
  const Vector3d from = pile.movers[i].p + t * (mover.v + (0.5 * t) * a);
  pile.anchor[i] += (pile.home[i] - from).cast<float>();
  pile.home[i] = from;
  const double speed = mover.v.norm();
  const double reach = kRadiiAhead * pile.radius(i);
  const double ahead = std::max(pile.h, std::min(kStepsAhead * pile.h, speed > 0.0 ? reach / speed : kStepsAhead * pile.h));
  pile.sweep[i] = (ahead * (mover.v + (0.5 * ahead) * a)).cast<float>();
}

bool linked(const Pile& pile, std::uint32_t ball, std::size_t body, std::size_t shape)
{
  for (std::uint32_t l = pile.first_body[ball]; l != Pile::kEndOfChain; l = pile.bodies[l].next)
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
      pile.bodies.push_back({i, pile.first_body[i], static_cast<std::uint16_t>(b), static_cast<std::uint16_t>(s), {}});
      pile.first_body[i] = static_cast<std::uint32_t>(pile.bodies.size() - 1);
    }
  }
}

void linkBodies(WorldState& world)
{
  Pile& pile = world.pile;
  pile.first_body.assign(pile.movers.size(), Pile::kEndOfChain);
  for (std::uint32_t i = 0; i < pile.movers.size(); ++i) linkWithBodies(world, i);
}

void chainPair(Pile& pile, std::uint32_t l)
{
  PairLink& link = pile.pairs[l];
  link.next_a = pile.first_link[link.a];
  link.next_b = pile.first_link[link.b];
  pile.first_link[link.a] = 2 * l;
  pile.first_link[link.b] = 2 * l + 1;
}

void chainPairs(Pile& pile)
{
  pile.first_link.assign(pile.movers.size(), Pile::kEndOfChain);
  for (std::uint32_t l = static_cast<std::uint32_t>(pile.pairs.size()); l-- > 0;) chainPair(pile, l);
}

// Links that were there before keep what they know.
void remember(Pile& pile)
{
  for (const KeptBalls& old : pile.old_kept)
    pile.anyLink(old.a, [&](std::uint32_t l) {
      const bool same = pile.pairs[l].a == old.a && pile.pairs[l].b == old.b;
      if (same) pile.kept.push_back({l, old.kept.push, old.kept.held});
      return same;
    });
  std::sort(pile.kept.begin(), pile.kept.end(), [](const KeptPair& p, const KeptPair& q) { return p.link < q.link; });
  pile.old_kept.clear();
  for (const BodyLink& old : pile.old_bodies)
    for (std::uint32_t l = pile.first_body[old.ball]; l != Pile::kEndOfChain; l = pile.bodies[l].next)
      if (pile.bodies[l].body == old.body && pile.bodies[l].shape == old.shape) pile.bodies[l].push = old.push;
}

// --- a ball that leaves its box before the others ---

void linkStray(Pile& pile, std::uint32_t i, const PileGrid::Entry& mine, const PileGrid::Entry& other)
{
  const std::uint32_t k = other.slot;
  if (k == i || !overlap(mine, other)) return;
  if (pile.anyLink(i, [&](std::uint32_t l) { return pile.pairs[l].a == k || pile.pairs[l].b == k; })) return;
  pile.active_pairs.push_back(static_cast<std::uint32_t>(pile.pairs.size()));
  pile.pairs.push_back({std::min(i, k), std::max(i, k), 0, 0});
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
  return pile.grid.strays.size() >= std::min(kManyStrays, pile.movers.size() / kStrayPart + 1);
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
  if (pile.movers.size() > 1) count(Law::BroadPhase);
  double radii = 0.0;
  for (std::size_t i = 0; i < pile.movers.size(); ++i) radii += pile.radius(i);
  pile.margin = static_cast<float>(kMargin * radii / static_cast<double>(pile.movers.size()));
  for (std::size_t i = 0; i < pile.movers.size(); ++i) coverWay(pile, i);
  detachKept(pile);
  pile.old_bodies.swap(pile.bodies);
  pile.bodies.clear();
  linkNear(pile);
  linkBodies(world);
  chainPairs(pile);
  remember(pile);
  pile.links_void = false;
  pile.active_void = true;
  pile.body_versions = versionsOf(world);
}
}  // namespace

void detachKept(Pile& pile)
{
  for (std::vector<KeptPair>* list : {&pile.kept, &pile.kept_asleep})
  {
    for (const KeptPair& kept : *list) pile.old_kept.push_back({pile.pairs[kept.link].a, pile.pairs[kept.link].b, kept});
    list->clear();
  }
  pile.pairs.clear();
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

namespace
{
bool anyAwake(const Pile& pile, const PairLink& link)
{
  return !pile.movers[link.a].asleep || !pile.movers[link.b].asleep;
}

// What is kept, anew by who is awake.
void divideKept(Pile& pile)
{
  pile.all_kept.resize(pile.kept.size() + pile.kept_asleep.size());
  std::merge(pile.kept.begin(), pile.kept.end(), pile.kept_asleep.begin(), pile.kept_asleep.end(), pile.all_kept.begin(),
             [](const KeptPair& p, const KeptPair& q) { return p.link < q.link; });
  pile.kept.clear();
  pile.kept_asleep.clear();
  for (const KeptPair& kept : pile.all_kept)
    (anyAwake(pile, pile.pairs[kept.link]) ? pile.kept : pile.kept_asleep).push_back(kept);
}
}  // namespace

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
    if (anyAwake(pile, pile.pairs[l])) pile.active_pairs.push_back(l);
  for (std::uint32_t l = 0; l < pile.bodies.size(); ++l)
    if (!pile.movers[pile.bodies[l].ball].asleep) pile.active_bodies.push_back(l);
  divideKept(pile);
}
}  // namespace ping_pong
