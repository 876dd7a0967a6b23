#include <algorithm>
#include <cmath>

#include "situations.h"

namespace ping_pong::stability
{
namespace
{
constexpr double kDistance = 0.3;  // of the nearest start above the plate [m]

// How far a contact moved the ball against its flight, at worst: below zero, it was pushed on.
double greatestPush(World& world, double dt, int steps)
{
  double push = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const BallState before = world.ballState(0);
    world.advance(dt);
    push = std::min(push, (positionOf(world) - before.p_WB - dt * before.v_WB).z());
  }
  return push;
}
}  // namespace

World shotAtPlate(Method method, double dt, double thickness, double speed, double phase, double restitution)
{
  return SceneBuilder(method, dt)
      .restitution(restitution)
      .box("plate", {4, 4, thickness}, at({0, 0, 0}))
      .ball({0, 0, kDistance + phase * speed * dt}, {0, 0, -speed})
      .world();
}

Shots shootAtPlate(Method method, double dt, double thickness, double speed, int count)
{
  Shots parts;
  const int steps = static_cast<int>(std::ceil(2.0 * kDistance / (speed * dt))) + 2;
  for (int i = 0; i < count; ++i)
  {
    World world = shotAtPlate(method, dt, thickness, speed, (i + 0.5) / count);
    const bool pushed = greatestPush(world, dt, steps) < -1e-9;
    if (positionOf(world).z() >= 0.0) continue;
    (pushed ? parts.wrong_side : parts.missed) += 1.0 / count;
  }
  return parts;
}
}  // namespace ping_pong::stability
