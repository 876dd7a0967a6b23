// Fast balls and thin plates, moving and turning paddles.
#include <gtest/gtest.h>

#include <functional>

#include "stability/situations.h"

namespace ping_pong
{
namespace
{
using namespace stability;

constexpr int kShots = 1000;

TEST(Tunnelling, SampledContactsMissAThinPlate)
{
  // The ball is in touch for 2 r + 14 mm = 54 mm of its way; a sample every v h hits that with the odds 54 mm / v h.
  for (const Method method : {Method::EulerExplicit, Method::EulerSemiImplicit})
  {
    EXPECT_NEAR(shootAtPlate(method, 1.0 / 240.0, 0.014, 25.0, kShots).missed, 1.0 - 0.054 / (25.0 / 240.0),
                2e-3);                                                                                           // 48 %
    EXPECT_NEAR(shootAtPlate(method, 1.0 / 60.0, 0.014, 5.0, kShots).missed, 1.0 - 0.054 / (5.0 / 60.0), 2e-3);  // 35 %
  }
  for (const double speed : {5.0, 25.0})
  {
    const Shots exact = shootAtPlate(Method::Exact, 1.0 / 60.0, 0.014, speed, kShots);
    EXPECT_EQ(exact.missed, 0.0);
    EXPECT_EQ(exact.wrong_side, 0.0);
  }
  measured("semi-implicit, 14 mm, 25 m/s, 1/240 s: missed",
           shootAtPlate(Method::EulerSemiImplicit, 1 / 240.0, 0.014, 25, kShots).missed);
  measured("semi-implicit, 14 mm, 5 m/s, 1/60 s: missed",
           shootAtPlate(Method::EulerSemiImplicit, 1 / 60.0, 0.014, 5, kShots).missed);
}

TEST(Tunnelling, SampledContactsPushOutOnTheWrongSide)
{
  // 40 m/s, 1 ms: a sample every 40 mm, none missed; those past the middle of the plate, 13 of 40 mm, go out behind.
  const Shots euler = shootAtPlate(Method::EulerSemiImplicit, 1e-3, 0.014, 40.0, kShots);
  measured("semi-implicit, 14 mm, 40 m/s, 1 ms: pushed out behind", euler.wrong_side);
  EXPECT_EQ(euler.missed, 0.0);
  EXPECT_NEAR(euler.wrong_side, 13.0 / 40.0, 2e-3);
  const Shots exact = shootAtPlate(Method::Exact, 1e-3, 0.014, 40.0, kShots);
  EXPECT_EQ(exact.missed, 0.0);
  EXPECT_EQ(exact.wrong_side, 0.0);
}

TEST(Tunnelling, APlateOfAMicrometreReflectsTwoHundredMetresPerSecond)
{
  for (int i = 0; i < 200; ++i)
  {
    World world = shotAtPlate(Method::Exact, 1e-3, 1e-6, 200.0, i / 200.0, 0.8);
    const double start = positionOf(world).z();
    const std::vector<Contact> hits = run(world, 0.02, 1);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_NEAR(hits[0].time, (start - kR - 5e-7) / 200.0, 1e-17);  // a rounding or two
    EXPECT_NEAR(velocityOf(world).z(), 160.0, 1e-12);
  }
  const Shots euler = shootAtPlate(Method::EulerSemiImplicit, 1e-3, 1e-6, 200.0, kShots);
  measured("semi-implicit, 1 um, 200 m/s, 1 ms: missed or on the wrong side", euler.missed + euler.wrong_side);
  EXPECT_GT(euler.missed + euler.wrong_side, 0.85);  // 80 % missed, half of the rest pushed out behind
}

TEST(Tunnelling, ABallFliesBackFromAMovingPaddleWithMinusEVrelPlusU)
{
  for (const double u : {-10.0, 0.0, 3.0, 30.0, 100.0})
    for (const double e : {0.0, 0.7, 1.0})
    {
      World world = SceneBuilder()
                        .restitution(e)
                        .paddle("paddle", boxShape({0.006, 0.3, 0.3}), at({0, 0, 0}))
                        .ball({2, 0, 0}, {-40, 0, 0})
                        .world();
      world.command(0, velocityCommand({u, 0, 0}));
      world.advance(1e-3);  // the drive reaches u at the end of this tick
      const double face = world.bodyPose(0).p.x() + 0.003;
      const double expected = 1e-3 + (positionOf(world).x() - kR - face) / (40.0 + u);
      const std::vector<Contact> hits = run(world, 0.02, 4);
      ASSERT_EQ(hits.size(), 1u) << u;
      EXPECT_NEAR(hits[0].time, expected, 1e-16);
      EXPECT_NEAR(hits[0].v_after.x(), e * (40.0 + u) + u, 1e-13);
      EXPECT_NEAR(hits[0].v_other.x(), u, 1e-13);
    }
}

TEST(Tunnelling, SampledContactsMissAFastPaddle)
{
  int missed = 0;
  for (int i = 0; i < 100; ++i)
    for (const Method method : {Method::EulerSemiImplicit, Method::Exact})
    {
      World world = SceneBuilder(method, 5e-3)
                        .paddle("paddle", boxShape({0.006, 0.3, 0.3}), at({0, 0, 0}))
                        .ball({1.0 + 0.003 * i, 0, 0})
                        .world();
      world.command(0, velocityCommand({30, 0, 0}));
      const std::size_t hits = run(world, 5e-3, 20).size();
      if (method == Method::EulerSemiImplicit)
        missed += hits == 0;
      else
        EXPECT_EQ(hits, 1u);
    }
  measured("semi-implicit, paddle at 30 m/s, 5 ms: missed of 100", missed);
  EXPECT_GT(missed, 50);  // 150 mm a step against 46 mm of touch: 69 %
}

TEST(Tunnelling, AJumpOfAPaddleHitsNothing)
{
  World world = SceneBuilder().paddle("paddle", boxShape({0.006, 0.3, 0.3}), at({-1, 0, 0})).ball({0, 0, 0}).world();
  EXPECT_FALSE(world.setBodyPose(0, at({1, 0, 0})));
  EXPECT_EQ(run(world, 0.01, 10).size(), 0u);
  EXPECT_EQ(positionOf(world), Vector3d::Zero());
  EXPECT_EQ(world.bodyTwist(0).v, Vector3d::Zero());
}

// --- row 10: a blade that turns about an end of its own, edge-on to its way ---

constexpr double kLever = 0.15;  // distance of the ball from the axis [m]

// The drive needs the first tick to reach its speed: half a tick's angle is lost.
double angleOfBlade(double t, double tick)
{
  return kBladeTurn * (t - 0.5 * tick);
}

double bisected(const std::function<double(double)>& f, double above, double below)
{
  for (int i = 0; i < 200; ++i)
  {
    const double middle = 0.5 * (above + below);
    (f(middle) > 0.0 ? above : below) = middle;
  }
  return 0.5 * (above + below);
}

TEST(Tunnelling, ATurningBladeHitsAtTheRightInstantAndWithTheSpeedOfTheTouchedPoint)
{
  constexpr double kTick = 1.0 / 240.0;
  // Gap to the face of the blade, from the ball's place seen in the blade: (lever cos(pi/2 - angle), lever sin(...)).
  const auto gap = [](double t)
  { return kLever * std::sin(0.5 * kPi - angleOfBlade(t, kTick)) - 0.5 * kBladeThickness - kR; };
  const double truth = bisected(gap, kTick, kTick + 0.5 * kPi / kBladeTurn);
  EXPECT_NEAR(truth, 0.5 * kTick + (0.5 * kPi - std::asin((0.5 * kBladeThickness + kR) / kLever)) / kBladeTurn, 1e-16);

  World world = turningBlade(Method::Exact, kTick, kLever);
  const std::vector<Contact> hits = run(world, kTick, 12);
  ASSERT_EQ(hits.size(), 1u);
  measured("turning blade, error of the time of the hit [s]", hits[0].time - truth);
  EXPECT_NEAR(hits[0].time, truth, 1e-15);
  const double angle = angleOfBlade(truth, kTick);
  const Vector3d n(-std::sin(angle), std::cos(angle), 0);
  const double along = kLever * std::cos(0.5 * kPi - angle);  // lever arm of the touched point
  const Vector3d expected = (1.0 + kBladeRestitution) * kBladeTurn * along * n;
  EXPECT_LE((hits[0].n_W - n).norm(), 1e-13);
  EXPECT_LE((hits[0].v_after - expected).norm(), 1e-12);
}

// --- row 30: the surface's velocity has to be that of the instant of the hit ---

TEST(Tunnelling, AVibratingPaddleKeepsABallOnAnOrbitOfOnePeriod)
{
  const Orbit orbit = vibratingPaddle(Method::Exact, 1e-3);
  EXPECT_EQ(orbit.hits, 50u);
  EXPECT_LE(orbit.time, 1e-12);  // the orbit is stable: roundings do not add up
  EXPECT_LE(orbit.speed, 1e-12);
}

TEST(Tunnelling, AClosingWallAddsTwiceItsSpeedAtEveryHit)
{
  const Closing closing = closingWalls(Method::Exact, 1e-3);
  EXPECT_EQ(closing.hits, closing.expected);
  EXPECT_GT(closing.expected, 20u);
  EXPECT_LE(closing.speed, 1e-12);  // a rounding per hit
}
}  // namespace
}  // namespace ping_pong
