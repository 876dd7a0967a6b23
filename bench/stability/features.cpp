#include <algorithm>
#include <cmath>
#include <limits>

#include "situations.h"

namespace ping_pong::stability
{
namespace
{
constexpr double kHair = 1e-6;  // [m]

// Walls x < 0 and y < 0, listed in this order; the ball comes from 0.5 m away and is seen after one second.
Vector3d afterRightAngle(Method method, double dt, const std::vector<int>& order, const Vector3d& v)
{
  SceneBuilder builder(method, dt);
  for (const int axis : order)
  {
    Vector3d middle = Vector3d::Constant(1.5);
    middle[axis] = -2.0;
    builder.box("wall", {4, 4, 4}, at(middle));
  }
  World world = builder.ball(Vector3d(kR, kR, 0.5) - 0.5 * v, v).world();
  world.advance(1.0);
  return velocityOf(world);
}

// A ball comes down on the edge x = 0 or the corner x = y = 0 of a box below z = 0, off by `out` outside of it.
double thrownAtEdge(Method method, double dt, const Vector3d& out, double height)
{
  constexpr double kSpeed = 9.0;  // [m/s]
  const Vector3d n(out.x() / kR, out.y() / kR, std::sqrt(1.0 - out.squaredNorm() / (kR * kR)));
  const double middle = out.y() == 0.0 ? 0.0 : -0.5;
  World world = SceneBuilder(method, dt)
                    .box("table", {1, 1, 0.1}, at({-0.5, middle, -0.05}))
                    .ball({out.x(), out.y(), height}, {0, 0, -kSpeed})
                    .world();
  run(world, 0.01, 10);
  const Vector3d truth = kSpeed * (2.0 * n.z() * n - Vector3d::UnitZ());
  return (velocityOf(world) - truth).norm() / kSpeed;
}

// Over a thin wall on a parabola whose top is right above it.
std::size_t netHits(Method method, double dt, double clearance, double phase)
{
  const double v = 3.0;
  const double t = 0.2 + phase * dt;  // from start to top
  SceneBuilder builder(method, dt);
  builder.gravity(kG).box("net", {1e-4, 1, 0.2}, at({0, 0, -0.1}));
  builder.ball({-v * t, 0, kR + clearance - 0.5 * kG * t * t}, {v, 0, kG * t});
  World world = builder.world();
  return run(world, dt, static_cast<int>(std::lround(0.4 / dt))).size();
}

// The last ball of the scene starts in touch; it should end with speed `v` after `hits` contacts.
bool startsRight(SceneBuilder& builder, std::size_t hits, const Vector3d& v)
{
  World world = builder.world();
  const std::size_t seen = run(world, 0.01, 10).size();
  return seen == hits && (velocityOf(world, world.ballCount() - 1) - v).norm() <= 1e-12;
}
}  // namespace

double twoWallsError(Method method, double dt)
{
  double worst = 0.0;
  for (int i = 1; i < 90; ++i)
  {
    const double angle = kPi / 180.0 * i;
    const Vector3d v(-std::cos(angle), -std::sin(angle), 0);
    for (const std::vector<int>& order : {std::vector<int>{0, 1}, std::vector<int>{1, 0}})
      worst = std::max(worst, (afterRightAngle(method, dt, order, v) + v).norm());
  }
  return worst;
}

double edgeError(Method method, double dt)
{
  double worst = 0.0;
  for (int i = 0; i < 20; ++i)
  {
    const double height = 0.1 + 0.0137 * i;
    worst = std::max(worst, thrownAtEdge(method, dt, {0.012, 0, 0}, height));
    worst = std::max(worst, thrownAtEdge(method, dt, {0.01, 0.01, 0}, height));
  }
  return worst;
}

int wrongNetCalls(Method method, double dt)
{
  int wrong = 0;
  for (int i = 0; i < 50; ++i)
  {
    wrong += netHits(method, dt, kHair, i / 50.0) != 0;
    wrong += netHits(method, dt, -kHair, i / 50.0) == 0;
  }
  return wrong;
}

int wrongTouchingStarts(Method method, double dt)
{
  int wrong = 0;
  for (const double up : {-1.0, 0.0, 1.0})  // closing in, along, receding
  {
    SceneBuilder wall(method, dt);
    wall.floor().ball({0, 0, kR}, {1, 0, up});
    wrong += !startsRight(wall, up < 0.0, {1, 0, std::abs(up)});
  }
  for (const double away : {-1.0, 1.0})
  {
    SceneBuilder pair(method, dt);
    pair.ball({0, 0, 0}).ball({2.0 * kR, 0, 0}, {away, 0, 0});
    wrong += !startsRight(pair, away < 0.0, {away < 0.0 ? 0.0 : away, 0, 0});
  }
  return wrong;
}
}  // namespace ping_pong::stability
