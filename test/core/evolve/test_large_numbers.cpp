// Far from the origin and long after the start a bounce is the same bounce.
#include <gtest/gtest.h>

#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
constexpr double kFar = 1e6;   // neighbours of a double are 1.2e-10 m apart there, those of a float 6 cm: three radii
constexpr double kDrop = 0.3;  // [m]
constexpr double kE = 0.9;

double timeToRest()
{
  return std::sqrt(2.0 * kDrop / kG) * (1.0 + kE) / (1.0 - kE);
}

TEST(LargeNumbers, AMillionMetresAwayABallBouncesToRestAsAtHome)
{
  const Vector3d place(kFar, -kFar, kFar);
  SceneBuilder builder;
  builder.gravity(kG).restitution(kE).box("table", {1, 1, 1}, at(place));
  builder.ball(place + Vector3d(-0.4, 0, 0.5 + kR + kDrop), {0.1, 0, 0});
  World world = builder.world();
  const std::vector<Contact> bounces = run(world, 0.01, 600);
  ASSERT_GE(bounces.size(), 60u);
  double speed = std::sqrt(2.0 * kG * kDrop);
  for (int i = 0; i < 20; ++i)
  {
    speed *= kE;
    // Heights are rounded to 1e-10 m, speeds v to g 1e-10 / v: 3e-9 m/s at the 20th bounce.
    EXPECT_NEAR(bounces[static_cast<std::size_t>(i)].v_after.z(), speed, 1e-8);
  }
  measured("1e6 m away, time to rest is off by [s]", world.restingSince(0) - timeToRest());
  EXPECT_NEAR(world.restingSince(0), timeToRest(),
              1e-4);  // 2 v / g of the last bounce above rounding, v^2 / 2g = 1e-10 m
  EXPECT_NEAR(positionOf(world).z(), kFar + 0.5 + kR, 2.4e-10);
  EXPECT_NEAR(velocityOf(world).x(), 0.1, 1e-12) << "a smooth table does not brake";
}

TEST(LargeNumbers, AMillionMetresAwayElasticBouncesGoOn)
{
  SceneBuilder builder;
  builder.gravity(kG).floor(kFar).ball({kFar, kFar, kFar + kR + kDrop});
  World world = builder.world();
  const std::size_t bounces = run(world, 0.1, 1000).size();
  EXPECT_EQ(bounces, 202u);  // (100 s + 0.2473 s) / 0.4946 s = 202.7
  const double energy = 0.5 * velocityOf(world).squaredNorm() + kG * (positionOf(world).z() - kFar - kR);
  measured("1e6 m away, 100 s of elastic bounces: E/E0 - 1", energy / (kG * kDrop) - 1.0);
  EXPECT_NEAR(energy / (kG * kDrop), 1.0, 1e-7);  // 200 roundings of 1e-10 m in 0.3 m, all to one side
}

TEST(LargeNumbers, AfterAThousandSecondsOfWaitingTheBounceIsTheSame)
{
  SceneBuilder builder;
  builder.gravity(kG).restitution(kE).floor().ball({1, 0, kR});
  World world = builder.world();
  run(world, 1.0, 1000);
  BallState drop;
  drop.p_WB = Vector3d(0, 0, kR + kDrop);
  ASSERT_FALSE(world.spawnBall({}, drop));
  const std::vector<Contact> bounces = run(world, 1e-3, 6000);
  // Time is rounded to 1e-13 s (a float: 6e-5 s, and the order of bounces is lost).
  EXPECT_NEAR(bounces.at(0).time, 1000.0 + std::sqrt(2.0 * kDrop / kG), 3e-13);
  measured("after 1000 s, time to rest is off by [s]", world.restingSince(1) - 1000.0 - timeToRest());
  EXPECT_NEAR(world.restingSince(1), 1000.0 + timeToRest(), 1e-9);
  EXPECT_EQ(positionOf(world, 0), Vector3d(1, 0, kR));
  EXPECT_EQ(positionOf(world, 1), Vector3d(0, 0, kR));
}

TEST(LargeNumbers, AMillionTicksEndWhereTheyShould)
{
  World world = SceneBuilder().ball({0, 0, 0}, {1, 0, 0}).world();
  for (int i = 0; i < 1000000; ++i) world.advance(1e-3);
  EXPECT_EQ(world.time(), 1000.0);  // a running sum is off by 2e-8 s
  EXPECT_EQ(positionOf(world).x(), 1000.0);
}
}  // namespace
}  // namespace ping_pong
