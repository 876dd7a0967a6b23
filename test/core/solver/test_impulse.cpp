// Method `impulse`: piles that stand, slide, sleep and wake up; what a single ball loses by its steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "ping_pong_sim/state_hash.h"
#include "testing/overlaps.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
Scene withFriction(Scene scene, double mu, double e, double rolling_resistance = 0.0)
{
  Surface law;
  law.spin_friction = law.rolling_resistance = rolling_resistance;
  law.restitution = e;
  law.friction = mu;
  for (MaterialId a = 0; a < scene.materials.size(); ++a)
    for (MaterialId b = 0; b < scene.materials.size(); ++b) scene.surfaces.set(a, b, law);
  return scene;
}

SceneBuilder tray(double half, double height, double dt)
{
  SceneBuilder builder(Method::Impulse, dt);
  builder.gravity(kG).box("bottom", {2 * half + 0.2, 2 * half + 0.2, 0.1}, at({0, 0, -0.05}));
  for (const double side : {-1.0, 1.0})
  {
    builder.box("wall_x", {0.02, 2 * half + 0.04, height}, at({side * (half + 0.01), 0, 0.5 * height}));
    builder.box("wall_y", {2 * half + 0.04, 0.02, height}, at({0, side * (half + 0.01), 0.5 * height}));
  }
  return builder;
}

std::size_t asleep(const World& world)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < world.ballCount(); ++i) count += world.resting(i);
  return count;
}

std::vector<Vector3d> placesOf(const World& world)
{
  std::vector<Vector3d> places;
  for (std::size_t i = 0; i < world.ballCount(); ++i) places.push_back(positionOf(world, i));
  return places;
}

// A tube just wide enough for one ball, and five of them let fall into it.
TEST(Impulse, AStackOfFiveInATubeStandsWhereTheBallsSayItHasTo)
{
  SceneBuilder builder = tray(kR + 1e-4, 0.5, 1e-3);
  for (int i = 0; i < 5; ++i) builder.ball({0, 0, kR + 0.045 * i});
  World world(withFriction(builder.build(), 0.0, 0.8));
  double deepest = 0.0;
  for (int i = 0; i < 300; ++i)
  {
    world.advance(0.01);
    deepest = std::max(deepest, deepestInTray(world, kR + 1e-4));
  }
  measured("stack of five: deepest overlap [m]", deepest);
  measured("height of the top, from the closed form [m]", positionOf(world, 4).z() - 9.0 * kR);
  EXPECT_EQ(asleep(world), 5u);
  EXPECT_LE(deepest, 1e-4);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(positionOf(world, i).z(), kR + 2.0 * kR * static_cast<double>(i),
                2e-5 * (1.0 + static_cast<double>(i)));
}

// Four balls in a square that friction holds, and one on top of them: its height is 2 r / sqrt(2) above them.
TEST(Impulse, APyramidStandsByFriction)
{
  SceneBuilder builder(Method::Impulse, 1e-3);
  builder.gravity(kG).floor();
  for (const double x : {-kR, kR})
    for (const double y : {-kR, kR}) builder.ball({x, y, kR});
  builder.ball({0, 0, kR + std::sqrt(2.0) * kR + 1e-6});
  // Statics: each lower ball is pushed outwards by W/4 tan 45 deg; friction on both its contacts has to be at least tan(45/2).
  for (const double mu : {0.5, 0.3})
  {
    World world(withFriction(builder.build(), mu, 0.5));
    world.advance(2.0);
    const double fall = kR + std::sqrt(2.0) * kR - positionOf(world, 4).z();
    measured("friction", mu);
    measured("the top has come down by [m]", fall);
    if (mu > std::tan(kPi / 8.0))
      EXPECT_LE(fall, 1e-4);
    else
      EXPECT_GE(fall, 0.5 * kR);
  }
}

