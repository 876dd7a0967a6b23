// Overlap from outside and no room left: refused, pushed out without speed, reported.
#include <gtest/gtest.h>

#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
SceneBuilder table(double e = 0.8)
{
  SceneBuilder builder;
  builder.gravity(kG).restitution(e).box("table", {2, 2, 0.1}, at({0, 0, -0.05}));
  return builder;
}

BallState atRest(const Vector3d& p)
{
  BallState state;
  state.p_WB = p;
  return state;
}

TEST(Squeeze, ABallIsNotSpawnedInsideATableOrABall)
{
  World world = table().ball({0, 0, kR}).world();
  const Refusal table_refusal = world.spawnBall({}, atRest({0.5, 0, 0.005}));  // 15 mm deep
  EXPECT_NE(table_refusal.reason.find("table"), std::string::npos) << table_refusal.reason;
  EXPECT_NE(table_refusal.reason.find("15 mm"), std::string::npos) << table_refusal.reason;
  const Refusal ball_refusal = world.spawnBall({}, atRest({0.03, 0, kR}));
  EXPECT_NE(ball_refusal.reason.find("ball_0"), std::string::npos) << ball_refusal.reason;
  EXPECT_TRUE(world.setBallState(0, atRest({0, 0, 0.0})));
  EXPECT_EQ(world.ballCount(), 1u);
  EXPECT_EQ(positionOf(world), Vector3d(0, 0, kR));
  EXPECT_FALSE(world.spawnBall({}, atRest({0.04, 0, kR}))) << "touching is no overlap";
}

TEST(Squeeze, ABodySetOntoABallPushesItOutWithoutSpeed)
{
  World world = table().ball({0.3, 0, kR}).world();
  world.advance(0.1);
  for (const double up : {0.003, 0.02, 0.05})
  {
    ASSERT_FALSE(world.setBodyPose(0, at({0, 0, -0.05 + up})));
    EXPECT_NEAR(positionOf(world).z(), up + kR, 1e-9);
    EXPECT_EQ(velocityOf(world), Vector3d::Zero());
    for (int i = 0; i < 100; ++i)
    {
      EXPECT_TRUE(world.advance(1e-3).ok());
      EXPECT_LE(velocityOf(world).norm(), 1e-9);  // depth / dt would be 3 to 30 m/s
    }
  }
}

TEST(Squeeze, ABallInsideATableAtTheStartIsNeitherShotOutNorAHang)  // scenes built in code are not checked by a loader
{
  for (const Method method : kMethods)
  {
    Scene scene = table().ball({0, 0, 0.005}).build();
    scene.method = method;
    World world(scene);
    double speed = 0.0;
    std::size_t events = 0;
    for (int i = 0; i < 200; ++i)
    {
      events += world.advance(1e-3).events;
      speed = std::max(speed, velocityOf(world).norm());
    }
    std::printf("[ measured ] %s\n", name(method));
    measured("15 mm deep at the start: greatest speed [m/s]", speed);
    measured("events", static_cast<double>(events));
    EXPECT_LE(speed, 1.6);  // the energy of the lift at most, not depth / dt = 15 m/s
    EXPECT_LE(events, 20000u);
  }
}

// A paddle presses a ball on the table until 28 mm are left of its 40, waits, and goes away.
struct Pressed
{
  bool reported = false;
  double speed = 0.0;
  double lowest = 1.0;
  double highest = 0.0;
  std::size_t events = 0;
};

Pressed press(World& world, double u)
{
  Pressed result;
  const auto ticks = [&](int count)
  {
    for (int i = 0; i < count; ++i)
    {
      const StepStatus status = world.advance(1e-3);
      result.reported |= status.squeezed > 0;
      EXPECT_FALSE(status.event_limit);
      result.events += status.events;
      result.speed = std::max(result.speed, velocityOf(world).norm());
      result.lowest = std::min(result.lowest, positionOf(world).z());
      result.highest = std::max(result.highest, positionOf(world).z());
    }
  };
  world.command(1, velocityCommand({0, 0, -u}));
  ticks(static_cast<int>(std::lround(0.032 / u / 1e-3)));  // from 60 mm to 28 mm above the table
  world.command(1, PaddleCommand());
  ticks(100);
  EXPECT_NEAR(world.bodyPose(1).p.z() - 0.005, 0.028, u * 1.1e-3);
  return result;
}

SceneBuilder underThePaddle(double e)
{
  SceneBuilder builder = table(e);
  builder.paddle("paddle", boxShape({0.2, 0.2, 0.01}), at({0, 0, 0.065}));
  return builder;
}

