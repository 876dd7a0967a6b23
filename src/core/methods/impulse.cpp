#include "methods/impulse.h"

namespace ping_pong
{
void reserveImpulse(WorldWithWindows& world, std::size_t balls)
{
  reserveSolver(world, balls);
}

void startImpulse(WorldWithWindows& world)
{
  if (!world.solver.ball.empty()) return disturbSolver(world);
  for (std::uint32_t i = 0; i < world.balls.size(); ++i)
    if (!world.balls[i].squeezed()) addToSolver(world, i, world.time);
}

void impulseBallChanged(WorldWithWindows& world, std::size_t ball)
{
  const auto i = static_cast<std::uint32_t>(ball);
  if (slotOf(world.solver, i) == world.solver.ball.size())
    addToSolver(world, i, world.time);
  else
    restateInSolver(world, i);
}

void runImpulse(WorldWithWindows& world, double end)
{
  stepSolver(world, world.time, end, world.scene.dt);
}
}  // namespace ping_pong