TEST(Impulse, OnASlopeABallRollsOrSlidesByTheClosedForm)
{
  constexpr double kSlope = 0.3, kEnd = 0.5;
  for (const double mu : {0.0, 0.05, 0.5})
  {
    SceneBuilder builder(Method::Impulse, 1e-3);
    const Vector3d g = kG * Vector3d(std::sin(kSlope), 0, -std::cos(kSlope));
    builder.gravity(g).floor().ball({0, 0, kR});
    World world(withFriction(builder.build(), mu, 0.0));
    world.advance(kEnd);
    // Thin shell: rolls with 3/5 of the pull while 2/5 of it is no more than friction gives.
    const double pull = kG * std::sin(kSlope), load = kG * std::cos(kSlope);
    const double a = 0.4 * pull <= mu * load ? 0.6 * pull : pull - mu * load;
    EXPECT_NEAR(velocityOf(world).x(), a * kEnd, 1e-3 * pull * kEnd + 1e-3 * pull);  // a step more or less
    EXPECT_NEAR(positionOf(world).z(), kR, 1e-5);
  }
}

// It resists what rolls, not what presses: neither impacts nor the way to rest feel it.
TEST(Impulse, RollingResistanceIsNothingToABallThatComesStraightDown)
{
  for (const double height : {0.0, 1e-5, 1e-3, 0.1})
  {
    Scene scene = SceneBuilder(Method::Impulse, 1e-3).gravity(kG).floor().ball({0, 0, kR + height}).build();
    World free(withFriction(scene, 0.3, 0.5)), resisted(withFriction(scene, 0.3, 0.5, 0.5));
    for (int tick = 0; tick < 1000; ++tick)
    {
      free.advance(1e-3);
      resisted.advance(1e-3);
      ASSERT_EQ(stateHash(resisted), stateHash(free)) << height << " m, tick " << tick;
    }
  }
}

TEST(Impulse, NoFastBallPassesAThinPlate)
{
  for (const double speed : {3.0, 30.0, 300.0})
    for (int shot = 0; shot < 50; ++shot)
    {
      SceneBuilder builder(Method::Impulse, 4e-3);
      builder.box("plate", {2, 2, 0.001}, at({0, 0, 0})).ball({0, 0, 0.5 + 0.0073 * shot}, {0, 0, -speed});
      World world = builder.world();
      world.advance(2.0 / speed);
      ASSERT_GT(positionOf(world).z(), 0.0) << speed << " " << shot;
      EXPECT_NEAR(velocityOf(world).z(), speed, 1e-12 * speed);
    }
}

TEST(Impulse, ABallThatBouncesAloneGoesAsTheExactMethodSays)
{
  for (const double e : {1.0, 0.8})
  {
    SceneBuilder builder;
    builder.gravity(kG).floor().ball({0, 0, 0.5}, {0.3, 0, 0});
    Scene scene = withFriction(builder.build(), 0.2, e);
    World exact(scene);
    scene.method = Method::Impulse;
    scene.dt = 4e-3;
    World world(scene);
    exact.advance(1.3);
    world.advance(1.3);
    EXPECT_LE((positionOf(world) - positionOf(exact)).norm(), 1e-12);
    EXPECT_LE((velocityOf(world) - velocityOf(exact)).norm(), 1e-11);
    EXPECT_LE((world.ballState(0).w_WB - exact.ballState(0).w_WB).norm(), 1e-9);
  }
}

// Slides with mu g until it rolls: what the steps miss shrinks with them.
TEST(Impulse, AirActsFromTheFirstStepOn)
{
  const double step = 1e-3;  // [s]
  const auto afterOneStep = [step](Method method)
  {
    Scene scene = SceneBuilder(method, step).ball({0, 0, 1}, {20, 0, 0}).build();
    scene.forces.drag = true;
    World world(scene);
    world.advance(step);
    return velocityOf(world).x();
  };
  const double slower = 20.0 - afterOneStep(Method::Exact);
  EXPECT_GT(slower, 0.01);
  EXPECT_NEAR(20.0 - afterOneStep(Method::Impulse), slower,
              1e-4 * slower);  // third order: (step / time scale)^2 = 3e-6 of it
}

