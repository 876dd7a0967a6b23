// Balls that lie on something, and what makes them move again.
#include <gtest/gtest.h>

#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
// A table whose top is z = 0 when it is not tilted; turned about the y axis through the middle of the top: +x goes
// down.
Pose tilted(double angle)
{
  const Quaterniond q(Eigen::AngleAxisd(angle, Vector3d::UnitY()));
  return {q * Vector3d(0, 0, -0.05), q};
}

World restingOnTable()
{
  World world = SceneBuilder()
                    .gravity(kG)
                    .restitution(0.7)
                    .box("table", {2, 1, 0.1}, tilted(0.0))
                    .ball({0, 0, kR + 0.01})
                    .world();
  world.advance(2.0);
  return world;
}

TEST(Resting, OnATiltedTableABallSlidesWithGSinTheta)
{
  for (const double angle : {1e-6, 0.01, 0.3, 1.2})
  {
    World world = restingOnTable();
    ASSERT_TRUE(world.resting(0));
    ASSERT_FALSE(world.setBodyPose(0, tilted(angle)));
    const Vector3d start = positionOf(world);
    const Vector3d downhill(std::cos(angle), 0, -std::sin(angle));
    const Vector3d normal(std::sin(angle), 0, std::cos(angle));
    EXPECT_NEAR(normal.dot(start), kR, 1e-13);  // put there within a few touch tolerances
    EXPECT_EQ(velocityOf(world), Vector3d::Zero());
    for (int i = 1; i <= 40; ++i)
    {
      world.advance(0.01);
      const double t = 0.01 * i;
      const double a = kG * std::sin(angle);
      // Roundings of 1e-16 in a and in the place; 40 ticks do not add up.
      ASSERT_NEAR(downhill.dot(positionOf(world) - start), 0.5 * a * t * t, 1e-13) << angle;
      ASSERT_NEAR(downhill.dot(velocityOf(world)), a * t, 1e-13);
      ASSERT_NEAR(normal.dot(positionOf(world)), kR, 1e-14);
      ASSERT_EQ(world.contacts().size(), 0u);
    }
    EXPECT_FALSE(world.resting(0));
  }
}

TEST(Resting, OnASlopeBouncesDoNotBrakeTheSlide)
{
  for (const double angle : {0.05, 0.4})
    for (const double e : {0.0, 0.3, 0.8, 0.95})
    {
      World world = SceneBuilder()
                        .gravity(kG)
                        .restitution(e)
                        .box("table", {200, 1, 0.1}, tilted(angle))
                        .ball(tilted(angle).q * Vector3d(0, 0, kR + 0.1), tilted(angle).q * Vector3d(0.4, 0, 0))
                        .world();
      double worst = 0.0;
      for (int i = 1; i <= 600; ++i)
      {
        ASSERT_TRUE(world.advance(0.01).ok());
        const double t = 0.01 * i;
        const double along = (tilted(angle).q.conjugate() * positionOf(world)).x();
        worst = std::max(worst, std::abs(along - 0.4 * t - 0.5 * kG * std::sin(angle) * t * t));
      }
      EXPECT_LE(worst, 1e-12) << angle << " " << e;  // 200 bounces, each with a normal that is rounded to 1e-16
      EXPECT_FALSE(std::isnan(world.restingSince(0))) << angle << " " << e;
      // 70 m down the slope places are rounded to 1e-14 m, and the last bounces are 1e-12 m high.
      const double fall = std::sqrt(2.0 * 0.1 / (kG * std::cos(angle)));
      EXPECT_NEAR(world.restingSince(0), fall * (1.0 + e) / (1.0 - e), 1e-7) << angle << " " << e;
    }
}

TEST(Resting, ATableTakenAwayLetsTheBallFall)
{
  World world = restingOnTable();
  world.setBodyPose(0, at({0, 0, -0.05 - 0.2}));
  EXPECT_FALSE(world.resting(0));
  world.advance(0.15);
  EXPECT_NEAR(positionOf(world).z(), kR - 0.5 * kG * 0.15 * 0.15, 1e-15);
  world.advance(3.0);
  EXPECT_TRUE(world.resting(0));
  EXPECT_NEAR(positionOf(world).z(), kR - 0.2, 1e-15);
}

