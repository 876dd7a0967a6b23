#include "methods/exact.h"

#include "events/event_loop.h"
#include "events/predict.h"
#include "resting/plan_path.h"
#include "windows/solver_handover.h"
#include "windows/time_windows.h"

namespace ping_pong
{
namespace
{
bool liesOnMovedBody(const WorldWithWindows& world, const BallRecord& ball)
{
  for (std::size_t k = 0; k < ball.supports.count(); ++k)
  {
    const BodyRecord& body = world.bodies[ball.supports[k].body];
    if (body.moving || body.moved) return true;
  }
  return false;
}

// Paddles move differently from now on: what was predicted with them is void.
void startWindow(WorldWithWindows& world, double end)
{
  bool stopped = false;
  bool moving = false;
  for (const BodyRecord& body : world.bodies)
  {
    stopped |= body.moved && !body.moving;
    moving |= body.moving;
  }
  if (!moving && !stopped && !world.any_moving) return;
  world.any_moving = moving;
  ++world.edits;
  for (std::size_t i = 0; i < world.balls.size(); ++i)
  {
    BallRecord& ball = world.balls[i];
    if (ball.away()) continue;
    if (liesOnMovedBody(world, ball))
    {
      planPath(world, ball, ball.stateAt(world.time), world.time, end);
      predictStill(world, i, world.time);
    }
    else if (stopped)
      predictStill(world, i, world.time);
    if (moving || ball.meetsMoving() < kNever) predictMoving(world, i, world.time, end);
  }
}

void restartBall(WorldWithWindows& world, std::size_t i)
{
  BallRecord& ball = world.balls[i];
  ++world.edits;
  if (ball.away()) return;
  planPath(world, ball, ball.stateAt(world.time), world.time, world.time);
  predictStill(world, i, world.time);
  if (ball.transient) ball.transient->moving = Event();
}

}  // namespace

void reserveExact(WorldWithWindows& world, std::size_t balls)
{
  if (balls < 2) return;
  world.islands.reserve(balls, world.workers.count());
  reserveSolver(world, balls);
}

void startExact(WorldWithWindows& world)
{
  for (std::size_t i = 0; i < world.balls.size(); ++i) restartBall(world, i);
  disturbSolver(world);
}

void exactBallChanged(WorldWithWindows& world, std::size_t i)
{
  BallRecord& ball = world.balls[i];
  if (ball.ofSolver()) dropFromSolver(world.solver, static_cast<std::uint32_t>(i));
  ball.owner = BallOwner::Method;
  restartBall(world, i);
}

void runExact(WorldWithWindows& world, double end)
{
  startWindow(world, end);
  if (world.balls.size() == 1)
  {
    const std::size_t only = 0;
    if (!world.solver.ball.empty()) takeFromSolver(world, 0, world.time, end);
    runTogether(world, {world.time, end, end, &only, 1, &world});
  }
  else if (!world.balls.empty())
    runIslands(world, end);
}
}  // namespace ping_pong
