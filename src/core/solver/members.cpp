// The way of balls into the pile, and back into the records of the world.
#include <algorithm>

#include "solver/slabs.h"

namespace ping_pong
{
namespace
{
constexpr std::size_t kPairs = 8;    // room for so many links of balls a ball from the start,
constexpr std::size_t kTouches = 4;  // so many in touch,
constexpr std::size_t kBodies = 2;   // so many with bodies,
constexpr std::size_t kMore = 64;    // and these for few balls among much furniture
constexpr std::size_t kKinds = 8;    // of balls

bool same(const BallParams& a, const BallParams& b)
{
  return a.radius == b.radius && a.mass == b.mass && a.inertia == b.inertia && a.material == b.material;
}

std::uint16_t kindOf(Pile& pile, const BallRecord& ball)
{
  for (std::size_t k = 0; k < pile.kinds.size(); ++k)
    if (same(pile.kinds[k].params, ball.params())) return static_cast<std::uint16_t>(k);
  BallKind kind{ball.params(), ball.model()};
  if (ball.model().constant()) kind.a = ball.model().acceleration(Vector3d::Zero(), Vector3d::Zero());
  kind.spin_per_impulse = 1.0 / (ball.params().inertia * ball.params().radius);
  kind.inverse_mass = 1.0 / ball.params().mass;
  kind.give = 1.0 + 1.0 / ball.params().inertia;
  pile.kinds.push_back(kind);
  return static_cast<std::uint16_t>(pile.kinds.size() - 1);
}

// What is new is as its type says, but Eigen leaves its own as they are found in memory.
template <typename Entry>
void makeBlank(Entry&)
{
}
template <typename Number, int rows>
void makeBlank(Eigen::Matrix<Number, rows, 1>& entry)
{
  entry.setZero();
}
void makeBlank(Quaterniond& entry)
{
  entry.setIdentity();
}

void take(WorldWithSolver& world, std::size_t slot, double time)
{
  Pile& pile = world.pile;
  const BallRecord& ball = world.balls[pile.ball[slot]];
  const BallState state = ball.stateAt(time);
  Mover mover;
  mover.kind = kindOf(pile, ball);
  mover.v = state.v_WB;
  mover.asleep = mover.loaded = mover.was_loaded = ball.asleep();
  mover.p = pile.home[slot] = state.p_WB;
  pile.movers[slot] = mover;
  pile.w[slot] = state.w_WB;
  pile.changes[slot] = Change();
  pile.q[slot] = state.q_WB;
  pile.turn[slot].setZero();
  pile.still[slot] = pile.untouched[slot] = 0.0f;
  pile.throws[slot] = Throw();
  pile.links_void = true;
}
}  // namespace

std::uint32_t slotOf(const Pile& pile, std::uint32_t ball)
{
  return static_cast<std::uint32_t>(std::find(pile.ball.begin(), pile.ball.end(), ball) - pile.ball.begin());
}

void clearPile(Pile& pile)
{
  eachSlotList(pile, [](auto& list) { list.clear(); });
  pile.kinds.clear();
  pile.pairs.clear();
  pile.old_kept.clear();
  pile.bodies.clear();
  pile.moving.clear();
  pile.squeezed.clear();
  for (PileShare& share : pile.shares) clearShare(share);
  pile.counter = 1;
  pile.steps = 0;
  pile.h = 0.0;
  pile.links_void = true;
}

namespace
{
void reserveShare(PileShare& share, std::size_t balls)
{
  for (std::vector<std::uint32_t>* list : {&share.balls, &share.awake, &share.leaving, &share.waking})
    list->reserve(balls);
  for (std::vector<std::uint32_t>* list : {&share.pairs, &share.active_pairs}) list->reserve(kPairs * balls);
  for (std::vector<std::uint32_t>* list : {&share.bodies, &share.active_bodies}) list->reserve(kBodies * balls);
  share.body_touches.reserve(kBodies * balls);
  share.body_batches.reserve(kBodies * balls / kLanes + kMore);
  share.pair_batches.reserve(kTouches * balls / kLanes + kMore);
  share.found.reserve(kTouches * balls + kLanes * kMore);
  share.pair_links.reserve(kTouches * balls + kLanes * kMore);
  share.ahead.reserve(balls);
}
}  // namespace

void reservePile(WorldWithSolver& world, std::size_t balls)
{
  Pile& pile = world.pile;
  eachSlotList(pile, world.scene.forces.dependOnVelocity(), [balls](auto& list) { list.reserve(balls); });
  pile.kinds.reserve(kKinds);
  pile.pairs.reserve(kPairs * balls);
  pile.pushes.reserve(kPairs * balls);
  pile.held.reserve(kPairs * balls);
  for (std::vector<PairLink>& found : pile.found) found.reserve(kMore + kPairs * balls / (Pile::kMostSlabs / 2));
  for (std::vector<BodyLink>* links : {&pile.bodies, &pile.old_bodies, &pile.moving})
    links->reserve(kBodies * balls + kMore);
  for (std::vector<std::uint32_t>* list : {&pile.old_slot, &pile.new_slot}) list->reserve(balls);
  pile.share_of.reserve(balls);
  for (PileShare& share : pile.shares) reserveShare(share, kMore + balls / (Pile::kMostSlabs / 2));
  pile.old_kept.reserve(kTouches * balls);
  pile.squeezed.reserve(kBodies * balls + kMore);
  pile.first_link.reserve(balls);
  pile.first_body.reserve(balls);
  pile.ahead.reserve(kTouches * balls + kMore);
  pile.grid.start.reserve(2 * balls + 3);
  pile.grid.cell.reserve(balls);
  pile.grid.entries.reserve(balls);
  pile.grid.large.reserve(balls);
  pile.grid.strays.reserve(balls);
}

void addToPile(WorldWithSolver& world, std::uint32_t ball, double time)
{
  Pile& pile = world.pile;
  eachSlotList(pile, !world.balls[ball].model().constant(), [](auto& list) { makeBlank(list.emplace_back()); });
  pile.ball.back() = ball;
  world.balls[ball].owner = BallOwner::Solver;
  take(world, pile.ball.size() - 1, time);
}

void dropFromPile(Pile& pile, std::uint32_t ball)
{
  const std::uint32_t slot = slotOf(pile, ball);
  if (slot == pile.ball.size()) return;
  wakeNear(pile, pile.movers[slot].p, pile.radius(slot));
  eachSlotList(pile, [slot](auto& list) { list.erase(list.begin() + slot); });
  detachKept(pile);
  const auto forget = [](auto& links, const auto& its)
  { links.erase(std::remove_if(links.begin(), links.end(), its), links.end()); };
  forget(pile.old_kept, [slot](const KeptPair& kept) { return kept.a == slot || kept.b == slot; });
  forget(pile.bodies, [slot](const BodyLink& link) { return link.ball == slot; });
  for (KeptPair& kept : pile.old_kept) kept.a -= kept.a > slot, kept.b -= kept.b > slot;
  for (BodyLink& link : pile.bodies) link.ball -= link.ball > slot;
  pile.links_void = true;
}

void removeFromPile(Pile& pile, std::uint32_t ball)
{
  dropFromPile(pile, ball);
  for (std::uint32_t& other : pile.ball) other -= other > ball;
}

void disturbPile(WorldWithSolver& world)
{
  for (std::size_t slot = 0; slot < world.pile.ball.size(); ++slot)
  {
    world.balls[world.pile.ball[slot]].wake();
    take(world, slot, world.time);
  }
}

void restatePile(WorldWithSolver& world, std::uint32_t ball)
{
  const std::uint32_t slot = slotOf(world.pile, ball);
  world.balls[world.pile.ball[slot]].wake();
  wakeNear(world.pile, world.pile.movers[slot].p, world.pile.radius(slot));
  take(world, slot, world.time);
  wakeNear(world.pile, world.pile.movers[slot].p, world.pile.radius(slot));
}

void storeBall(WorldWithSolver& world, std::size_t slot, double time)
{
  Pile& pile = world.pile;
  takeTurn(pile, slot);
  Segment& path = world.balls[pile.ball[slot]].path;
  path.start = time;
  path.c[0] = pile.movers[slot].p;
  path.c[1] = pile.movers[slot].v;
  path.w_WB = pile.w[slot];
  path.q_WB = pile.q[slot];
}
}  // namespace ping_pong