TEST(Resting, AHitBallMovesOff)
{
  World world = SceneBuilder()
                    .gravity(kG)
                    .restitution(0.5)
                    .restitution("ball", "ball", 1.0)
                    .floor()
                    .ball({0, 0, kR})
                    .ball({-0.5, 0, kR}, {1, 0, 0})
                    .world();
  run(world, 0.1, 4);
  EXPECT_TRUE(world.resting(0));
  run(world, 0.1, 6);  // they meet at 0.46 s
  EXPECT_NEAR(velocityOf(world, 0).x(), 1.0, 1e-14);
  EXPECT_NEAR(positionOf(world, 0).x(), 0.54, 1e-14);
  EXPECT_EQ(velocityOf(world, 1).norm(), 0.0);
  EXPECT_TRUE(world.resting(1));
  EXPECT_EQ(positionOf(world, 0).z(), kR);
}

TEST(Resting, AVGrooveHoldsABallOnBothSides)
{
  for (const double e : {0.0, 0.5, 0.8})
  {
    SceneBuilder builder;
    builder.gravity(kG).restitution(e);
    for (const int side : {-1, 1})  // walls of 45 degrees that meet in the line x = 0, z = 0
    {
      const Vector3d out = Vector3d(-side, 0, 1).normalized();
      const Vector3d along = Vector3d(side, 0, 1).normalized();
      const Eigen::AngleAxisd turn(-side * 0.25 * kPi, Vector3d::UnitY());
      builder.box("wall", {1, 1, 0.1}, {0.45 * along - 0.05 * out, Quaterniond(turn)});
    }
    World world = builder.ball({0.07, 0, 0.2}).world();
    std::size_t events = 0;
    for (int i = 0; i < 3000; ++i)
    {
      const StepStatus status = world.advance(0.01);
      ASSERT_TRUE(status.ok()) << e;
      events += status.events;
    }
    measured("V groove, events to rest", static_cast<double>(events));
    EXPECT_TRUE(world.resting(0)) << e;
    // The nearest place to the line at which a ball touches both: r sqrt(2) above it.
    EXPECT_LE((positionOf(world) - Vector3d(0, 0, kR * std::sqrt(2.0))).norm(), 1e-14) << e;
    EXPECT_LT(events, 3000u);
  }
}

TEST(Resting, TheLowestCornerOfATiltedTrayHoldsABallOnThreeSides)
{
  const Quaterniond q = Quaterniond(Eigen::AngleAxisd(0.3, Vector3d(1, -1, 0).normalized()));  // lowest: x = y = 0
  std::vector<Shape> shapes;
  for (int axis = 0; axis < 3; ++axis)
  {
    Vector3d middle = Vector3d::Constant(0.4);
    middle[axis] = -0.05;
    Vector3d size = Vector3d::Constant(1.0);
    size[axis] = 0.1;
    Shape wall = boxShape(size);
    wall.p_BS = middle;
    shapes.push_back(wall);
  }
  const Vector3d down = q.conjugate() * Vector3d(0, 0, -1);
  ASSERT_TRUE(down.x() < -0.1 && down.y() < -0.1 && down.z() < -0.1);
  World world = SceneBuilder()
                    .gravity(kG)
                    .restitution(0.6)
                    .body("tray", BodyKind::Static, shapes, {{1, 2, 3}, q})
                    .ball(Vector3d(1, 2, 3) + q * Vector3d(0.2, 0.3, 0.1))
                    .world();
  StepStatus status;
  for (int i = 0; i < 1000; ++i)
  {
    status = world.advance(0.01);
    ASSERT_TRUE(status.ok());
  }
  EXPECT_EQ(status.events, 0u);
  EXPECT_TRUE(world.resting(0));
  EXPECT_LE((positionOf(world) - Vector3d(1, 2, 3) - q * Vector3d(kR, kR, kR)).norm(), 1e-14);  // 4 m from the origin
}

// --- on a paddle that moves ---

PaddleCommand acceleration(double a)
{
  PaddleCommand command;
  command.mode = PaddleCommand::Mode::Acceleration;
  command.a_W = Vector3d(0, 0, a);
  return command;
}

World restingOnPaddle()
{
  return SceneBuilder()
      .gravity(kG)
      .restitution(0.5)
      .paddle("paddle", boxShape({0.3, 0.3, 0.02}), at({0, 0, -0.01}))
      .ball({0.05, 0, kR})
      .world();
}

