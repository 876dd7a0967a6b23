// Method impulse: a ball that moving bodies leave no room is squeezed, not shot out.
#include <gtest/gtest.h>

#include <algorithm>

#include "ping_pong_sim/state_hash.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
constexpr double kPlateRadius = 0.08, kPlate = 0.014;

struct Law
{
  double e, mu;
};

Scene withLaw(Scene scene, const Law& law)
{
  Surface surface;
  surface.restitution = law.e;
  surface.friction = law.mu;
  for (MaterialId a = 0; a < scene.materials.size(); ++a)
    for (MaterialId b = 0; b < scene.materials.size(); ++b) scene.surfaces.set(a, b, surface);
  return scene;
}

double fastest(const World& world)
{
  double speed = 0.0;
  for (std::size_t i = 0; i < world.ballCount(); ++i) speed = std::max(speed, velocityOf(world, i).norm());
  return speed;
}

double deepestInFloor(const World& world)
{
  double deep = 0.0;
  for (std::size_t i = 0; i < world.ballCount(); ++i) deep = std::max(deep, kR - positionOf(world, i).z());
  return deep;
}

// A plate, maybe tilted, comes down on a stack of balls on the floor at speed u, from 5 mm above them to the floor, where it stays;
// every other ball is `aside` by so much.
struct Press
{
  World world;
  double u, tick, to_floor;
  std::size_t squeezed = 0;
  double speed = 0.0, deep = 0.0;  // greatest so far [m/s], [m]

  Press(std::size_t balls, double its_u, double its_tick, const Law& law, double tilt = 0.0, double aside = 0.0)
      : world(scene(balls, law, tilt, aside)), u(its_u), tick(its_tick), to_floor(world.bodyPose(1).p.z())
  {
  }

  static Scene scene(std::size_t balls, const Law& law, double tilt, double aside)
  {
    SceneBuilder builder(Method::Impulse);
    builder.gravity(kG).floor();
    const double top = 2.0 * kR * static_cast<double>(balls) + 0.005;
    builder.paddle("plate", cylinderShape(kPlateRadius, kPlate),
                   at({0.01, 0, top + 0.5 * kPlate + kPlateRadius * std::sin(tilt)}, tilt, Vector3d::UnitY()));
    for (std::size_t i = 0; i < balls; ++i)
      builder.ball({aside * static_cast<double>(i % 2), 0, kR + 2.0 * kR * static_cast<double>(i)});
    return withLaw(builder.build(), law);
  }

  void run(const Vector3d& v, double duration)
  {
    for (long k = std::max(2L, std::lround(duration / tick)); k > 0; --k)
    {
      world.command(1, velocityCommand(v));
      const StepStatus status = world.advance(tick);
      EXPECT_FALSE(status.not_finite);
      squeezed = status.squeezed;
      speed = std::max(speed, fastest(world));
      deep = std::max(deep, deepestInFloor(world));
    }
  }
  void down() { run({0, 0, -u}, to_floor / u); }
};

// The scene of the issue: .9 on the floor, .8 on the plate.
TEST(SolverSqueeze, APlateThatComesDownOnABallDoesNotShootItOut)
{
  for (const double tick : {1e-2, 1e-3, 1e-4})
  {
    SceneBuilder builder(Method::Impulse);
    builder.gravity(kG)
        .floor()
        .paddle("plate", cylinderShape(kPlateRadius, kPlate), at({0.01, 0, 0.185}))
        .ball({0, 0, kR});
    Scene scene = builder.build();
    Surface floor, plate;
    floor.restitution = 0.9;
    floor.friction = 0.25;
    scene.surfaces.set(0, 1, floor);
    World world(scene);
    double speed = 0.0;
    std::size_t squeezed = 0;
    for (int i = 0; i < std::lround(0.1 / tick); ++i)
    {
      world.command(1, velocityCommand({0, 0, -3}));
      squeezed = world.advance(tick).squeezed;
      speed = std::max(speed, fastest(world));
    }
    measured("d6: fastest at the end of a tick [m/s]", speed);
    EXPECT_EQ(squeezed, 1u);
    EXPECT_LE(speed, 6.0) << "an elastic hit by the plate";
    EXPECT_EQ(velocityOf(world), Vector3d::Zero());
    EXPECT_LE((positionOf(world) - Vector3d(0, 0, kR)).norm(), 1e-4);
  }
}

