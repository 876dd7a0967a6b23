// Who sleeps is not computed: balls fall asleep one by one, and wake up one by one, as far as a disturbance reaches.
#include "solver/slabs.h"

namespace ping_pong
{
namespace
{
constexpr float kStillFor = 0.25f;    // a ball that has not left its place for so long may fall asleep [s],
constexpr double kStillSpeed = 5e-3;  // and neither moves nor spins at its rim faster than this [m/s]
constexpr std::uint32_t kEvery = 16;  // steps
constexpr double kNear = 1e-3;        // [m]

bool still(const Pile& pile, std::size_t i)
{
  const Mover& mover = pile.movers[i];
  return pile.still[i] > kStillFor && !mover.kept_awake && mover.v.squaredNorm() < kStillSpeed * kStillSpeed &&
         pile.w[i].norm() * pile.radius(i) < kStillSpeed;
}

void sleep(WorldWithSolver& world, std::size_t i)
{
  Pile& pile = world.pile;
  Mover& mover = pile.movers[i];
  mover.asleep = mover.loaded = mover.calm = true;
  mover.v.setZero();
  pile.w[i].setZero();
  pile.changes[i] = Change();
  pile.voidActive(i);
  BallRecord& ball = world.balls[pile.ball[i]];
  ball.owner = BallOwner::SolverAsleep;
  ball.supports.setSince(pile.start + pile.h - static_cast<double>(pile.still[i]));
  storeBall(world, i, pile.start + pile.h);
}

// A neighbour that is not still yet keeps a ball awake.
void keepAwake(Pile& pile)
{
  for (PileShare& share : pile.shares)
    for (const std::uint32_t i : share.awake) pile.movers[i].kept_awake = false;
  for (const PileShare& share : pile.shares)
    for (const TouchBatch& batch : share.pair_batches)
      for (std::size_t k = 0; k < kLanes; ++k)
      {
        if (pile.movers[batch.a[k]].asleep || pile.movers[batch.b[k]].asleep) continue;
        const bool a = pile.still[batch.a[k]] > kStillFor, b = pile.still[batch.b[k]] > kStillFor;
        if (a != b) pile.movers[a ? batch.a[k] : batch.b[k]].kept_awake = true;
      }
}
}  // namespace

void Pile::wake(std::size_t i)
{
  Mover& mover = movers[i];
  if (!mover.asleep) return;
  mover.asleep = false;
  mover.loaded = mover.was_loaded = true;
  still[i] = 0.0f;
  voidActive(i);
}

void wakeNear(Pile& pile, const Vector3d& p_WB, double radius)
{
  for (std::size_t i = 0; i < pile.movers.size(); ++i)
    if ((pile.movers[i].p - p_WB).norm() < radius + pile.radius(i) + kNear) pile.wake(i);
}

void settlePile(WorldWithSolver& world)
{
  Pile& pile = world.pile;
  for (const PileShare& share : pile.shares)
    for (const std::uint32_t i : share.waking) pile.wake(i);
  if (++pile.steps % kEvery != 0) return;
  keepAwake(pile);
  for (const PileShare& share : pile.shares)
    for (const std::uint32_t i : share.awake)
      if (still(pile, i)) sleep(world, i);
}
}  // namespace ping_pong