TEST(Resting, APaddleLiftsABallAndThrowsItWhenItBrakesHarderThanGravity)
{
  World world = restingOnPaddle();
  world.advance(0.01);
  ASSERT_TRUE(world.resting(0));
  world.command(0, acceleration(5.0));
  for (int i = 1; i <= 100; ++i)
  {
    world.advance(2e-3);
    const double t = 2e-3 * i;
    ASSERT_NEAR(positionOf(world).z(), kR + 2.5 * t * t, 1e-13);
    ASSERT_NEAR(velocityOf(world).z(), 5.0 * t, 1e-13);
    ASSERT_EQ(world.contacts().size(), 0u);
  }
  world.command(0, acceleration(-9.0));  // gently: the ball stays
  run(world, 2e-3, 20);
  EXPECT_NEAR(positionOf(world).z() - kR, world.bodyPose(0).p.z() + 0.01, 1e-13);
  const double v = velocityOf(world).z();
  const double z = positionOf(world).z();
  world.command(0, acceleration(-15.0));  // harder than g: it flies
  run(world, 2e-3, 30);
  EXPECT_NEAR(positionOf(world).z(), z + v * 0.06 - 0.5 * kG * 0.06 * 0.06, 1e-13);
  EXPECT_GT(positionOf(world).z() - kR, world.bodyPose(0).p.z() + 0.01 + 1e-3);
}

TEST(Resting, ASmoothPaddlePulledAwaySidewaysLeavesTheBallBehind)
{
  World world = restingOnPaddle();
  world.advance(0.01);
  world.command(0, velocityCommand({0, 2.0, 0}));
  run(world, 2e-3, 30);
  EXPECT_LE((positionOf(world) - Vector3d(0.05, 0, kR)).norm(), 1e-14);
  run(world, 2e-3, 60);  // the edge passes at 0.077 s; then the ball rolls over it and falls
  EXPECT_LT(positionOf(world).z(), kR - 0.01);
}

TEST(Resting, ATurningPaddleCarriesABallOnItsCircleAndItsEnergyChangesByTheWorkDone)
{
  // A slow seesaw about the y axis through its middle: in the paddle's frame the ball starts at rest on the axis and
  // obeys x'' = w^2 x - g sin(angle) downhill, angle = w t: x = g / (2 w^2) (sinh wt - sin wt), up to the radius's
  // lever.
  const double w = 0.5;
  SceneBuilder builder;
  builder.gravity(kG).paddle("seesaw", boxShape({2, 0.3, 0.02}), at({0, 0, 0}));
  World world = builder.ball({0, 0, 0.01 + kR}).world();
  const double tick = 1e-3;
  world.command(0, velocityCommand({0, 0, 0}, {0, w, 0}));
  const int ticks = 400;
  run(world, tick, ticks);
  // Truth: the same equation with the drive's ramp in the first tick, by a fine Runge-Kutta of its own, with the lever
  // h = half thickness + r of the centre: x'' = w^2 x + g sin(angle) - h w'.
  const double h = 0.01 + kR;
  double x = 0.0, u = 0.0;
  const auto angle = [&](double t) { return t < tick ? 0.5 * w / tick * t * t : w * (t - 0.5 * tick); };
  const auto rate = [&](double t) { return t < tick ? w / tick * t : w; };
  const double step = tick / 50.0;
  for (int i = 0; i < 50 * ticks; ++i)
  {
    const double t = step * i;
    const double jerk = t + 0.5 * step < tick ? w / tick : 0.0;
    const auto slope = [&](double s, double at_x)
    { return rate(s) * rate(s) * at_x + kG * std::sin(angle(s)) - h * jerk; };
    const double k1 = slope(t, x), k2 = slope(t + step / 2, x + step / 2 * u);
    const double k3 = slope(t + step / 2, x + step / 2 * u + step * step / 4 * k1);
    const double k4 = slope(t + step, x + step * u + step * step / 2 * k2);
    x += step * u + step * step / 6.0 * (k1 + k2 + k3);
    u += step / 6.0 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  const double turned = angle(ticks * tick);
  const Vector3d expected(x * std::cos(turned) + h * std::sin(turned), 0, -x * std::sin(turned) + h * std::cos(turned));
  measured("ball on a turning seesaw, position error after 0.4 s [m]", (positionOf(world) - expected).norm());
  EXPECT_LE((positionOf(world) - expected).norm(),
            1e-13);  // 400 ticks, a rounding each: the pieces of its path are of high order
}
}  // namespace
}  // namespace ping_pong
