// Who sleeps is not computed: balls fall asleep one by one, and wake up one by one, as far as a disturbance reaches.
#include "solver/slabs.h"

namespace ping_pong
{
namespace
{
constexpr float kStillFor = 0.25f;    // a ball that has not left its place for so long may fall asleep [s],
constexpr double kStillSpeed = 5e-3;  // and neither moves nor turns at its surface faster than this [m/s]
constexpr std::uint32_t kEvery = 16;  // steps: a search through all constraints, for balls that are still for hundreds
constexpr double kNear = 1e-3;        // more than what heaps overlap by: no ball that lay on one is forgotten [m]

bool still(const ContactSolver& solver, std::size_t i)
{
  const Mover& mover = solver.movers[i];
  return solver.still[i] > kStillFor && !mover.kept_awake && mover.v.squaredNorm() < kStillSpeed * kStillSpeed &&
         solver.w[i].norm() * solver.radius(i) < kStillSpeed;
}

void sleep(WorldWithSolver& world, std::size_t i)
{
  ContactSolver& solver = world.solver;
  Mover& mover = solver.movers[i];
  mover.asleep = mover.carried = mover.too_slow_for_impacts = true;
  mover.v.setZero();
  solver.w[i].setZero();
  solver.changes[i] = Change();
  solver.voidActive(i);
  BallRecord& ball = world.balls[solver.ball[i]];
  ball.owner = BallOwner::SolverAsleep;
  ball.supports.setSince(solver.start + solver.h - static_cast<double>(solver.still[i]));
  storeBall(world, i, solver.start + solver.h);
}

// A neighbour that is not still yet keeps a ball awake.
void keepAwake(ContactSolver& solver)
{
  for (SolverSlab& slab : solver.slabs)
    for (const std::uint32_t i : slab.awake) solver.movers[i].kept_awake = false;
  for (const SolverSlab& slab : solver.slabs)
    for (const ConstraintBatch& batch : slab.pair_batches)
      for (std::size_t k = 0; k < kLanes; ++k)
      {
        if (solver.movers[batch.a[k]].asleep || solver.movers[batch.b[k]].asleep) continue;
        const bool a = solver.still[batch.a[k]] > kStillFor, b = solver.still[batch.b[k]] > kStillFor;
        if (a != b) solver.movers[a ? batch.a[k] : batch.b[k]].kept_awake = true;
      }
}
}  // namespace

void ContactSolver::wake(std::size_t i)
{
  Mover& mover = movers[i];
  if (!mover.asleep) return;
  mover.asleep = false;
  mover.carried = mover.was_carried = true;
  still[i] = 0.0f;
  voidActive(i);
}

void wakeNear(ContactSolver& solver, const Vector3d& p_WB, double radius)
{
  for (std::size_t i = 0; i < solver.movers.size(); ++i)
    if ((solver.movers[i].p - p_WB).norm() < radius + solver.radius(i) + kNear) solver.wake(i);
}

void updateSleep(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  for (const SolverSlab& slab : solver.slabs)
    for (const std::uint32_t i : slab.waking) solver.wake(i);
  if (++solver.steps % kEvery != 0) return;
  keepAwake(solver);
  for (const SolverSlab& slab : solver.slabs)
    for (const std::uint32_t i : slab.awake)
      if (still(solver, i)) sleep(world, i);
}
}  // namespace ping_pong
