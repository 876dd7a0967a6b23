#include "windows/solver_handover.h"

#include <algorithm>

#include "events/predict.h"
#include "evolve/flight.h"
#include "resting/plan_path.h"
#include "state/hand_off_rule.h"

namespace ping_pong
{
namespace
{
constexpr double kLongestStep = 2e-3;       // above 2.5 ms deep heaps do not fall asleep, see docs/crowds.md [s]
constexpr float kFreeFor = 0.02f;           // without a contact, ten steps: else a ball would go to and fro [s]
constexpr std::uint32_t kReleaseEvery = 8;  // steps: a ball that leaves makes the neighbours of all others void
constexpr double kFreeRoom = 0.25;          // and so much room to other balls, in radii
constexpr double kNear = 5e-4;              // room that is none: overlaps in the solver, and what a step may add [m]

double stepOf(const WorldWithWindows& world)
{
  return std::min(world.scene.dt, kLongestStep);
}

void handOne(WorldWithWindows& world, std::uint32_t i, double t)
{
  BallRecord& ball = world.balls[i];
  ball.path = flyParabola(ball.stateAt(t), t, Vector3d::Zero());
  ball.supports = Supports();
  ball.expectNothing();
  ++ball.version;  // what others predicted with it is void
  ball.frequent_contacts = 0;
  addToSolver(world, i, t);
}

// A cube around the ball, as large as it and others can come nearer in the window.
Box boxAround(const BallRecord& ball, double start, double end)
{
  const double T = end - start;
  const double a = ball.ofSolver() ? 0.0 : ball.path.accelerationBound();
  const Vector3d p = ball.path.position(start - ball.path.start);
  const double speed = ball.path.velocity(start - ball.path.start).norm();
  const double reach = ball.params().radius + T * (speed + 0.5 * T * a) + kNear;
  Box box;
  box.low = p.array() - reach;
  box.high = p.array() + reach;
  return box;
}

// Appends who may come into this box in the window. The grid is as large as the free balls ask for: what is beyond it, it takes
// to be at its border, so that what it lists may be far away.
void listPossiblePartners(const WorldWithWindows& world, const CoarseBox& box, double start, double end,
                          std::vector<std::uint32_t>& list)
{
  const std::size_t before = list.size();
  world.islands.broad_phase.listOverlapping(box, list);
  const auto apart = [&](std::uint32_t k) { return !box.overlaps(CoarseBox(boxAround(world.balls[k], start, end))); };
  list.erase(std::remove_if(list.begin() + static_cast<std::ptrdiff_t>(before), list.end(), apart), list.end());
}

// Hands over all that are near, and those near them, and so on.
void spread(WorldWithWindows& world, double start, double end)
{
  IslandRecords& islands = world.islands;
  for (std::size_t first = 0; first < islands.near.size(); ++first)
  {
    islands.found.clear();
    listPossiblePartners(world, islands.near_boxes[first], start, end, islands.found);
    std::sort(islands.found.begin(), islands.found.end());
    for (const std::uint32_t k : islands.found)
    {
      if (world.balls[k].away()) continue;
      islands.near.push_back(k);
      islands.near_boxes.emplace_back(boxAround(world.balls[k], start, end));
      handOne(world, k, start);
    }
  }
}

// Whether no other ball is near, by the pairs of the solver.
bool roomAround(const ContactSolver& solver, std::uint32_t slot)
{
  if (solver.neighbours_void) return false;
  return !solver.anyPair(slot,
                         [&](std::uint32_t l)
                         {
                           const NeighbourPair& pair = solver.pairs[l];
                           const double room = (solver.movers[pair.a].p - solver.movers[pair.b].p).norm() -
                                               solver.radius(pair.a) - solver.radius(pair.b);
                           return room < kFreeRoom * solver.radius(slot);
                         });
}

void releaseFree(WorldWithWindows& world, double t, double smooth_until)
{
  const ContactSolver& solver = world.solver;
  if (solver.steps % kReleaseEvery != 0 || solver.neighbours_void) return;
  std::vector<std::uint32_t>& free = world.islands.near;
  free.clear();
  for (const SolverSlab& slab : solver.slabs)
    for (const std::uint32_t slot : slab.awake)
      if (solver.since_contact[slot] > kFreeFor && roomAround(solver, slot)) free.push_back(solver.ball[slot]);
  for (const std::uint32_t ball : free) takeFromSolver(world, ball, t, smooth_until);
}
}  // namespace

std::size_t mostEvents(const WorldWithWindows& world, const std::vector<std::size_t>& balls)
{
  for (const std::size_t i : balls)
    if (world.surface(world.balls[i], world.balls[i]).restitution == 1.0) return ~std::size_t{0};
  return static_cast<std::size_t>(kHandOffContacts) * balls.size();
}

void handToSolver(WorldWithWindows& world, const std::vector<std::uint32_t>& balls, double t)
{
  for (const std::uint32_t i : balls)
    if (!world.balls[i].away()) handOne(world, i, t);
}

double endOfWindow(const WorldWithWindows& world, double start, double end)
{
  const ContactSolver& solver = world.solver;
  if (solver.ball.empty() || !solver.anyAwake()) return end;
  const double step = stepOf(world);
  return start + 1.5 * step < end ? start + step : end;
}

void handNeighboursToSolver(WorldWithWindows& world, double start, double end)
{
  if (world.solver.ball.size() == world.balls.size()) return;
  IslandRecords& islands = world.islands;
  const auto boxOfFree = [&](std::size_t i)
  { return world.balls[i].away() ? Box() : boxAround(world.balls[i], start, end); };
  islands.broad_phase.build(world.balls.size(), boxOfFree, world.workers);
  islands.near.clear();
  for (const std::uint32_t in_solver : world.solver.ball)
    listPossiblePartners(world, CoarseBox(boxAround(world.balls[in_solver], start, end)), start, end, islands.near);
  const auto away = [&](std::uint32_t i) { return world.balls[i].away(); };
  islands.near.erase(std::remove_if(islands.near.begin(), islands.near.end(), away), islands.near.end());
  std::sort(islands.near.begin(), islands.near.end());
  islands.near.erase(std::unique(islands.near.begin(), islands.near.end()), islands.near.end());
  islands.near_boxes.clear();
  for (const std::uint32_t other : islands.near)
    islands.near_boxes.emplace_back(boxAround(world.balls[other], start, end));
  for (const std::uint32_t other : islands.near) handOne(world, other, start);
  spread(world, start, end);
}

void moveSolver(WorldWithWindows& world, double start, double end, double smooth_until)
{
  if (!world.solver.ball.empty())
  {
    stepSolver(world, start, end, stepOf(world));
    releaseFree(world, end, smooth_until);
  }
  if (!world.frequent_contacts) return;
  world.frequent_contacts = false;
  for (std::uint32_t i = 0; i < world.balls.size(); ++i)
    if (world.balls[i].frequent_contacts > kHandOffContacts && !world.balls[i].away()) handOne(world, i, end);
}

void takeFromSolver(WorldWithWindows& world, std::uint32_t i, double t, double smooth_until)
{
  BallRecord& ball = world.balls[i];
  const BallState state = ball.stateAt(t);
  dropFromSolver(world.solver, i);
  ball.owner = BallOwner::Method;
  planPath(world, ball, state, t, smooth_until);
  predictStill(world, i, t);
  if (world.any_moving) predictMoving(world, i, t, smooth_until);
}
}  // namespace ping_pong
