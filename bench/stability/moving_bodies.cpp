#include <algorithm>
#include <cmath>
#include <limits>

#include "situations.h"

namespace ping_pong::stability
{
namespace
{
constexpr double kInf = std::numeric_limits<double>::infinity();

// Velocity of the paddle on the orbit: straight lines between the nodes A sin(2 pi k / 80), 5 ms apart. The ball hits
// inside of piece 30, on the way up and slowing down, where the orbit is stable; at no whole number of anybody's steps.
constexpr int kNodes = 80;
constexpr int kPiece = 30;
constexpr double kPart = 0.37;  // of the piece
constexpr int kPeriods = 50;
constexpr double kNodeTime = 5e-3;              // [s]
constexpr double kPeriod = kNodes * kNodeTime;  // T [s]
constexpr double kOrbitRestitution = 0.8;

double wave(int k)
{
  return std::sin(2.0 * kPi * (k % kNodes) / kNodes);
}

double waveAtHit()
{
  return (1.0 - kPart) * wave(kPiece) + kPart * wave(kPiece + 1);
}

double amplitude()
{
  return 0.5 * kG * kPeriod * (1.0 - kOrbitRestitution) / (1.0 + kOrbitRestitution) / waveAtHit();
}

// Of the paddle at the hit: trapezoids, and a part of one.
double heightAtHit()
{
  double sum = 0.0;
  for (int k = 0; k < kPiece; ++k) sum += 0.5 * (wave(k) + wave(k + 1));
  return kNodeTime * amplitude() * (sum + 0.5 * kPart * (wave(kPiece) + waveAtHit()));
}

// A ball between x = 0 and x = room, which shrinks at u; v > 0: away from x = 0.
struct Between
{
  double x, v, room, u;
  std::size_t hits = 0;

  void flyFor(double left)
  {
    for (;;)
    {
      const double away = (room - x) / (v + u);
      if (away > left) break;
      left -= away, room -= u * away, v += 2.0 * u, ++hits;
      const double back = room / v;
      if (back > left)
      {
        x = room - v * left;
        v = -v;
        return;
      }
      left -= back, room -= u * back, x = 0.0, ++hits;
    }
    x += v * left;
  }
};
}  // namespace

World turningBlade(Method method, double dt, double lever)
{
  Shape shape = boxShape({0.2, kBladeThickness, 0.1});
  shape.p_BS = Vector3d(0.1, 0, 0);
  SceneBuilder builder(method, dt);
  builder.restitution(kBladeRestitution).paddle("blade", shape, at({0, 0, 0})).ball({0, lever, 0});
  World world = builder.world();
  world.command(0, velocityCommand({0, 0, 0}, {0, 0, kBladeTurn}));
  return world;
}

double turningBladeError(Method method, double dt)
{
  double worst = 0.0;
  for (int i = 0; i < 50; ++i)
  {
    const double lever = 0.15 + 0.0008 * i;
    World world = turningBlade(method, dt, lever);
    if (run(world, dt, static_cast<int>(std::ceil(0.05 / dt))).empty()) return kInf;
    const double reach = 0.5 * kBladeThickness + kR;  // of the ball's centre from the middle of the blade
    const double angle = 0.5 * kPi - std::asin(reach / lever);
    const double arm = std::sqrt(lever * lever - reach * reach);
    const Vector3d truth =
        (1.0 + kBladeRestitution) * kBladeTurn * arm * Vector3d(-std::sin(angle), std::cos(angle), 0);
    worst = std::max(worst, (velocityOf(world) - truth).norm() / truth.norm());
  }
  return worst;
}

Orbit vibratingPaddle(Method method, double dt)
{
  const double first = (kPiece + kPart) * kNodeTime;
  const double start = heightAtHit() + kR + 0.5 * kG * kPeriod * first - 0.5 * kG * first * first;
  World world = SceneBuilder(method, dt)
                    .gravity(kG)
                    .restitution(kOrbitRestitution)
                    .paddle("paddle", boxShape({0.3, 0.3, 0.01}), at({0, 0, -0.005}))
                    .ball({0, 0, start}, {0, 0, -0.5 * kG * kPeriod + kG * first})
                    .world();
  std::vector<Contact> hits;
  for (int k = 0; k < kPeriods * kNodes; ++k)
  {
    world.command(0, velocityCommand({0, 0, amplitude() * wave(k + 1)}));
    world.advance(kNodeTime);
    hits.insert(hits.end(), world.contacts().begin(), world.contacts().end());
  }
  Orbit orbit;
  orbit.hits = hits.size();
  for (std::size_t n = 0; n < std::min<std::size_t>(hits.size(), kPeriods); ++n)
  {
    orbit.time = std::max(orbit.time, std::abs(hits[n].time - first - static_cast<double>(n) * kPeriod));
    orbit.speed = std::max(orbit.speed, std::abs(hits[n].v_after.z() - 0.5 * kG * kPeriod));
  }
  return orbit;
}

Closing closingWalls(Method method, double dt)
{
  constexpr double kSpeed = 0.5;  // of the wall [m/s]
  constexpr double kEnd = 1.8;    // 80 mm of room are left then [s]
  SceneBuilder builder(method, dt);
  builder.box("wall", {0.1, 1, 1}, at({-0.05, 0, 0})).paddle("mover", boxShape({0.1, 1, 1}), at({1.05, 0, 0}));
  World world = builder.ball({kR, 0, 0}, {1, 0, 0}).world();
  world.command(1, velocityCommand({-kSpeed, 0, 0}));
  world.advance(dt);                                              // the drive needs a tick to get going
  const double room = world.bodyPose(1).p.x() - 0.05 - 2.0 * kR;  // for the centre, between the walls
  Between truth{positionOf(world).x() - kR, 1.0, room, kSpeed};
  truth.flyFor(kEnd - world.time());
  Closing closing;
  closing.expected = truth.hits;
  closing.hits = run(world, dt, static_cast<int>(std::lround(kEnd / dt)) - 1).size();
  closing.speed = std::abs(velocityOf(world).x() - truth.v) / std::abs(truth.v);
  closing.place = std::abs(positionOf(world).x() - kR - truth.x);
  return closing;
}
}  // namespace ping_pong::stability
