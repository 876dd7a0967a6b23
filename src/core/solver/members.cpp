// The way of balls into the solver, and back into the records of the world.
#include <algorithm>

#include "solver/slabs.h"

namespace ping_pong
{
namespace
{
constexpr std::size_t kPairs = 8;        // room for so many pairs a ball from the start,
constexpr std::size_t kConstraints = 4;  // so many in contact,
constexpr std::size_t kBodies = 2;       // so many with bodies,
constexpr std::size_t kMore = 64;        // and these for few balls among much furniture
constexpr std::size_t kTypes = 8;        // of balls

bool same(const BallParams& a, const BallParams& b)
{
  return a.radius == b.radius && a.mass == b.mass && a.inertia == b.inertia && a.material == b.material;
}

std::uint16_t typeOf(ContactSolver& solver, const BallRecord& ball)
{
  for (std::size_t k = 0; k < solver.ball_types.size(); ++k)
    if (same(solver.ball_types[k].params, ball.params())) return static_cast<std::uint16_t>(k);
  SolverBallType type{ball.params(), ball.model()};
  if (ball.model().constant()) type.a = ball.model().acceleration(Vector3d::Zero(), Vector3d::Zero());
  type.spin_per_impulse = 1.0 / (ball.params().inertia * ball.params().radius);
  type.inverse_mass = 1.0 / ball.params().mass;
  type.slip_per_impulse = 1.0 + 1.0 / ball.params().inertia;
  solver.ball_types.push_back(type);
  return static_cast<std::uint16_t>(solver.ball_types.size() - 1);
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
  ContactSolver& solver = world.solver;
  const BallRecord& ball = world.balls[solver.ball[slot]];
  const BallState state = ball.stateAt(time);
  Mover mover;
  mover.type = typeOf(solver, ball);
  mover.v = state.v_WB;
  mover.asleep = mover.carried = mover.was_carried = ball.asleep();
  mover.p = solver.home[slot] = state.p_WB;
  solver.movers[slot] = mover;
  solver.w[slot] = state.w_WB;
  solver.changes[slot] = Change();
  solver.q[slot] = state.q_WB;
  solver.pending_rotation[slot].setZero();
  solver.still[slot] = solver.since_contact[slot] = 0.0f;
  solver.last_hits[slot] = BodyHit();
  solver.neighbours_void = true;
}
}  // namespace

std::uint32_t slotOf(const ContactSolver& solver, std::uint32_t ball)
{
  return static_cast<std::uint32_t>(std::find(solver.ball.begin(), solver.ball.end(), ball) - solver.ball.begin());
}

void clearSolver(ContactSolver& solver)
{
  eachSlotList(solver, [](auto& list) { list.clear(); });
  solver.ball_types.clear();
  solver.pairs.clear();
  solver.old_kept.clear();
  solver.bodies.clear();
  solver.moving.clear();
  solver.squeezed.clear();
  for (SolverSlab& slab : solver.slabs) clearSlab(slab);
  solver.counter = 1;
  solver.steps = 0;
  solver.h = 0.0;
  solver.neighbours_void = true;
}

namespace
{
void reserveSlab(SolverSlab& slab, std::size_t balls)
{
  for (std::vector<std::uint32_t>* list : {&slab.balls, &slab.awake, &slab.leaving, &slab.waking}) list->reserve(balls);
  for (std::vector<std::uint32_t>* list : {&slab.pairs, &slab.active_pairs}) list->reserve(kPairs * balls);
  for (std::vector<std::uint32_t>* list : {&slab.bodies, &slab.active_bodies}) list->reserve(kBodies * balls);
  slab.body_constraints.reserve(kBodies * balls);
  slab.body_batches.reserve(kBodies * balls / kLanes + kMore);
  slab.pair_batches.reserve(kConstraints * balls / kLanes + kMore);
  slab.found.reserve(kConstraints * balls + kLanes * kMore);
  slab.pair_of.reserve(kConstraints * balls + kLanes * kMore);
  slab.ahead.reserve(balls);
}
}  // namespace

void reserveSolver(WorldWithSolver& world, std::size_t balls)
{
  ContactSolver& solver = world.solver;
  eachSlotList(solver, world.scene.forces.dependOnVelocity(), [balls](auto& list) { list.reserve(balls); });
  solver.ball_types.reserve(kTypes);
  solver.pairs.reserve(kPairs * balls);
  solver.impulses.reserve(kPairs * balls);
  solver.force_at_sleep.reserve(kPairs * balls);
  for (std::vector<NeighbourPair>& found : solver.found)
    found.reserve(kMore + kPairs * balls / (ContactSolver::kMostSlabs / 2));
  for (std::vector<BodyNeighbour>* neighbours : {&solver.bodies, &solver.old_bodies, &solver.moving})
    neighbours->reserve(kBodies * balls + kMore);
  for (std::vector<std::uint32_t>* list : {&solver.old_slot, &solver.new_slot}) list->reserve(balls);
  solver.slab_of.reserve(balls);
  for (SolverSlab& slab : solver.slabs) reserveSlab(slab, kMore + balls / (ContactSolver::kMostSlabs / 2));
  solver.old_kept.reserve(kConstraints * balls);
  solver.squeezed.reserve(kBodies * balls + kMore);
  solver.first_pair.reserve(balls);
  solver.first_body.reserve(balls);
  solver.ahead.reserve(kConstraints * balls + kMore);
  solver.grid.start.reserve(2 * balls + 3);
  solver.grid.cell.reserve(balls);
  solver.grid.entries.reserve(balls);
  solver.grid.large.reserve(balls);
  solver.grid.strays.reserve(balls);
}

void addToSolver(WorldWithSolver& world, std::uint32_t ball, double time)
{
  ContactSolver& solver = world.solver;
  eachSlotList(solver, !world.balls[ball].model().constant(), [](auto& list) { makeBlank(list.emplace_back()); });
  solver.ball.back() = ball;
  world.balls[ball].owner = BallOwner::Solver;
  take(world, solver.ball.size() - 1, time);
}

void dropFromSolver(ContactSolver& solver, std::uint32_t ball)
{
  const std::uint32_t slot = slotOf(solver, ball);
  if (slot == solver.ball.size()) return;
  wakeNear(solver, solver.movers[slot].p, solver.radius(slot));
  eachSlotList(solver, [slot](auto& list) { list.erase(list.begin() + slot); });
  saveImpulses(solver);
  const auto forget = [](auto& neighbours, const auto& its)
  { neighbours.erase(std::remove_if(neighbours.begin(), neighbours.end(), its), neighbours.end()); };
  forget(solver.old_kept, [slot](const KeptPair& kept) { return kept.a == slot || kept.b == slot; });
  forget(solver.bodies, [slot](const BodyNeighbour& neighbour) { return neighbour.ball == slot; });
  for (KeptPair& kept : solver.old_kept) kept.a -= kept.a > slot, kept.b -= kept.b > slot;
  for (BodyNeighbour& neighbour : solver.bodies) neighbour.ball -= neighbour.ball > slot;
  solver.neighbours_void = true;
}

void removeFromSolver(ContactSolver& solver, std::uint32_t ball)
{
  dropFromSolver(solver, ball);
  for (std::uint32_t& other : solver.ball) other -= other > ball;
}

void disturbSolver(WorldWithSolver& world)
{
  for (std::size_t slot = 0; slot < world.solver.ball.size(); ++slot)
  {
    world.balls[world.solver.ball[slot]].wake();
    take(world, slot, world.time);
  }
}

void restateInSolver(WorldWithSolver& world, std::uint32_t ball)
{
  const std::uint32_t slot = slotOf(world.solver, ball);
  world.balls[world.solver.ball[slot]].wake();
  wakeNear(world.solver, world.solver.movers[slot].p, world.solver.radius(slot));
  take(world, slot, world.time);
  wakeNear(world.solver, world.solver.movers[slot].p, world.solver.radius(slot));
}

void storeBall(WorldWithSolver& world, std::size_t slot, double time)
{
  ContactSolver& solver = world.solver;
  applyRotation(solver, slot);
  Segment& path = world.balls[solver.ball[slot]].path;
  path.start = time;
  path.c[0] = solver.movers[slot].p;
  path.c[1] = solver.movers[slot].v;
  path.w_WB = solver.w[slot];
  path.q_WB = solver.q[slot];
}
}  // namespace ping_pong
