#include <algorithm>
#include <cmath>
#include <limits>

#include "situations.h"

namespace ping_pong::stability
{
namespace
{
constexpr double kDrop = 0.3;  // [m]
constexpr double kE = 0.9;
constexpr double kTick = 0.01;  // [s]

BallState droppedAt(const Vector3d& p)
{
  BallState state;
  state.p_WB = p;
  return state;
}

// Where a dropped ball is after a while on a table whose top is at `place`, seen from there.
Vector3d bounced(Method method, double dt, const Vector3d& place)
{
  World world = SceneBuilder(method, dt)
                    .gravity(kG)
                    .restitution(kE)
                    .box("table", {1, 1, 1}, at(place - Vector3d(0, 0, 0.5)))
                    .ball(place + Vector3d(-0.4, 0, kR + kDrop), {0.1, 0, 0})
                    .world();
  run(world, kTick, 200);
  return positionOf(world) - place;
}

// Height of a ball one second after it was dropped beside one that has waited for so long; and how far that one has
// moved.
std::pair<double, double> droppedAfter(Method method, double dt, int seconds)
{
  World world = SceneBuilder(method, dt).gravity(kG).restitution(kE).floor().ball({1, 0, kR}).world();
  run(world, 1.0, seconds);
  const double moved = std::abs(positionOf(world).z() - kR);
  if (world.spawnBall({}, droppedAt({0, 0, kR + kDrop}))) return {std::nan(""), moved};
  world.advance(1.0);
  return {positionOf(world, 1).z(), moved};
}
}  // namespace

double endOfBouncing(Method method, double dt)
{
  World world = SceneBuilder(method, dt).gravity(kG).restitution(kE).floor().ball({0, 0, kR + kDrop}).world();
  run(world, kTick, 800);
  if (!world.resting(0)) return std::numeric_limits<double>::infinity();
  return std::abs(world.restingSince(0) - std::sqrt(2.0 * kDrop / kG) * (1.0 + kE) / (1.0 - kE));
}

double restingJitter(Method method, double dt)
{
  World world = SceneBuilder(method, dt)
                    .gravity(kG)
                    .restitution(kE)
                    .box("table", {1, 1, 0.1}, at({0, 0, -0.05}))
                    .ball({0, 0, kR})
                    .world();
  double speed = 0.0;
  for (int i = 0; i < 6000; ++i)
  {
    world.advance(kTick);
    speed = std::max(speed, velocityOf(world).norm());
  }
  return speed;
}

double waiting(Method method, double dt)
{
  const auto [at_once, none] = droppedAfter(method, dt, 0);
  const auto [late, moved] = droppedAfter(method, dt, 1000);
  return std::max({none, moved, std::abs(late - at_once)});
}

double farAway(Method method, double dt)
{
  return (bounced(method, dt, {1e6, -1e6, 1e6}) - bounced(method, dt, {0, 0, 0})).norm();
}
}  // namespace ping_pong::stability
