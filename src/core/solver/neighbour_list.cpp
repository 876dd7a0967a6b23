// Who may touch whom: links of balls whose ways for a while come near each other, until a ball leaves its way.
#include <algorithm>
#include <cmath>

#include "base/law_counter.h"
#include "solver/neighbour_grid.h"
#include "solver/slabs.h"

namespace ping_pong
{
namespace
{
using Eigen::Vector3f;

constexpr double kMargin = 0.08;           // that links cover around the way of a ball, in mean radii
constexpr double kStepsAhead = 8.0;        // way that links cover, in steps of length h,
constexpr double kRadiiAhead = 2.0;        // unless it is longer than this; one step at least
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
         ((sweep.cwiseMin(0.0f) - way).array() <= pile.margin).all() &&
         (way - 0.5f * sweep).squaredNorm() <= round * round;
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
  const double ahead =
      std::max(pile.h, std::min(kStepsAhead * pile.h, speed > 0.0 ? reach / speed : kStepsAhead * pile.h));
  pile.sweep[i] = (ahead * (mover.v + (0.5 * ahead) * a)).cast<float>();
}

bool linked(const Pile& pile, std::uint32_t ball, std::size_t body, std::size_t shape)
{
  for (std::uint32_t l = pile.first_body[ball]; l != Pile::kEndOfChain; l = pile.bodies[l].next)
    if (pile.bodies[l].body == body && pile.bodies[l].shape == shape) return true;
  return false;
}

// With the still bodies on its way that it is not linked with yet.
void linkWithBodies(WorldWithSolver& world, std::uint32_t i)
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
      pile.bodies.push_back({i, pile.first_body[i], static_cast<std::uint16_t>(b), static_cast<std::uint16_t>(s)});
      pile.first_body[i] = static_cast<std::uint32_t>(pile.bodies.size() - 1);
    }
  }
}

void linkBodies(WorldWithSolver& world)
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
  pile.first_link[link.a] = {l, 0};
  pile.first_link[link.b] = {l, 1};
}

void chainPairs(Pile& pile)
{
  pile.first_link.assign(pile.movers.size(), PairEnd::endOfChain());
  for (std::uint32_t l = static_cast<std::uint32_t>(pile.pairs.size()); l-- > 0;) chainPair(pile, l);
}

// Links that were there before keep what they know.
void remember(Pile& pile)
{
  pile.pushes.assign(pile.pairs.size(), Lanes{});
  pile.held.assign(pile.pairs.size(), -1.0f);
  for (const KeptPair& old : pile.old_kept)
    pile.anyLink(old.a,
                 [&](std::uint32_t l)
                 {
                   if (pile.pairs[l].a != old.a || pile.pairs[l].b != old.b) return false;
                   pile.pushes[l] = old.push;
                   pile.held[l] = old.held;
                   return true;
                 });
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
  const auto l = static_cast<std::uint32_t>(pile.pairs.size());
  pile.pairs.push_back({std::min(i, k), std::max(i, k), {}, {}});
  pile.pushes.push_back(Lanes{});
  pile.held.push_back(-1.0f);
  PileShare& share = shareOf(pile, pile.pairs[l]);
  share.pairs.push_back(l);
  share.active_pairs.push_back(l);
  chainPair(pile, l);
}

void stray(WorldWithSolver& world, std::uint32_t i)
{
  Pile& pile = world.pile;
  coverWay(pile, i);
  const PileGrid::Entry mine = entryOf(pile, i);
  const PileGrid& grid = pile.grid;
  eachCellNear(grid, mine,
               [&](std::size_t cell)
               {
                 for (std::uint32_t e = grid.start[cell]; e < grid.start[cell + 1]; ++e)
                   linkStray(pile, i, mine, grid.entries[e]);
               });
  for (const PileGrid::Entry& other : grid.large) linkStray(pile, i, mine, other);
  for (const PileGrid::Entry& other : grid.strays) linkStray(pile, i, mine, other);
  pile.grid.strays.push_back(mine);
  const std::size_t before = pile.bodies.size();
  linkWithBodies(world, i);
  PileShare& share = pile.shares[pile.share_of[i]];
  for (std::size_t l = before; l < pile.bodies.size(); ++l)
    for (std::vector<std::uint32_t>* list : {&share.bodies, &share.active_bodies})
      list->push_back(static_cast<std::uint32_t>(l));
}

bool manyStrays(const Pile& pile, std::size_t more)
{
  return pile.grid.strays.size() + more > std::min(kManyStrays, pile.movers.size() / kStrayPart + 1);
}

// How many balls leave their boxes in this step.
std::size_t findLeaving(WorldWithSolver& world)
{
  Pile& pile = world.pile;
  eachShare(world,
            [&pile](PileShare& share)
            {
              share.leaving.clear();
              for (const std::uint32_t i : share.awake)
                if (!covered(pile, i)) share.leaving.push_back(i);
            });
  std::size_t leaving = 0;
  for (const PileShare& share : pile.shares) leaving += share.leaving.size();
  return leaving;
}

unsigned versionsOf(const WorldWithSolver& world)
{
  unsigned sum = 0;
  for (const BodyRecord& body : world.bodies) sum += body.version;
  return sum;
}

void build(WorldWithSolver& world)
{
  Pile& pile = world.pile;
  if (pile.movers.size() > 1) count(Law::BroadPhase);
  detachKept(pile);
  pile.old_bodies.swap(pile.bodies);
  pile.bodies.clear();
  sortSlots(pile);
  double radii = 0.0;
  for (std::size_t i = 0; i < pile.movers.size(); ++i) radii += pile.radius(i);
  pile.margin = static_cast<float>(kMargin * radii / static_cast<double>(pile.movers.size()));
  for (std::size_t i = 0; i < pile.movers.size(); ++i) coverWay(pile, i);
  linkNear(pile, world.workers);
  linkBodies(world);
  chainPairs(pile);
  cutPile(pile, world.scene.forces.gravity);
  shareLinks(pile);
  remember(pile);
  pile.links_void = false;
  pile.body_versions = versionsOf(world);
}
}  // namespace

void detachKept(Pile& pile)
{
  for (std::size_t l = 0; l < pile.pairs.size(); ++l)
    if (pile.pushes[l][3] > 0.0f || pile.held[l] >= 0.0f)
      pile.old_kept.push_back({pile.pairs[l].a, pile.pairs[l].b, pile.held[l], pile.pushes[l]});
  pile.pairs.clear();
}

void updateLinks(WorldWithSolver& world)
{
  Pile& pile = world.pile;
  bool anew = pile.links_void || pile.body_versions != versionsOf(world);
  if (!anew)
  {
    updateActive(world);
    anew = manyStrays(pile, findLeaving(world));
  }
  if (anew)
    build(world);
  else
    for (const PileShare& share : pile.shares)
      for (const std::uint32_t i : share.leaving) stray(world, i);
  updateActive(world);
}

bool updateLinksAfterImpact(WorldWithSolver& world, std::uint32_t a, std::uint32_t b)
{
  Pile& pile = world.pile;
  for (const std::uint32_t i : {a, b})
  {
    if (covered(pile, i)) continue;
    if (manyStrays(pile, 1))
    {
      build(world);
      updateActive(world);
      return true;
    }
    stray(world, i);
  }
  return false;
}
}  // namespace ping_pong
