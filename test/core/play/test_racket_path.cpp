// Ways of a racket: they end where and how they should, within limits.
#include <gtest/gtest.h>

#include "base/random.h"
#include "play/racket_path.h"
#include "testing/scene_builder.h"

namespace ping_pong::play
{
namespace
{
Vector3d anywhere(Random& random, double reach)
{
  return random.uniform(0.0, reach) * random.direction();
}

TEST(RacketPath, MeetsPlaceAndVelocityInTheMiddleOfATick)
{
  Random random(1, 0);
  double worst = 0.0, worst_velocity = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const double tick = random.uniform(0.5e-3, 5e-3), time = random.uniform(2.0, 80.0) * tick;
    const Vector3d goal = anywhere(random, 1.0), v_goal = anywhere(random, 10.0);
    Vector3d p = anywhere(random, 1.0), v = anywhere(random, 5.0);
    for (double left = time; left > 1e-12; left -= tick)
    {
      const Vector3d a = nextAcceleration(goal - p, v, v_goal, left, tick);
      const double h = std::min(left, tick);
      p += h * (v + 0.5 * h * a);
      v += h * a;
    }
    worst = std::max(worst, (p - goal).norm());
    worst_velocity = std::max(worst_velocity, (v - v_goal).norm());
  }
  measured("place off by at most [m]", worst);
  measured("velocity off by at most [m/s]", worst_velocity);
  EXPECT_LT(worst, 1e-9);  // rounding, and what a last tick of 1e-6 of its length makes of it
  EXPECT_LT(worst_velocity, 1e-6);
}

TEST(RacketPath, WithManyTicksItIsTheCubic)
{
  const Vector3d p(0.1, 0.2, 0.3), v(1, -2, 0.5);
  const Waypoint goal{0.4, {0.5, -0.2, 0.4}, {3, 1, 4}};
  Vector3d at = p, now = v;
  const double tick = 1e-4;
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3d a = nextAcceleration(goal.p - at, now, goal.v, goal.time - i * tick, tick);
    at += tick * (now + 0.5 * tick * a);
    now += tick * a;
  }
  const PathPoint half = onCubic(p, v, 0.0, goal, 0.2);
  EXPECT_LT((at - half.p).norm(), 1e-6);
  EXPECT_LT((now - half.v).norm(), 1e-4);
}

TEST(RacketPath, WithinLimitsIsTrueOfTheCubic)
{
  Random random(2, 0);
  const double speed = 8.0, acceleration = 100.0;
  int within = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3d p = anywhere(random, 0.5), v = anywhere(random, 2.0);
    const Waypoint goal{random.uniform(0.05, 0.6), anywhere(random, 0.5), anywhere(random, 6.0)};
    if (!withinLimits(p, v, 0.0, goal, speed, acceleration)) continue;
    ++within;
    const double h = goal.time / 200.0;
    for (int k = 1; k < 200; ++k)
    {
      const PathPoint before = onCubic(p, v, 0.0, goal, (k - 1) * h), after = onCubic(p, v, 0.0, goal, k * h);
      EXPECT_LT((after.v - before.v).norm() / h, acceleration * (1.0 + 1e-9));
      EXPECT_LT(after.v.norm(), 1.05 * speed);  // between the places that are looked at
    }
  }
  EXPECT_GT(within, 200);
  const double time = restToRest(0.4, speed, acceleration);
  EXPECT_TRUE(withinLimits({0, 0, 0}, {0, 0, 0}, 0.0, {1.0001 * time, {0.4, 0, 0}, {0, 0, 0}}, speed, acceleration));
  EXPECT_FALSE(withinLimits({0, 0, 0}, {0, 0, 0}, 0.0, {0.99 * time, {0.4, 0, 0}, {0, 0, 0}}, speed, acceleration));
}

TEST(RacketDrive, KeepsItsLimitsWhateverIsAsked)
{
  const DriveLimits limits{7.0, 90.0, 20.0, 1500.0};
  const RacketDrive drive(limits);
  World world = SceneBuilder().paddle("paddle", cylinderShape(0.08, 0.01), at({0, 0, 1})).world();
  Random random(3, 0);
  const double tick = 1e-3;
  double top = 0.0, top_acceleration = 0.0, top_turning = 0.0;
  Waypoint goal;
  Quaterniond attitude;
  for (int i = 0; i < 20000; ++i)
  {
    const double time = world.time();
    if (i % 60 == 0)
    {
      goal = {time + random.uniform(0.0, 0.1), anywhere(random, 3.0), anywhere(random, 30.0)};
      attitude = Quaterniond(Eigen::AngleAxisd(random.uniform(0.0, 3.0), random.direction()));
    }
    const Twist before = world.bodyTwist(0);
    world.command(0, drive.command(world.bodyPose(0), before, time, tick, goal, attitude, goal.time));
    world.advance(tick);
    const Twist after = world.bodyTwist(0);
    ASSERT_TRUE(after.v.allFinite() && after.w.allFinite());
    top = std::max(top, after.v.norm());
    top_acceleration = std::max(top_acceleration, (after.v - before.v).norm() / tick);
    top_turning = std::max(top_turning, after.w.norm());
  }
  measured("speed at most [m/s]", top);
  measured("acceleration at most [m/s^2]", top_acceleration);
  EXPECT_LE(top, limits.speed);
  EXPECT_LE(top_acceleration, limits.acceleration);
  EXPECT_LE(top_turning, limits.angular_speed * 1.01);  // of a rotation vector that bends
}

TEST(RacketDrive, TurnsToItsAttitude)
{
  const DriveLimits limits{20.0, 400.0, 50.0, 4000.0};
  const RacketDrive drive(limits);
  Random random(4, 0);
  for (int i = 0; i < 50; ++i)
  {
    World world = SceneBuilder().paddle("paddle", cylinderShape(0.08, 0.01), at({0, 0, 1})).world();
    const Quaterniond attitude(Eigen::AngleAxisd(random.uniform(0.0, 2.5), random.direction()));
    const Waypoint goal{0.25, {0.1, 0.2, 1.1}, {0, 0, 0}};
    while (world.time() < 0.2595)
    {
      world.command(0, drive.command(world.bodyPose(0), world.bodyTwist(0), world.time(), 1e-3, goal, attitude, 0.2));
      world.advance(1e-3);
      if (std::abs(world.time() - 0.25) < 1e-9)
      {
        EXPECT_LT((world.bodyPose(0).p - goal.p).norm(), 1e-9);
      }
    }
    EXPECT_LT(rotationBetween(world.bodyPose(0).q, attitude).norm(), 1e-9);
    EXPECT_LT(world.bodyTwist(0).w.norm(), 1e-6);
  }
}
}  // namespace
}  // namespace ping_pong::play
