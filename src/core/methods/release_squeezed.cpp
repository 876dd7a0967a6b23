#include "methods/release_squeezed.h"

#include "events/predict.h"
#include "resting/plan_path.h"
#include "state/free_space.h"

namespace ping_pong
{
void releaseSqueezed(WorldWithWindows& world)
{
  if (!world.any_squeezed) return;
  world.any_squeezed = false;
  ++world.edits;
  for (std::size_t i = 0; i < world.balls.size(); ++i)
  {
    BallRecord& ball = world.balls[i];
    if (!ball.squeezed()) continue;
    const BallState state = ball.stateAt(world.time);
    const double radius = ball.params().radius;
    const bool has_room =
        ball.ofSolver() ? hasRoomInSolver(world, state.p_WB, radius, i) : hasRoom(world, state.p_WB, radius, i);
    world.any_squeezed |= !has_room;
    if (!has_room) continue;
    if (ball.ofSolver())
    {
      addToSolver(world, static_cast<std::uint32_t>(i), world.time);
      continue;
    }
    ball.owner = BallOwner::Method;
    planPath(world, ball, state, world.time, world.time);
    predictStill(world, i, world.time);
  }
}
}  // namespace ping_pong