TEST(SolverSqueeze, OneBallIsSqueezedAtAnySpeedAndTickAndLetGoAtRest)
{
  double speed = 0.0;
  for (const double e : {0.0, 0.5, 0.9, 1.0})
    for (const double mu : {0.0, 0.5})
      for (const double tilt : {0.0, 0.01})
        for (const double tick : {1e-2, 1e-3, 1e-4})
          for (const double u : {0.1, 2.0, 10.0, 30.0})
          {
            if (tick < 5e-4 && u < 1.0) continue;  // long
            Press press(1, u, tick, {e, mu}, tilt);
            press.down();
            press.run({0, 0, 0}, 0.01);
            const std::string which = testing::PrintToString(std::vector<double>{e, mu, tilt, tick, u});
            EXPECT_EQ(press.squeezed, 1u) << which;
            EXPECT_LE(press.speed, 4.0 * u) << which;
            EXPECT_EQ(velocityOf(press.world), Vector3d::Zero()) << which;
            EXPECT_LE(press.deep, 1e-4) << which;
            speed = std::max(speed, press.speed / u);
            press.run({0, 0, 2}, 0.1);
            EXPECT_EQ(press.squeezed, 0u) << which << ": there is room again";
            EXPECT_LE(velocityOf(press.world).norm(), 1e-2) << which << ": it is let go at rest";
            EXPECT_NEAR(positionOf(press.world).z(), kR, 1e-4) << which;
          }
  measured("one ball: fastest, by the speed of the plate", speed);
}

// A stack that falls over by itself is as fast as its height allows. Balls that bounce without loss between surfaces that close on them
// gain speed; nothing more is known of the fastest one. Without any care it was 16 000 times as fast as the plate.
TEST(SolverSqueeze, AStackIsNotShotOut)
{
  double most = 0.0;
  for (const std::size_t balls : {2, 3, 5})
    for (const double e : {0.5, 0.8, 1.0})
      for (const double mu : {0.0, 0.5})
        for (const double tilt : {0.0, 0.01})
          for (const double aside : {0.0, 1e-3})
            for (const double tick : {1e-3, 1e-4})
              for (const double u : {2.0, 10.0})
              {
                Press press(balls, u, tick, {e, mu}, tilt, aside);
                press.down();
                press.run({0, 0, 0}, 0.01);
                const double fall = std::sqrt(2.0 * kG * 2.0 * kR * static_cast<double>(balls));
                const std::string which =
                    testing::PrintToString(std::vector<double>{1.0 * balls, e, mu, tilt, aside, tick, u});
                EXPECT_LE(press.speed, (e < 1.0 && tick > 5e-4 ? 8.5 : 20.0) * u + fall) << which;
                most = std::max(most, (press.speed - fall) / u);
              }
  measured("stacks: fastest but for the fall, by the speed of the plate", most);
}

// Without friction: v = u / tan(tilt) if it keeps touching both, twice that if it bounces between them, see test_squeeze.cpp.
TEST(SolverSqueeze, AWedgePushesABallOutAsFastAsItMust)
{
  for (const double tilt : {0.15, 0.3})
    for (const double u : {0.2, 1.0, 10.0})
      for (const double tick : {1e-3, 1e-4})
        for (const double e : {0.0, 0.5, 0.9})
        {
          Press press(1, u, tick, {e, 0.0}, tilt);
          std::size_t squeezed = 0;
          for (double s = 0.0; s < press.to_floor && std::abs(positionOf(press.world).x()) < 0.15;
               s += 2.0 * u * tick)  // run() has two ticks
          {
            press.run({0, 0, -u}, 0.0);
            squeezed = std::max(squeezed, press.squeezed);
          }
          const double wedge = u / std::tan(tilt);
          EXPECT_EQ(squeezed, 0u) << tilt << " " << u << " " << tick << " " << e;
          EXPECT_GE(press.speed, 0.98 * wedge) << tilt << " " << u << " " << tick << " " << e;
          EXPECT_LE(press.speed, (e == 0.0 ? 1.03 : 2.03) * wedge + 0.1) << tilt << " " << u << " " << tick << " " << e;
        }
}

