// The iteration over constraints, four at a time: a batch has no ball twice, so it comes to the same as one after the other.
#include <algorithm>

#include "solver/contact_forces.h"

namespace ping_pong
{
namespace
{
constexpr int kMostIterations = 12;  // with 8 a ball in a tray of 10 000 entered a wall by 1.1 mm, with 12 by 0.7 mm
constexpr int kMostBodyIterations =
    500;  // over constraints with bodies alone, where one moves: between two that are tilted by 1 / 10 against
          // each other an error falls by a hundredth in each
constexpr double kGoodEnough = 0.03;  // change of a velocity that is not passed on, in least impacts,
constexpr double kCreep = 6e-4;       // or less: a heap that creeps faster does not fall asleep [m/s]
const FoundPair kNoPair{{0.0f, 0.0f, 1.0f, 0.0f}, {}, {}};
constexpr float kTiny = 1e-30f;  // where 0 would be divided by

// The balls of a batch.
struct FourBalls
{
  std::array<Change*, kLanes> a, b;

  FourBalls(std::vector<Change>& changes, const ConstraintBatch& batch, bool pairs)
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

// Calls action(lane) for each constraint.
template <class Action>
[[gnu::always_inline]] inline void eachLane(const ConstraintBatch& batch, const Action& action)
{
  if (batch.full())
    for (std::size_t k = 0; k < kLanes; ++k) action(k);
  else
    for (std::size_t k = 0; k < kLanes; ++k)
      if (batch.has(k)) action(k);
}

// Adds `what` to a number of a ball, as many times as the last component of one of its numbers says.
[[gnu::always_inline]] inline void add(Change* ball, Number its, Number factor, Lanes what)
{
  putLanes(of(ball, its) + (ball->*factor).w() * what, (ball->*its).data());
}

// An impulse along n and one across act on the first balls and, where those are pairs, against the second ones.
template <bool pairs>
[[gnu::always_inline]] inline void act(const FourBalls& balls, const ConstraintBatch& batch, Lanes along,
                                       const LaneVectors& across)
{
  const auto impulse = recordsOf(along * batch.n + across), spin_change = recordsOf(cross(across, batch.n));
  eachLane(batch,
           [&](std::size_t k)
           {
             add(balls.a[k], &Change::v, &Change::v, impulse[k]);
             add(balls.a[k], &Change::surface_velocity, &Change::surface_velocity, spin_change[k]);
             if (!pairs) return;
             add(balls.b[k], &Change::v, &Change::v, -impulse[k]);
             add(balls.b[k], &Change::surface_velocity, &Change::surface_velocity, spin_change[k]);
           });
}

// What friction adds, kept within Coulomb's cone.
[[gnu::always_inline]] inline LaneVectors slipImpulse(ConstraintBatch& batch, const LaneVectors& slip)
{
  const LaneVectors before = batch.tangent;
  const LaneVectors wanted = before - batch.slip_mass * slip;
  const Lanes size = squareRoot(greater(dot(wanted, wanted), allLanes(kTiny)));
  batch.tangent = lesser(batch.friction * batch.normal / size, allLanes(1.0f)) * wanted;
  return batch.tangent - before;
}

// One constraint of each lane: its normal impulse never pulls. Tells where a velocity changed by more than the root of `small`.
template <bool pairs>
[[gnu::always_inline]] inline LaneMask solve(std::vector<Change>& changes, ConstraintBatch& batch, float small)
{
  const FourBalls balls(changes, batch, pairs);
  const LaneVectors u = difference<pairs>(balls, &Change::v);
  const Lanes closing = dot(batch.n, u), before = batch.normal;
  batch.normal = greater(before + batch.normal_mass * (batch.target - closing), Lanes{});
  const Lanes impulse = batch.normal - before;
  if (!anyLane((impulse != Lanes{}) | (batch.normal != Lanes{})))
    return LaneMask{};  // where nothing presses, nothing rubs
  const LaneVectors surface_velocities = sum<pairs>(balls, &Change::surface_velocity);
  const LaneVectors across =
      slipImpulse(batch, batch.slip + u - closing * batch.n - cross(surface_velocities, batch.n));
  act<pairs>(balls, batch, impulse, across);
  constexpr float kBoth = pairs ? 4.0f : 1.0f;  // two balls of the same mass share the change
  return impulse * impulse + dot(across, across) > (kBoth * small) * (batch.normal_mass * batch.normal_mass);
}

// An iteration over the constraints of a slab, those left out whose balls have not changed.
struct Iteration
{
  std::uint32_t since;  // on the counter of the solver: changes that constraints do not know
  std::uint32_t now;
  float small;  // square of a change of a velocity that is not passed on [m^2/s^2]
};

// Without a branch for each lane: a processor cannot tell beforehand which of them change.
void mark(std::vector<std::uint32_t>& last_iteration, const std::array<std::uint32_t, kLanes>& slots, LaneMask changed,
          std::uint32_t now)
{
  for (std::size_t k = 0; k < kLanes; ++k)
  {
    std::uint32_t& its = last_iteration[slots[k]];
    its ^= (its ^ now) & static_cast<std::uint32_t>(changed[k]);
  }
}

template <bool pairs>
void iterateOver(ContactSolver& solver, ConstraintBatch& batch, const Iteration& it, LaneMask& any_changed)
{
  bool any = false;
  for (std::size_t k = 0; k < kLanes; ++k)
  {
    any |= solver.last_iteration[batch.a[k]] >= it.since;
    if (pairs) any |= solver.last_iteration[batch.b[k]] >= it.since;
  }
  if (!any) return;
  const LaneMask changed = solve<pairs>(solver.changes, batch, it.small);
  if (!anyLane(changed)) return;
  any_changed |= changed;
  mark(solver.last_iteration, batch.a, changed, it.now);
  if (pairs) mark(solver.last_iteration, batch.b, changed, it.now);
}

void iterateOver(ContactSolver& solver, SolverSlab& slab, const Iteration& it, bool forwards)
{
  LaneMask changed{};
  for (ConstraintBatch& batch : slab.body_batches) iterateOver<false>(solver, batch, it, changed);
  const auto pairs = [&](ConstraintBatch& batch) { iterateOver<true>(solver, batch, it, changed); };
  if (forwards)
    std::for_each(slab.pair_batches.begin(), slab.pair_batches.end(), pairs);
  else
    std::for_each(slab.pair_batches.rbegin(), slab.pair_batches.rend(), pairs);
  if (anyLane(changed)) slab.changed = it.now;
}

// Nobody who writes to a ball of this slab has changed any. (Those who do are not at work at the same time.)
bool quiet(const ContactSolver& solver, const SolverSlab& slab, std::uint32_t since)
{
  const std::size_t s = static_cast<std::size_t>(&slab - solver.slabs.data());
  if (s >= solver.slab_count) return false;
  return slab.changed < since && solver.slabs.back().changed < since &&
         (s == 0 || solver.slabs[s - 1].changed < since) &&
         (s + 1 == solver.slab_count || solver.slabs[s + 1].changed < since);
}

// Distance of spheres that are this far apart or overlap, of the square of the distance of their centres less that of spheres
// that touch.
[[gnu::always_inline]] inline Lanes roomOf(Lanes squares, Lanes reach)
{
  return squares / (squareRoot(greater(squares + reach * reach, Lanes{})) + reach);
}

// Part of an overlap is taken out of the places, by as much of each ball as it is lighter.
[[gnu::always_inline]] inline void correctOverlap(const FourBalls& balls, const ConstraintBatch& batch, Lanes overlap)
{
  const Lanes out = overlapCorrection(overlap);
  if (!anyLane(out > Lanes{})) return;
  const auto shift = recordsOf((out * batch.normal_mass) * batch.n);
  eachLane(batch,
           [&](std::size_t k)
           {
             add(balls.a[k], &Change::p, &Change::v, shift[k]);
             add(balls.b[k], &Change::p, &Change::v, -shift[k]);
           });
}

// The same for all four, unless there are several types of balls.
void putTypes(const WorldWithSolver& world, ConstraintBatch& batch, Lanes& reach)
{
  const ContactSolver& solver = world.solver;
  const auto friction = [&](const BallParams& a, const BallParams& b)
  { return static_cast<float>(world.scene.surfaces.at(a.material, b.material).friction); };
  const BallParams& first = solver.ball_types.front().params;
  reach = allLanes(static_cast<float>(2.0 * first.radius));
  batch.friction = allLanes(friction(first, first));
  if (solver.ball_types.size() == 1) return;
  for (std::size_t k = 0; k < kLanes; ++k)
  {
    reach[k] = static_cast<float>(solver.reach(batch.a[k], batch.b[k]));
    batch.friction[k] = friction(solver.params(batch.a[k]), solver.params(batch.b[k]));
  }
}

// With the impulses of the last step, which lie across the normal of this one.
template <bool pairs>
[[gnu::always_inline]] inline void begin(const FourBalls& balls, ConstraintBatch& batch)
{
  batch.tangent = batch.tangent - dot(batch.n, batch.tangent) * batch.n;
  act<pairs>(balls, batch, batch.normal, batch.tangent);
}

// A constraint may close its gap within the step and no more, and leaves an overlap that was there as it is.
void startPairs(WorldWithSolver& world, ConstraintBatch& batch, const FoundPair* found)
{
  const FourBalls balls(world.solver.changes, batch, true);
  const float h = static_cast<float>(world.solver.h);
  Lanes inverse_mass, inverse_spin_mass, reach;
  putTypes(world, batch, reach);
  for (std::size_t k = 0; k < kLanes; ++k)
  {
    inverse_mass[k] = std::max(balls.a[k]->v.w() + balls.b[k]->v.w(), kTiny);  // not 0 where there is no constraint
    inverse_spin_mass[k] = balls.a[k]->surface_velocity.w() + balls.b[k]->surface_velocity.w();
  }
  Lanes room_at_end, room_at_start;
  const FoundPair* its[kLanes];
  for (std::size_t k = 0; k < kLanes; ++k) its[k] = batch.has(k) ? &found[k] : &kNoPair;
  const LaneVectors way = vectorsOf({its[0]->way, its[1]->way, its[2]->way, its[3]->way}, room_at_end);
  const LaneVectors u = vectorsOf({its[0]->u, its[1]->u, its[2]->u, its[3]->u}, room_at_start);
  batch.tangent = vectorsOf({its[0]->impulse, its[1]->impulse, its[2]->impulse, its[3]->impulse}, batch.normal);
  const Lanes overlap = -roomOf(room_at_start, reach);
  batch.n = (1.0f / squareRoot(dot(way, way))) * way;
  batch.slip = u - dot(batch.n, u) * batch.n - cross(sum<true>(balls, &Change::before), batch.n);
  batch.target = -(overlap + roomOf(room_at_end, reach)) / h;
  batch.normal_mass = 1.0f / inverse_mass;
  batch.slip_mass = 1.0f / (inverse_mass + inverse_spin_mass);
  correctOverlap(balls, batch, overlap);
  begin<true>(balls, batch);
}

// A body that moves cannot give way: where it presses a ball on another one, what that iteration leaves would be no room.
void iterateBodies(WorldWithSolver& world, std::uint32_t before, float small)
{
  ContactSolver& solver = world.solver;
  for (int k = 0; k < kMostBodyIterations; ++k)
  {
    const std::uint32_t now = ++solver.counter;
    eachSlab(world,
             [&](SolverSlab& slab)
             {
               LaneMask changed{};
               for (ConstraintBatch& batch : slab.body_batches)
                 iterateOver<false>(solver, batch, {before, now, small}, changed);
               if (anyLane(changed)) slab.changed = now;
             });
    if (std::none_of(solver.slabs.begin(), solver.slabs.end(),
                     [&](const SolverSlab& slab) { return slab.changed == now; }))
      break;
    before = now;
  }
}
}  // namespace

void startConstraints(WorldWithSolver& world, SolverSlab& slab)
{
  for (ConstraintBatch& batch : slab.body_batches) begin<false>(FourBalls(world.solver.changes, batch, false), batch);
  for (std::size_t k = 0; k < slab.pair_batches.size(); ++k)
    startPairs(world, slab.pair_batches[k], &slab.found[kLanes * k]);
}

// Every constraint once; then those of balls that changed, forwards and backwards in turn, until nothing changes any more.
void iterate(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  const float least = static_cast<float>(std::min(kGoodEnough * solver.least_impact, kCreep)), small = least * least;
  std::uint32_t before = 0;
  for (int k = 0; k < kMostIterations; ++k)
  {
    const std::uint32_t now = ++solver.counter;
    inRedBlackOrder(world,
                    [&](SolverSlab& slab)
                    {
                      if (!quiet(solver, slab, before)) iterateOver(solver, slab, {before, now, small}, k % 2 == 0);
                    });
    if (std::none_of(solver.slabs.begin(), solver.slabs.end(),
                     [&](const SolverSlab& slab) { return slab.changed == now; }))
      break;
    before = now;
  }
  if (!solver.moving.empty()) iterateBodies(world, before, small);
}
}  // namespace ping_pong
