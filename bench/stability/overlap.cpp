#include <algorithm>
#include <cmath>
#include <limits>

#include "situations.h"

namespace ping_pong::stability
{
namespace
{
SceneBuilder onATable(Method method, double dt, double restitution)
{
  SceneBuilder builder(method, dt);
  builder.gravity(kG).restitution(restitution).box("table", {2, 2, 0.1}, at({0, 0, -0.05}));
  return builder;
}

// A paddle comes down from 60 mm above the table to 28 mm, and waits there for 0.1 s.
double pressedDepth(Method method, double dt, double restitution, double u)
{
  constexpr double kHalf = 0.005, kHigh = 0.060 + kHalf, kLow = 0.028 + kHalf;  // of the paddle [m]
  SceneBuilder builder = onATable(method, dt, restitution);
  World world = builder.paddle("paddle", boxShape({0.2, 0.2, 2.0 * kHalf}), at({0, 0, kHigh})).ball({0, 0, kR}).world();
  world.command(1, velocityCommand({0, 0, -u}));
  double depth = 0.0;
  for (double t = 0.0; t < (kHigh - kLow) / u + 0.1; t += dt)
  {
    if (world.bodyPose(1).p.z() - 1.001 * u * dt < kLow) world.command(1, PaddleCommand());
    const StepStatus status = world.advance(dt);
    depth = std::max(depth, kR - positionOf(world).z());
    const bool on_top = positionOf(world).z() > world.bodyPose(1).p.z();
    if (status.not_finite || status.event_limit || on_top) return std::numeric_limits<double>::infinity();
  }
  return depth;
}
}  // namespace

double overlapAtStart(Method method, double dt)
{
  World world = onATable(method, dt, 0.8).ball({0, 0, 0.005}).world();
  double speed = 0.0;
  for (int i = 0; i < 20; ++i)
  {
    world.advance(0.01);
    speed = std::max(speed, velocityOf(world).norm());
  }
  return speed;
}

double squeezeDepth(Method method, double dt)
{
  double deepest = 0.0;
  for (const double restitution : {0.0, 0.9, 1.0})
    for (const double u : {0.1, 1.0}) deepest = std::max(deepest, pressedDepth(method, dt, restitution, u));
  return deepest;
}
}  // namespace ping_pong::stability
