#include "methods/impulse.h"

namespace ping_pong
{
void reserveImpulse(WorldWithWindows& world, std::size_t balls)
{
  reservePile(world, balls);
}

void startImpulse(WorldWithWindows& world)
{
  if (!world.pile.ball.empty()) return disturbPile(world);
  for (std::uint32_t i = 0; i < world.balls.size(); ++i)
    if (!world.balls[i].squeezed()) addToPile(world, i, world.time);
}

void impulseBallChanged(WorldWithWindows& world, std::size_t ball)
{
  const auto i = static_cast<std::uint32_t>(ball);
  if (slotOf(world.pile, i) == world.pile.ball.size())
    addToPile(world, i, world.time);
  else
    restatePile(world, i);
}

void runImpulse(WorldWithWindows& world, double end)
{
  runPile(world, world.time, end, world.scene.dt);
}
}  // namespace ping_pong