TEST(Impulse, SlidingToRollingConvergesWithTheStep)
{
  for (const double dt : {8e-3, 4e-3, 2e-3, 1e-3, 5e-4})
  {
    SceneBuilder builder(Method::Impulse, dt);
    builder.gravity(kG).floor().ball({0, 0, kR}, {1.0, 0, 0});
    World world(withFriction(builder.build(), 0.2, 0.0));
    world.advance(0.8);
    const double T = 0.4 / (0.2 * kG);  // until 2/5 of the speed is gone
    const double truth = T - 0.5 * 0.2 * kG * T * T + 0.6 * (0.8 - T);
    const double error = std::abs(positionOf(world).x() - truth);
    std::printf("[ measured ] step %g s: place wrong by %.3g m, speed by %.3g m/s\n", dt, error,
                std::abs(velocityOf(world).x() - 0.6));
    EXPECT_NEAR(velocityOf(world).x(), 0.6, 1e-6);
    EXPECT_LE(error, 0.15 * 0.2 * kG * dt);  // of first order: the load on a surface comes half a step late
  }
}

/// Ten layers of balls, let fall into a tray as wide as their grid.
struct Pour
{
  int row = 10;      // 10 row^2 balls
  double dt = 1e-3;  // [s]
  double half = 0.0225 * row;
  Scene scene() const
  {
    SceneBuilder builder = tray(half, 1.5, dt);
    for (int i = 0; i < 10 * row * row; ++i)
    {
      const double x = i % row - 0.5 * (row - 1), y = i / row % row - 0.5 * (row - 1);
      builder.ball({0.045 * x, 0.045 * y, 0.1 + 0.045 * (i / (row * row))}, {std::sin(1.0 * i), std::cos(2.0 * i), 0});
    }
    // Without resistance a ball on the ground spins about its vertical, or rolls in a gap, for ever.
    return withFriction(builder.build(), 0.3, 0.8, 0.01);
  }
};

std::size_t outside(const World& world, double half)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < world.ballCount(); ++i)
  {
    const Vector3d p = positionOf(world, i);
    count += !(p.z() > 0.0 && std::max(std::abs(p.x()), std::abs(p.y())) < half);
  }
  return count;
}

// Restitution 0.8 takes 36 % of the energy of each impact: after a fall from half a metre (0.35 s) the bounces of one ball
// would take 0.35 s 2 e/(1 - e) = 2.8 s more, and it falls asleep 0.25 s later; in a crowd it is sooner.
TEST(Impulse, BallsComeToRestInATrayAndStayThere)
{
  for (const Pour& pour : {Pour{7, 1e-3}, Pour{6, 2e-3}, Pour{6, 2.5e-3}})
  {
    World world(pour.scene());
    double deepest = 0.0, energy = world.totals().energy(), gained = 0.0;
    const double start = energy;
    for (int i = 0; i < 108; ++i)  // 3.4 s
    {
      world.advance(1.0 / 32.0);
      if (i % 4 == 3) deepest = std::max(deepest, deepestInTray(world, pour.half));
      const double now = world.totals().energy();
      gained = std::max(gained, now - energy);
      energy = now;
    }
    std::printf(
        "[ measured ] %zu balls, steps of %.3g ms: deepest overlap %.3g mm, asleep %zu, gain of energy in 1/32 s "
        "%.2g\n",
        world.ballCount(), 1e3 * pour.dt, 1e3 * deepest, asleep(world), gained / start);
    EXPECT_LE(deepest, 1e-3);
    EXPECT_LE(gained, 1e-5 * start);  // overlap that is taken out lifts balls by what they had sunk
    EXPECT_EQ(outside(world, pour.half), 0u);
    ASSERT_EQ(asleep(world), world.ballCount());
    const std::uint64_t rest = stateHash(world);
    const std::vector<Vector3d> places = placesOf(world);
    world.advance(10.0);
    EXPECT_EQ(placesOf(world), places);
    EXPECT_EQ(world.totals().kinetic, 0.0);
    World again(pour.scene());
    for (int i = 0; i < 108; ++i) again.advance(1.0 / 32.0);
    EXPECT_EQ(stateHash(again), rest);
  }
}