TEST(SolverSqueeze, ABallWithAFreeWayIsHitNotSqueezed)
{
  for (const double e : {0.0, 0.5, 1.0})
    for (const double tick : {1e-2, 1e-3})
      for (const double u : {0.5, 5.0, 30.0})
      {
        SceneBuilder builder(Method::Impulse);
        builder.gravity(kG)
            .floor()
            .paddle("plate", boxShape({0.02, 0.2, 0.1}), at({-0.5, 0, 0.051}))
            .ball({0, 0, kR})
            .ball({1, 0, 1});
        World world(withLaw(builder.build(), {e, 0.0}));
        for (double x = -0.5; x < 0.3; x += u * tick)
        {
          world.command(1, velocityCommand({u, 0, 0}));
          EXPECT_EQ(world.advance(tick).squeezed, 0u) << e << " " << tick << " " << u;
        }
        EXPECT_NEAR(velocityOf(world).x(), (1.0 + e) * u, 1e-3 * u) << e << " " << tick << " " << u;
      }
}

// Between two paddles in mid-air that come together.
TEST(SolverSqueeze, PaddlesThatComeTogetherHoldABallUntilTheyPart)
{
  SceneBuilder builder(Method::Impulse);
  builder.gravity(0.0).restitution(1.0).ball({0, 0, 0}).ball({1, 0, 0});
  for (const double side : {-1.0, 1.0})
    builder.paddle(side < 0.0 ? "right" : "left", boxShape({0.2, 0.02, 0.2}), at({0, 0.04 * side, 0}));
  World world = builder.world();
  const auto move = [&](double u, int ticks)
  {
    StepStatus status;
    for (int i = 0; i < ticks; ++i)
    {
      world.command(0, velocityCommand({0, u, 0}));
      world.command(1, velocityCommand({0, -u, 0}));
      status = world.advance(1e-3);
      EXPECT_LE(fastest(world), 4.0);
    }
    return status.squeezed;
  };
  EXPECT_EQ(move(1.0, 15), 1u);
  EXPECT_EQ(velocityOf(world), Vector3d::Zero());
  EXPECT_LE(positionOf(world).norm(), 0.01);
  EXPECT_EQ(move(-1.0, 25), 0u);
  EXPECT_LE(velocityOf(world).norm(), 1e-9);
}

// A plate presses a crowd in a box; `exact` has passed it on.
Scene pressedCrowd(Method method)
{
  SceneBuilder builder(method);
  builder.gravity(kG).restitution(0.5).floor();
  const double half = 4 * 0.041;
  for (const double s : {-1.0, 1.0})
    builder.box("", {0.02, 1, 1}, at({s * (half + 0.01), 0, 0.5}))
        .box("", {1, 0.02, 1}, at({0, s * (half + 0.01), 0.5}));
  builder.paddle("plate", boxShape({2 * half - 0.002, 2 * half - 0.002, 0.02}), at({0, 0, 0.45}));
  for (int i = 0; i < 512; ++i)
    builder.ball({0.041 * (i % 8 - 3.5), 0.041 * (i / 8 % 8 - 3.5), 0.021 + 0.041 * (i / 64)},
                 {0.1 * std::sin(i), 0.1 * std::cos(2 * i), 0});
  return builder.build();
}

TEST(SolverSqueeze, ACrowdUnderAPlateIsTheSameWithAnyNumberOfThreads)
{
  std::uint64_t hash = 0;
  for (const std::size_t threads : {1, 3})
  {
    Scene scene = pressedCrowd(Method::Impulse);
    scene.threads = threads;
    World world(scene);
    std::size_t squeezed = 0;
    double speed = 0.0;
    for (int i = 0; i < 150; ++i)
    {
      world.command(5, velocityCommand({0, 0, -2}));
      squeezed = std::max(squeezed, world.advance(1e-3).squeezed);
      speed = std::max(speed, fastest(world));
    }
    EXPECT_GT(squeezed, 10u);
    EXPECT_LE(speed, 16.0);
    EXPECT_LE(deepestInFloor(world), 2e-3);
    if (threads == 1) measured("crowd under a plate at 2 m/s: fastest [m/s]", speed);
    if (threads == 1) measured("squeezed", static_cast<double>(squeezed));
    if (threads == 1) hash = stateHash(world);
    EXPECT_EQ(stateHash(world), hash);
  }
}
}  // namespace
}  // namespace ping_pong
