// The exact method hands crowds that would never end to the contact solver, and takes them back.
#include <gtest/gtest.h>

#include <algorithm>

#include "testing/overlaps.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
constexpr double kHalf = 5 * 0.0225;

Scene smooth(Scene scene, double e, double mu)
{
  Surface law;
  law.restitution = e;
  law.friction = mu;
  law.spin_friction = law.rolling_resistance = 0.02 * mu;  // or one ball may roll or spin for ever
  for (MaterialId a = 0; a < scene.materials.size(); ++a)
    for (MaterialId b = 0; b < scene.materials.size(); ++b) scene.surfaces.set(a, b, law);
  return scene;
}

Scene pour(Method method, int balls, double e = 0.8, double mu = 0.3)
{
  SceneBuilder builder(method, 1e-3);
  builder.gravity(kG).floor();
  for (const double side : {-1.0, 1.0})
  {
    builder.box(side < 0 ? "left" : "right", {0.02, 1, 1.5}, at({side * (kHalf + 0.01), 0, 0.75}));
    builder.box(side < 0 ? "front" : "back", {1, 0.02, 1.5}, at({0, side * (kHalf + 0.01), 0.75}));
  }
  for (int i = 0; i < balls; ++i)
    builder.ball({0.045 * (i % 5 - 2), 0.045 * (i / 5 % 5 - 2), 0.1 + 0.045 * (i / 25)},
                 {0.3 * std::sin(1.0 * i), 0.3 * std::cos(2.0 * i), 0});
  return smooth(builder.build(), e, mu);
}

double height(const World& world)  // of the centre of mass
{
  double sum = 0.0;
  for (std::size_t i = 0; i < world.ballCount(); ++i) sum += positionOf(world, i).z();
  return sum / static_cast<double>(world.ballCount());
}

TEST(HandOver, APourGoesFromTheFirstBounceToRestWithoutAnyoneChoosing)
{
  Scene scene = pour(Method::Auto, 100);
  World world(scene);
  double deepest = 0.0;
  std::size_t most = 0, at_start = world.advance(0.1).piled, resting = 0;
  for (int i = 0; i < 200 && resting < world.ballCount(); ++i)
  {
    const StepStatus status = world.advance(0.05);
    EXPECT_TRUE(status.ok());
    most = std::max(most, status.piled);
    deepest = std::max(deepest, deepestInTray(world, kHalf));
    resting = 0;
    for (std::size_t k = 0; k < world.ballCount(); ++k) resting += world.resting(k);
  }
  measured("poured 100: deepest overlap [m]", deepest);
  measured("at rest after [s]", world.time());
  EXPECT_EQ(at_start, 0u);
  EXPECT_EQ(most, 100u);
  EXPECT_EQ(resting, world.ballCount());
  EXPECT_LE(deepest, 1e-3);

  // The same pour stepped from the start ends as high: what differs is where each ball came to lie.
  scene.method = Method::Impulse;
  World stepped(scene);
  stepped.advance(world.time());
  measured("height of the centre of mass, handed over [m]", height(world));
  measured("stepped from the start [m]", height(stepped));
  EXPECT_NEAR(height(world), height(stepped), 0.03 * height(world));
}

// While all others lie in the heap it is the only one in the grid of free balls, and the heap is beyond that.
TEST(HandOver, ABallFarAboveAHeapJoinsItWhenItArrives)
{
  for (const double settled : {0.6, 4.0})  // awake and asleep
  {
    World world(pour(Method::Auto, 100));
    const StepStatus at_first = world.advance(settled);
    ASSERT_EQ(at_first.piled, 100u);
    BallState above;
    above.p_WB = {0.01, 0.02, 1.3};
    ASSERT_FALSE(world.spawnBall(BallParams(), above));
    double highest = 0.0;
    for (std::size_t i = 0; i < 100; ++i) highest = std::max(highest, positionOf(world, i).z());
    bool joined = false;
    for (int tick = 0; tick < 100 && !joined; ++tick)
    {
      const double room = positionOf(world, 100).z() - highest - 2 * kR;
      joined = world.advance(5e-3).piled == 101;
      if (joined)  // no farther away than it comes in a tick, as fast as it gets
      {
        EXPECT_LE(room, 5e-3 * std::sqrt(2 * kG * 1.3) + 0.01) << "after " << settled << " s";
      }
    }
    EXPECT_TRUE(joined);
  }
}

TEST(HandOver, AGasThatMeetsSeldomIsNeverPassedOn)
{
  Scene scene = pour(Method::Exact, 100, 0.9);
  scene.forces.gravity.setZero();
  World world(scene);
  std::size_t hits = 0;
  for (int i = 0; i < 100; ++i)
  {
    const StepStatus status = world.advance(0.02);
    hits += status.contacts;
    EXPECT_EQ(status.piled, 0u);
  }
  EXPECT_GT(hits, 300u);
}

TEST(HandOver, MomentumStaysWhenBallsCrowdWithoutWalls)
{
  SceneBuilder builder(Method::Exact);
  for (int i = 0; i < 64; ++i)
  {
    const Vector3d p = 0.06 * Vector3d(i % 4 - 1.5, i / 4 % 4 - 1.5, i / 16 - 1.5);
    builder.ball(p + 0.003 * Vector3d(std::sin(i), std::cos(i), std::sin(2 * i)), -3.0 * p);
  }
  World world(smooth(builder.build(), 0.1, 0.0));
  const Totals before = world.totals();
  std::size_t most = 0;
  double energy = before.kinetic;
  for (int i = 0; i < 50; ++i)
  {
    most = std::max(most, world.advance(0.02).piled);
    EXPECT_LE(world.totals().kinetic, energy * (1.0 + 1e-12));
    energy = world.totals().kinetic;
  }
  const double scale = std::sqrt(2.0 * before.kinetic * 64 * kBallMass);
  measured("collapse of 64: piled", static_cast<double>(most));
  measured("relative change of momentum", (world.totals().momentum - before.momentum).norm() / scale);
  EXPECT_GT(most, 0u);
  EXPECT_LE((world.totals().momentum - before.momentum).norm() / scale, 1e-6);  // the solver's impulses have 24 bits
}

TEST(HandOver, BallsThatRollApartComeBack)
{
  World world(pour(Method::Exact, 50, 0.5, 0.0));
  std::size_t piled = 0;
  for (int i = 0; i < 30; ++i) piled = world.advance(0.1).piled;
  ASSERT_EQ(piled, 50u);
  for (const char* wall : {"left", "right", "front", "back"})
    ASSERT_FALSE(world.setBodyPose(world.findBody(wall), at({0, 0, -10})));
  for (int i = 0; i < 40; ++i) piled = world.advance(0.1).piled;
  measured("still piled, 4 s after the walls are gone", static_cast<double>(piled));
  EXPECT_LE(piled, 10u);  // some slide side by side
  for (std::size_t i = 0; i < world.ballCount(); ++i) EXPECT_NEAR(positionOf(world, i).z(), kR, 1e-5);
}

TEST(HandOver, TheSameBitsOnEveryRun)
{
  World first(pour(Method::Exact, 75)), second(pour(Method::Exact, 75));
  EXPECT_GT(first.advance(0.8).piled, 0u);
  second.advance(0.8);
  for (std::size_t i = 0; i < first.ballCount(); ++i) EXPECT_EQ(positionOf(first, i), positionOf(second, i));
}
}  // namespace
}  // namespace ping_pong