TEST(Squeeze, ABallPressedOnTheTableIsReportedAndLetGoAtRest)
{
  for (const double e : {0.0, 0.5, 0.9, 1.0})
    for (const double u : {0.1, 1.0, 10.0})
    {
      World world = underThePaddle(e).ball({0, 0, kR}).world();
      const Pressed pressed = press(world, u);
      EXPECT_TRUE(pressed.reported) << e << " " << u;
      EXPECT_EQ(velocityOf(world), Vector3d::Zero());
      EXPECT_TRUE(std::isfinite(pressed.speed));
      EXPECT_LE(pressed.events, 20000u);
      EXPECT_GE(pressed.lowest, kR - 1e-9);
      EXPECT_LE(pressed.highest, 0.041);
      world.command(1, velocityCommand({0, 0, 0.5}));
      run(world, 1e-3, 100);
      EXPECT_TRUE(world.advance(1e-3).ok());
      EXPECT_LE(velocityOf(world).norm(), 1e-6) << "it is let go at rest";
      EXPECT_NEAR(positionOf(world).z(), kR, 1e-4);
      if (e == 0.9)
        std::printf("[ measured ] pressed at %g m/s: fastest %.3g m/s, %zu events\n", u, pressed.speed, pressed.events);
    }
}

// Between two paddles in mid-air: nothing but them holds it.
TEST(Squeeze, ACaughtBallStaysThereThoughAnotherBodyIsPutElsewhere)
{
  SceneBuilder builder;
  builder.gravity(kG).restitution(0.5).box("far", {1, 1, 1}, at({5, 5, 5})).ball({0, 0, 0});
  for (const double side : {-1.0, 1.0})
    builder.paddle(side < 0.0 ? "right" : "left", boxShape({0.2, 0.02, 0.2}), at({0, 0.04 * side, 0}));
  World world = builder.world();
  world.command(1, velocityCommand({0, 1, 0}));
  world.command(2, velocityCommand({0, -1, 0}));
  ASSERT_EQ(world.advance(0.015).squeezed, 1u);
  for (const std::size_t paddle : {1, 2}) world.command(paddle, PaddleCommand());
  world.advance(0.01);
  const Vector3d caught = positionOf(world);
  ASSERT_FALSE(world.setBodyPose(0, at({5, 5, -5})));
  EXPECT_EQ(world.advance(0.1).squeezed, 1u);
  EXPECT_EQ(positionOf(world), caught);
  EXPECT_EQ(velocityOf(world), Vector3d::Zero());
}

// A paddle tilted by `angle` comes down on a ball that lies on the table: a wedge. Without friction the ball squirts
// out. With e = 0 it keeps touching both: n.(v - u) = 0 with n = (sin, 0, -cos) and v along x gives v = u / tan(angle).
double squirt(double e, double angle, double u, bool& ok)
{
  SceneBuilder builder;
  builder.gravity(kG).restitution(e).box("table", {4, 4, 0.1}, at({0, 0, -0.05}));
  builder.paddle("paddle", boxShape({0.08, 0.2, 0.01}), at({0, 0, 0.08}, angle, Vector3d::UnitY()));
  World world = builder.ball({0, 0, kR}).world();
  world.command(1, velocityCommand({0, 0, -u}));
  double speed = 0.0;
  for (int i = 0; i < 400 && std::abs(positionOf(world).x()) < 0.3; ++i)
  {
    if (world.bodyPose(1).p.z() < 0.036) world.command(1, PaddleCommand());
    ok &= world.advance(1e-3).ok();
    speed = std::max(speed, velocityOf(world).norm());
  }
  return speed;
}

// Seen from a frame that moves along with u / tan both surfaces stand still, so the ball gains no speed there: at most
// 2 u / tan here. It has to keep ahead of the wedge: at least u / tan. One percent for gravity.
void expectSquirt(const std::vector<double>& restitutions)
{
  for (const double angle : {0.15, 0.3, -0.3, 0.6})
    for (const double u : {0.2, 1.0})
      for (const double e : restitutions)
      {
        const double wedge = u / std::tan(std::abs(angle));
        bool ok = true;
        const double speed = squirt(e, angle, u, ok) / wedge;
        std::printf("[ measured ] wedge of %g rad, %g m/s, e = %g: %.3g u / tan\n", angle, u, e, speed);
        EXPECT_TRUE(ok) << "there is a way out: nothing is squeezed";
        EXPECT_GE(speed, 0.99);
        EXPECT_LE(speed, e == 0.0 ? 1.01 : 2.01);
      }
}

TEST(Squeeze, ATiltedPaddleSquirtsALivelyBallOutWithBoundedSpeed)
{
  expectSquirt({0.9, 1.0});
}

TEST(Squeeze, ATiltedPaddlePushesADullBallOutAheadOfTheWedge)
{
  expectSquirt({0.0, 0.3, 0.5});
}
}  // namespace
}  // namespace ping_pong
