// A ball dropped on a floor: energy, phase, apex heights, time to rest, rest.
#include <gtest/gtest.h>

#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
constexpr double kDrop = 0.3;  // [m]

SceneBuilder dropped(Method method, double dt, double e, double height = kDrop)
{
  SceneBuilder builder(method, dt);
  builder.gravity(kG).restitution(e).floor().ball({0, 0, kR + height});
  return builder;
}

// Energy per mass above rest on the floor, as a part of what it was.
double energyLeft(const World& world, double height = kDrop)
{
  const BallState ball = world.ballState(0);
  return (0.5 * ball.v_WB.squaredNorm() + kG * (ball.p_WB.z() - kR)) / (kG * height);
}

double energyAfterTenSeconds(Method method, double dt)
{
  World world = dropped(method, dt, 1.0).world();
  run(world, dt, static_cast<int>(std::lround(10.0 / dt)));
  return energyLeft(world);
}

// Height above rest of an elastic ball: time folded into one period.
double elasticHeight(double t)
{
  const long double fall = std::sqrt(2.0L * static_cast<long double>(kDrop) / static_cast<long double>(kG));
  long double phase = std::fmod(static_cast<long double>(t) + fall, 2.0L * fall) - fall;  // from apex to apex
  return static_cast<double>(kDrop - 0.5L * kG * phase * phase);
}

double timeToRest(double e)
{
  return std::sqrt(2.0 * kDrop / kG) * (1.0 + e) / (1.0 - e);
}

TEST(Bouncing, ThousandElasticBouncesKeepEnergyAndPhase)
{
  World world = dropped(Method::Exact, 1e-3, 1.0).world();
  double energy = 0.0;
  double phase = 0.0;
  std::size_t bounces = 0;
  for (int i = 1; bounces < 1000; ++i)
  {
    bounces += world.advance(0.01).contacts;
    energy = std::max(energy, std::abs(energyLeft(world) - 1.0));
    phase = std::max(phase, std::abs(positionOf(world).z() - kR - elasticHeight(0.01 * i)));
  }
  measured("1000 bounces, relative energy error", energy);
  measured("1000 bounces, position error [m]", phase);
  EXPECT_LE(energy, 1e-12);
  EXPECT_LE(phase, 1e-9);
}

TEST(Bouncing, ExplicitEulerGainsEnergy)
{
  const double fine = energyAfterTenSeconds(Method::EulerExplicit, 1e-3);
  const double middle = energyAfterTenSeconds(Method::EulerExplicit, 1.0 / 240.0);
  const double coarse = energyAfterTenSeconds(Method::EulerExplicit, 1.0 / 60.0);
  measured("explicit, E/E0 after 10 s at 1 ms", fine);
  measured("at 1/240 s", middle);
  measured("at 1/60 s", coarse);
  EXPECT_GT(fine, 1.1);
  EXPECT_GT(middle, 1.5);
  EXPECT_GT(coarse, 3.0);
  EXPECT_NEAR(energyAfterTenSeconds(Method::Exact, 1.0 / 60.0), 1.0, 1e-13);
}

TEST(Bouncing, SemiImplicitEulerLooksFineAndIsNot)
{
  const double fine = energyAfterTenSeconds(Method::EulerSemiImplicit, 1e-3);
  const double middle = energyAfterTenSeconds(Method::EulerSemiImplicit, 1.0 / 240.0);
  const double coarse = energyAfterTenSeconds(Method::EulerSemiImplicit, 1.0 / 60.0);
  measured("semi-implicit, E/E0 after 10 s at 1 ms", fine);
  measured("at 1/240 s", middle);
  measured("at 1/60 s", coarse);
  EXPECT_GT(std::abs(fine - 1.0), 1e-3);
  EXPECT_GT(std::abs(middle - 1.0), 1e-2);
  EXPECT_GT(std::abs(coarse - 1.0), 1e-2);
}

TEST(Bouncing, EveryApexIsESquaredTimesTheLastDownToAPicometre)
{
  for (const double e : {0.5, 0.9, 0.95})
  {
    World world = dropped(Method::Exact, 1e-3, e).world();
    const std::vector<Contact> bounces = run(world, 0.1, static_cast<int>(10.0 * timeToRest(e)) + 10);
    double apex = kDrop;
    for (const Contact& bounce : bounces)
    {
      apex *= e * e;
      const double v = bounce.v_after.z();
      // The time of a bounce is rounded: 1e-16 s, a height of 1e-16 m that apexes of 1e-12 m still notice.
      ASSERT_NEAR(v * v / (2.0 * kG), apex, 1e-12 * apex + 2e-16) << "e " << e;
    }
    EXPECT_LT(apex, 1e-12) << "the last reported bounce is microscopic";
    EXPECT_GT(apex, 1e-13);
  }
}

