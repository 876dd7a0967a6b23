// The iteration over touches, four at a time: those of a batch share no ball, so it comes to the same as one after the other.
#include <algorithm>

#include "solver/contact_forces.h"

namespace ping_pong
{
namespace
{
constexpr int kMostSweeps = 12;
constexpr int kMostOfBodies =
    500;  // over touches with bodies alone, where one moves: between two that are tilted by 1 / 10 against
          // each other an error falls by a hundredth in each
constexpr double kGoodEnough = 0.03;  // change of a velocity that is not passed on, in least impacts,
constexpr double kCreep = 6e-4;       // or less: a pile that creeps faster does not fall asleep [m/s]
const FoundPair kNoPair{{0.0f, 0.0f, 1.0f, 0.0f}, {}, {}};
constexpr float kTiny = 1e-30f;  // where 0 would be divided by

// The balls of a batch.
struct FourBalls
{
  std::array<Change*, kLanes> a, b;

  FourBalls(std::vector<Change>& changes, const TouchBatch& batch, bool pairs)
  {
    for (std::size_t k = 0; k < kLanes; ++k)
    {
      a[k] = &changes[batch.a[k]];
      if (pairs) b[k] = &changes[batch.b[k]];
    }
  }
};

using Number = Eigen::Vector4f Change::*;

Lanes of(const Change* ball, Number its)
{
  return lanesAt((ball->*its).data());
}

// Of the first balls, and those of the second ones taken away or added.
template <bool pairs>
[[gnu::always_inline]] inline LaneVectors difference(const FourBalls& balls, Number its)
{
  std::array<Lanes, kLanes> records;
  for (std::size_t k = 0; k < kLanes; ++k)
    records[k] = pairs ? of(balls.a[k], its) - of(balls.b[k], its) : of(balls.a[k], its);
  return vectorsOf(records);
}
template <bool pairs>
[[gnu::always_inline]] inline LaneVectors sum(const FourBalls& balls, Number its)
{
  std::array<Lanes, kLanes> records;
  for (std::size_t k = 0; k < kLanes; ++k)
    records[k] = pairs ? of(balls.a[k], its) + of(balls.b[k], its) : of(balls.a[k], its);
  return vectorsOf(records);
}

// Calls action(lane) for each touch.
template <class Action>
[[gnu::always_inline]] inline void eachLane(const TouchBatch& batch, const Action& action)
{
  if (batch.full())
    for (std::size_t k = 0; k < kLanes; ++k) action(k);
  else
    for (std::size_t k = 0; k < kLanes; ++k)
      if (batch.has(k)) action(k);
}

// Adds `what` to a number of a ball, as many times as the last component of one of its numbers says.
[[gnu::always_inline]] inline void add(Change* ball, Number its, Number share, Lanes what)
{
  putLanes(of(ball, its) + (ball->*share).w() * what, (ball->*its).data());
}

// An impulse along n and one across act on the first balls and, where those are pairs, against the second ones.
template <bool pairs>
[[gnu::always_inline]] inline void act(const FourBalls& balls, const TouchBatch& batch, Lanes along,
                                       const LaneVectors& across)
{
  const auto impulse = recordsOf(along * batch.n + across), turn = recordsOf(cross(across, batch.n));
  eachLane(batch,
           [&](std::size_t k)
           {
             add(balls.a[k], &Change::v, &Change::v, impulse[k]);
             add(balls.a[k], &Change::rim, &Change::rim, turn[k]);
             if (!pairs) return;
             add(balls.b[k], &Change::v, &Change::v, -impulse[k]);
             add(balls.b[k], &Change::rim, &Change::rim, turn[k]);
           });
}

// What friction adds, kept within Coulomb's cone.
[[gnu::always_inline]] inline LaneVectors slipImpulse(TouchBatch& batch, const LaneVectors& slip)
{
  const LaneVectors before = batch.tangent;
  const LaneVectors wanted = before - batch.slip_mass * slip;
  const Lanes size = squareRoot(greater(dot(wanted, wanted), allLanes(kTiny)));
  batch.tangent = lesser(batch.friction * batch.normal / size, allLanes(1.0f)) * wanted;
  return batch.tangent - before;
}

// One touch of each lane: its normal impulse never pulls. Returns where a velocity has changed by more than the root of `small`.
template <bool pairs>
[[gnu::always_inline]] inline LaneMask solve(std::vector<Change>& changes, TouchBatch& batch, float small)
{
  const FourBalls balls(changes, batch, pairs);
  const LaneVectors u = difference<pairs>(balls, &Change::v);
  const Lanes closing = dot(batch.n, u), before = batch.normal;
  batch.normal = greater(before + batch.normal_mass * (batch.target - closing), Lanes{});
  const Lanes impulse = batch.normal - before;
  if (!anyLane((impulse != Lanes{}) | (batch.normal != Lanes{})))
    return LaneMask{};  // where nothing presses, nothing rubs
  const LaneVectors rims = sum<pairs>(balls, &Change::rim);
  const LaneVectors across = slipImpulse(batch, batch.slip + u - closing * batch.n - cross(rims, batch.n));
  act<pairs>(balls, batch, impulse, across);
  constexpr float kBoth = pairs ? 4.0f : 1.0f;  // two balls of the same mass share the change
  return impulse * impulse + dot(across, across) > (kBoth * small) * (batch.normal_mass * batch.normal_mass);
}

// A sweep over the touches of a slab, those left out whose balls have not changed.
struct Sweep
{
  std::uint32_t since;  // on the counter of the pile: changes that touches do not know
  std::uint32_t now;
  float small;  // square of a change of a velocity that is not passed on [m^2/s^2]
};

// Without a branch for each lane: a processor cannot tell beforehand which of them change.
void mark(std::vector<std::uint32_t>& swept, const std::array<std::uint32_t, kLanes>& slots, LaneMask changed,
          std::uint32_t now)
{
  for (std::size_t k = 0; k < kLanes; ++k)
  {
    std::uint32_t& its = swept[slots[k]];
    its ^= (its ^ now) & static_cast<std::uint32_t>(changed[k]);
  }
}

template <bool pairs>
void sweep(Pile& pile, TouchBatch& batch, const Sweep& it, LaneMask& any_changed)
{
  bool any = false;
  for (std::size_t k = 0; k < kLanes; ++k)
  {
    any |= pile.swept[batch.a[k]] >= it.since;
    if (pairs) any |= pile.swept[batch.b[k]] >= it.since;
  }
  if (!any) return;
  const LaneMask changed = solve<pairs>(pile.changes, batch, it.small);
  if (!anyLane(changed)) return;
  any_changed |= changed;
  mark(pile.swept, batch.a, changed, it.now);
  if (pairs) mark(pile.swept, batch.b, changed, it.now);
}

void sweep(Pile& pile, PileShare& share, const Sweep& it, bool forwards)
{
  LaneMask changed{};
  for (TouchBatch& batch : share.body_batches) sweep<false>(pile, batch, it, changed);
  const auto pairs = [&](TouchBatch& batch) { sweep<true>(pile, batch, it, changed); };
  if (forwards)
    std::for_each(share.pair_batches.begin(), share.pair_batches.end(), pairs);
  else
    std::for_each(share.pair_batches.rbegin(), share.pair_batches.rend(), pairs);
  if (anyLane(changed)) share.changed = it.now;
}

// Nobody who writes to a ball of this share has changed any. (Those who do are not at work at the same time.)
bool quiet(const Pile& pile, const PileShare& share, std::uint32_t since)
{
  const std::size_t s = static_cast<std::size_t>(&share - pile.shares.data());
  if (s >= pile.slabs) return false;
  return share.changed < since && pile.shares.back().changed < since &&
         (s == 0 || pile.shares[s - 1].changed < since) && (s + 1 == pile.slabs || pile.shares[s + 1].changed < since);
}

// Distance of spheres that are this far apart or overlap, of the square of the distance of their centres less that of spheres
// that touch.
[[gnu::always_inline]] inline Lanes roomOf(Lanes squares, Lanes reach)
{
  return squares / (squareRoot(greater(squares + reach * reach, Lanes{})) + reach);
}

// Part of an overlap is taken out of the places, by as much of each ball as it is lighter.
[[gnu::always_inline]] inline void takeOut(const FourBalls& balls, const TouchBatch& batch, Lanes overlap)
{
  const Lanes out = pushOut(overlap);
  if (!anyLane(out > Lanes{})) return;
  const auto push = recordsOf((out * batch.normal_mass) * batch.n);
  eachLane(batch,
           [&](std::size_t k)
           {
             add(balls.a[k], &Change::p, &Change::v, push[k]);
             add(balls.b[k], &Change::p, &Change::v, -push[k]);
           });
}

// The same for all four, unless there are several kinds of balls.
void putKinds(const WorldWithSolver& world, TouchBatch& batch, Lanes& reach)
{
  const Pile& pile = world.pile;
  const auto friction = [&](const BallParams& a, const BallParams& b)
  { return static_cast<float>(world.scene.surfaces.at(a.material, b.material).friction); };
  const BallParams& first = pile.kinds.front().params;
  reach = allLanes(static_cast<float>(2.0 * first.radius));
  batch.friction = allLanes(friction(first, first));
  if (pile.kinds.size() == 1) return;
  for (std::size_t k = 0; k < kLanes; ++k)
  {
    reach[k] = static_cast<float>(pile.reach(batch.a[k], batch.b[k]));
    batch.friction[k] = friction(pile.params(batch.a[k]), pile.params(batch.b[k]));
  }
}

// With the impulses of the last step, which lie across the normal of this one.
template <bool pairs>
[[gnu::always_inline]] inline void begin(const FourBalls& balls, TouchBatch& batch)
{
  batch.tangent = batch.tangent - dot(batch.n, batch.tangent) * batch.n;
  act<pairs>(balls, batch, batch.normal, batch.tangent);
}

// A touch may close its gap within the step and no more, and leaves an overlap that was there as it is.
void startPairs(WorldWithSolver& world, TouchBatch& batch, const FoundPair* found)
{
  const FourBalls balls(world.pile.changes, batch, true);
  const float h = static_cast<float>(world.pile.h);
  Lanes light, give, reach;
  putKinds(world, batch, reach);
  for (std::size_t k = 0; k < kLanes; ++k)
  {
    light[k] = std::max(balls.a[k]->v.w() + balls.b[k]->v.w(), kTiny);  // not 0 where there is no touch
    give[k] = balls.a[k]->rim.w() + balls.b[k]->rim.w();
  }
  Lanes room_at_end, room_at_start;
  const FoundPair* its[kLanes];
  for (std::size_t k = 0; k < kLanes; ++k) its[k] = batch.has(k) ? &found[k] : &kNoPair;
  const LaneVectors way = vectorsOf({its[0]->way, its[1]->way, its[2]->way, its[3]->way}, room_at_end);
  const LaneVectors u = vectorsOf({its[0]->u, its[1]->u, its[2]->u, its[3]->u}, room_at_start);
  batch.tangent = vectorsOf({its[0]->push, its[1]->push, its[2]->push, its[3]->push}, batch.normal);
  const Lanes overlap = -roomOf(room_at_start, reach);
  batch.n = (1.0f / squareRoot(dot(way, way))) * way;
  batch.slip = u - dot(batch.n, u) * batch.n - cross(sum<true>(balls, &Change::before), batch.n);
  batch.target = -(overlap + roomOf(room_at_end, reach)) / h;
  batch.normal_mass = 1.0f / light;
  batch.slip_mass = 1.0f / (light + give);
  takeOut(balls, batch, overlap);
  begin<true>(balls, batch);
}

// A body that moves cannot give way: where it presses a ball on another one, what that iteration leaves would be no room.
void iterateBodies(WorldWithSolver& world, std::uint32_t before, float small)
{
  Pile& pile = world.pile;
  for (int k = 0; k < kMostOfBodies; ++k)
  {
    const std::uint32_t now = ++pile.counter;
    eachShare(world,
              [&](PileShare& share)
              {
                LaneMask changed{};
                for (TouchBatch& batch : share.body_batches) sweep<false>(pile, batch, {before, now, small}, changed);
                if (anyLane(changed)) share.changed = now;
              });
    if (std::none_of(pile.shares.begin(), pile.shares.end(),
                     [&](const PileShare& share) { return share.changed == now; }))
      break;
    before = now;
  }
}
}  // namespace

void startTouches(WorldWithSolver& world, PileShare& share)
{
  for (TouchBatch& batch : share.body_batches) begin<false>(FourBalls(world.pile.changes, batch, false), batch);
  for (std::size_t k = 0; k < share.pair_batches.size(); ++k)
    startPairs(world, share.pair_batches[k], &share.found[kLanes * k]);
}

// Every touch once; then those of balls that changed, forwards and backwards in turn, until nothing changes any more.
void iterate(WorldWithSolver& world)
{
  Pile& pile = world.pile;
  const float least = static_cast<float>(std::min(kGoodEnough * pile.least_impact, kCreep)), small = least * least;
  std::uint32_t before = 0;
  for (int k = 0; k < kMostSweeps; ++k)
  {
    const std::uint32_t now = ++pile.counter;
    inTurns(world,
            [&](PileShare& share)
            {
              if (!quiet(pile, share, before)) sweep(pile, share, {before, now, small}, k % 2 == 0);
            });
    if (std::none_of(pile.shares.begin(), pile.shares.end(),
                     [&](const PileShare& share) { return share.changed == now; }))
      break;
    before = now;
  }
  if (!pile.moving.empty()) iterateBodies(world, before, small);
}
}  // namespace ping_pong