// A slow ball is not on its way into the floor, until a fast one throws it there within the same step: at 1 m/s it would be
// 2.5 mm deep. What the iteration leaves when it is cut short is a fifth of that.
TEST(Impulse, TheFloorCatchesWhomOthersThrowAtIt)
{
  const Pour pour{10, 2.5e-3};
  World world(pour.scene());
  double deepest = 0.0;
  for (int i = 0; i < 160; ++i)  // the lowest layer is on the floor after 0.15 s, the highest after 0.3 s
  {
    world.advance(pour.dt);
    for (std::size_t k = 0; k < world.ballCount(); ++k) deepest = std::max(deepest, kR - positionOf(world, k).z());
  }
  measured("1000 balls, steps of 2.5 ms: deepest in the floor [m]", deepest);
  EXPECT_LE(deepest, 5e-4);
}

// --- sleep ---

World threeAsleep()
{
  SceneBuilder builder = tray(kR + 1e-4, 0.5, 1e-3);
  for (int i = 0; i < 3; ++i) builder.ball({0, 0, kR + 2.0 * kR * i});
  World world(withFriction(builder.build(), 0.0, 0.5));
  world.advance(1.0);
  EXPECT_EQ(asleep(world), 3u);
  return world;
}

TEST(ImpulseSleep, ABallThatFallsOnAStackWakesItUp)
{
  World world = threeAsleep();
  BallState state;
  state.p_WB = Vector3d(0, 0, 0.3);
  ASSERT_FALSE(world.spawnBall(world.ballParams(0), state));
  world.advance(0.1);
  EXPECT_EQ(asleep(world), 3u);  // it is still in the air
  world.advance(0.1);
  EXPECT_LT(asleep(world), 3u);
  world.advance(3.0);
  EXPECT_EQ(asleep(world), 4u);
  EXPECT_NEAR(positionOf(world, 3).z(), 7.0 * kR, 1e-4);
}

TEST(ImpulseSleep, WithoutTheBallBelowTheOthersFall)
{
  World world = threeAsleep();
  ASSERT_FALSE(world.deleteBall(world.ballId(0)));
  world.advance(2.0);
  EXPECT_NEAR(positionOf(world, 0).z(), kR, 1e-4);
  EXPECT_NEAR(positionOf(world, 1).z(), 3.0 * kR, 1e-4);
}

TEST(ImpulseSleep, WithoutTheGroundTheyFall)
{
  World world = threeAsleep();
  ASSERT_FALSE(world.setBodyPose(world.findBody("bottom"), at({0, 0, -1.05})));
  world.advance(0.3);
  EXPECT_NEAR(positionOf(world, 0).z(), kR - 0.5 * kG * 0.09, 1e-3);
}

TEST(ImpulseSleep, APaddleWakesABallUpAndThrowsIt)
{
  SceneBuilder builder(Method::Impulse, 1e-3);
  builder.gravity(kG).paddle("paddle", boxShape({0.3, 0.3, 0.01}), at({0, 0, -0.005})).ball({0, 0, kR});
  World world(withFriction(builder.build(), 0.0, 0.5));
  world.advance(1.0);
  ASSERT_EQ(asleep(world), 1u);
  PaddleCommand command;
  command.mode = PaddleCommand::Mode::Velocity;
  command.twist.v = Vector3d(0, 0, 2.0);
  ASSERT_FALSE(world.command(0, command));
  world.advance(0.005);
  world.advance(0.05);
  EXPECT_EQ(asleep(world), 0u);
  EXPECT_GE(positionOf(world).z() - world.bodyPose(0).p.z(), 0.005 + kR - 1e-4);
}
}  // namespace
}  // namespace ping_pong