TEST(Bouncing, RestComesAtTheMomentOfTheGeometricSeries)
{
  double worst = 0.0;
  for (const double e : {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 0.95, 0.99})
  {
    World world = dropped(Method::Exact, 1e-3, e).world();
    world.advance(timeToRest(e) - 1e-6);
    EXPECT_FALSE(world.resting(0)) << e;
    world.advance(2e-6);
    EXPECT_TRUE(world.resting(0)) << e;
    worst = std::max(worst, std::abs(world.restingSince(0) - timeToRest(e)));
  }
  measured("time to rest, error [s]", worst);
  EXPECT_LE(worst, 1e-9);
}

TEST(Bouncing, AtRestMeansTheSameBitsForAMinute)
{
  World world = dropped(Method::Exact, 1e-3, 0.9).world();
  world.advance(5.0);
  const BallState rest = world.ballState(0);
  EXPECT_EQ(rest.p_WB, Vector3d(0, 0, kR));
  EXPECT_EQ(rest.v_WB, Vector3d::Zero());
  for (int i = 0; i < 60000; ++i)
  {
    const StepStatus status = world.advance(1e-3);
    ASSERT_EQ(status.events, 0u);
    ASSERT_EQ(world.ballState(0).p_WB, rest.p_WB);
    ASSERT_EQ(world.ballState(0).v_WB, rest.v_WB);
  }
}

TEST(Bouncing, EulerNeverComesToRest)
{
  for (const Method method : {Method::EulerExplicit, Method::EulerSemiImplicit})
  {
    World world = dropped(method, 1e-3, 0.9).world();
    const std::size_t bounces = run(world, 1e-3, 8000).size();
    double speed = 0.0;
    for (int i = 0; i < 1000; ++i)
    {
      world.advance(1e-3);
      speed = std::max(speed, velocityOf(world).norm());
    }
    std::printf("[ measured ] %s, e = 0.9, 1 ms\n", name(method));
    measured("bounces in 8 s", static_cast<double>(bounces));
    measured("speed that stays [m/s]", speed);
    EXPECT_GT(speed, 1e-3);  // 3719 hops of 1 ms (semi-implicit), hops of 0.15 m/s (explicit); exact: none at all
    EXPECT_FALSE(world.resting(0));
  }
}

TEST(Bouncing, FiniteWorkForInfinitelyManyBounces)
{
  World world = dropped(Method::Exact, 1e-3, 0.9).world();
  const StepStatus status = world.advance(8.0);
  measured("e = 0.9, bounces from 0.30 m to 1e-12 m", static_cast<double>(status.contacts));
  // ln(1e-12 / 0.3) / ln(0.81) = 125.3 bounces are higher than a picometre.
  EXPECT_NEAR(static_cast<double>(status.contacts), 125.3, 1.5);
  EXPECT_LE(status.events, status.contacts + 10);
}

TEST(Bouncing, EachPairOfMaterialsHasItsOwnRestitution)
{
  SceneBuilder builder;
  builder.gravity(kG).restitution(0.8).restitution("ball", "rubber", 0.5).restitution("lead", "rubber", 0.1);
  builder.box("wood", {1, 1, 0.1}, at({0, 0, -0.05})).box("mat", {1, 1, 0.1}, at({2, 0, -0.05}), "rubber");
  builder.ball({0, 0, kR + kDrop}).ball({2, 0, kR + kDrop}).ball({2.2, 0, kR + kDrop}, {0, 0, 0}, 0.1, kR, "lead");
  for (const Method method : kMethods)
  {
    Scene scene = builder.build();
    scene.method = method;
    World world(scene);
    const std::vector<Contact> bounces = run(world, 1e-3, 260);  // one bounce of each
    ASSERT_EQ(bounces.size(), 3u);
    const double expected[] = {0.8, 0.5, 0.1};
    for (const Contact& bounce : bounces)
      EXPECT_NEAR(-bounce.v_after.z() / bounce.v_before.z(), expected[bounce.ball], 1e-15);
  }
}

TEST(Bouncing, TheSizeOfTicksDoesNotMatter)
{
  std::vector<Contact> reference;
  for (const double tick : {4.0, 1.0, 0.04, 1e-3})
  {
    World world = dropped(Method::Exact, 1e-3, 0.9).world();
    const std::vector<Contact> bounces = run(world, tick, static_cast<int>(std::lround(4.0 / tick)));
    if (reference.empty()) reference = bounces;
    ASSERT_EQ(bounces.size(), reference.size());
    for (std::size_t i = 0; i < bounces.size(); ++i)
    {
      EXPECT_EQ(bounces[i].time, reference[i].time);
      EXPECT_EQ(bounces[i].v_after, reference[i].v_after);
    }
    EXPECT_EQ(world.time(), 4.0);
  }
}

TEST(Bouncing, GravityDoesNotKickInsideABounce)  // row 13: elastic balls that rise higher every time, from 10 m
{
  World world = dropped(Method::Exact, 1e-3, 1.0, 10.0).world();
  double worst = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    world.advance(1.0 / 60.0);
    worst = std::max(worst, std::abs(energyLeft(world, 10.0) - 1.0));
  }
  EXPECT_LE(worst, 1e-14);  // 6 bounces of one rounding each
}
}  // namespace
}  // namespace ping_pong
