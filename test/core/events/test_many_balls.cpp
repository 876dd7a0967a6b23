// Balls against balls: closed forms, cradles, counting, momentum and energy.
#include <gtest/gtest.h>

#include <random>

#include "detect/first_contact.h"
#include "evolve/flight.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
SceneBuilder noGravity(double e = 1.0)
{
  SceneBuilder builder;
  builder.restitution(e);
  return builder;
}

TEST(BallBall, TwoBallsOfAnyMassesFollowTheClosedForm)
{
  for (const double ratio : {1e-9, 1e-3, 0.5, 1.0, 37.0, 1e6})
    for (const double e : {0.0, 0.4, 1.0})
    {
      const double m1 = kBallMass, m2 = ratio * kBallMass, v1 = 3.0, v2 = -2.0;
      World world = noGravity(e).ball({0, 0, 0}, {v1, 0, 0}, m1, 0.02).ball({1, 0, 0}, {v2, 0, 0}, m2, 0.05).world();
      const std::vector<Contact> hits = run(world, 0.1, 5);
      ASSERT_EQ(hits.size(), 1u);
      EXPECT_NEAR(hits[0].time, (1.0 - 0.07) / 5.0, 1e-16);
      const double centre = (m1 * v1 + m2 * v2) / (m1 + m2);  // velocity of the centre of mass
      // Without rebound they may part with the speed below which nothing counts as a hit, 1e-9 m/s; else roundings.
      const double slack = e == 0.0 ? 2e-9 : 1e-14;
      EXPECT_NEAR(velocityOf(world, 0).x(), centre - e * m2 / (m1 + m2) * (v1 - v2), slack) << ratio << " " << e;
      EXPECT_NEAR(velocityOf(world, 1).x(), centre + e * m1 / (m1 + m2) * (v1 - v2), slack) << ratio << " " << e;
    }
}

TEST(BallBall, AfterAHitWithoutReboundBothFallTogether)
{
  World world = noGravity(0.0).gravity(kG).ball({-0.1, 0, 2}, {1, 0, 0}).ball({0.1, 0, 2}, {-0.4, 0, 0}).world();
  run(world, 0.01, 50);  // they meet at 0.114 s
  EXPECT_NEAR(velocityOf(world, 0).x(), 0.3, 2e-9);
  EXPECT_NEAR(velocityOf(world, 1).x(), 0.3, 2e-9);
  EXPECT_NEAR((positionOf(world, 1) - positionOf(world, 0)).norm(), 2.0 * kR, 1e-9);
}

TEST(BallBall, AnObliqueHitTurnsOnlyTheVelocityAlongTheLineOfCentres)
{
  const double offset = 0.024;  // of two balls of 20 mm: the line of centres is a 3-4-5 triangle
  World world = noGravity().ball({-0.5, offset, 0}, {1, 0, 0}).ball({0, 0, 0}).world();
  ASSERT_EQ(run(world, 1.0, 1).size(), 1u);
  const Vector3d n(0.8, -0.6, 0);  // from the first to the second
  // The place of the hit is rounded to 1e-16 m, which turns a line of centres of 40 mm by 1e-14.
  EXPECT_LE((velocityOf(world, 1) - 0.8 * n).norm(), 1e-13);
  EXPECT_LE((velocityOf(world, 0) - (Vector3d(1, 0, 0) - 0.8 * n)).norm(), 1e-13);
}

TEST(BallBall, ACloudKeepsMomentumAndEnergy)
{
  for (const double e : {1.0, 0.7})
  {
    std::mt19937 engine(5);
    const auto in = [&](double a, double b) { return a + (b - a) * static_cast<double>(engine()) / 4294967296.0; };
    SceneBuilder builder = noGravity(e);
    for (int i = 0; i < 64; ++i)  // a grid of balls of 1 to 10 g that all fly inwards
    {
      const Vector3d p = 0.1 * Vector3d(i % 4 - 1.5, i / 4 % 4 - 1.5, i / 16 - 1.5);
      builder.ball(p, -5.0 * p + Vector3d(in(-1, 1), in(-1, 1), in(-1, 1)), in(0.001, 0.01), in(0.01, 0.03));
    }
    World world = builder.world();
    const Totals before = world.totals();
    const std::size_t hits = run(world, 0.01, 100).size();
    const Totals after = world.totals();
    const double momentum = (after.momentum - before.momentum).norm() / std::sqrt(2.0 * before.kinetic * 64 * 0.005);
    measured("cloud of 64, hits", static_cast<double>(hits));
    measured("relative change of momentum", momentum);
    measured("relative change of energy", after.kinetic / before.kinetic - 1.0);
    EXPECT_GT(hits, 50u);
    EXPECT_LE(momentum, 1e-12);
    if (e == 1.0)
      EXPECT_NEAR(after.kinetic / before.kinetic, 1.0, 1e-12);
    else
      EXPECT_LT(after.kinetic, 0.9 * before.kinetic);
  }
}

Segment straight(const BallState& state)
{
  return flyParabola(state, 0.0, Vector3d::Zero());
}

// The first root by the schoolbook, (-b - sqrt(b^2 - 4 a c)) / 2a, for balls on a line.
double schoolbookRoot(double d, double reach, double speed)
{
  const double a = speed * speed, b = -2.0 * d * speed, c = d * d - reach * reach;
  return (-b - std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

TEST(BallBall, SmallGapsAreCrossedWithoutCancellation)
{
  constexpr double kSpeed = 0.7;
  const double reach = 0.02 + 0.0213;
  double ours = 0.0;
  double schoolbook = 0.0;
  for (const double wanted : {1e-3, 1e-6, 1e-9, 1e-12, 1.1e-12, 1.2e-12, 1.3e-12, 1e-14})
  {
    BallState left, right;
    right.p_WB.x() = reach + wanted;
    right.v_WB.x() = -kSpeed;
    const double truth = (right.p_WB.x() - reach) / kSpeed;  // the subtraction is exact
    const Detection found = firstContact(straight(left), 0.02, straight(right), 0.0213, 0.0, 1.0);
    ASSERT_TRUE(found.found());
    ours = std::max(ours, std::abs(found.time / truth - 1.0));
    schoolbook = std::max(schoolbook, std::abs(schoolbookRoot(right.p_WB.x(), reach, kSpeed) / truth - 1.0));
  }
  measured("time to cross 1 mm to 1e-14 m, worst relative error", ours);
  measured("of the schoolbook root", schoolbook);
  EXPECT_LE(ours, 1e-15);
  EXPECT_GT(schoolbook, 1e-7);
}

TEST(BallBall, TouchingStartsCountOnlyIfTheyApproach)
{
  for (const double v : {-1.0, 0.0, 1.0})
  {
    World balls = noGravity().ball({0, 0, 0}).ball({0.04, 0, 0}, {v, 0, 0}).world();
    EXPECT_EQ(run(balls, 0.1, 3).size(), v < 0.0 ? 1u : 0u) << "ball, " << v;
    EXPECT_EQ(velocityOf(balls, 0).x(), v < 0.0 ? v : 0.0);
    World wall = noGravity().floor().ball({0, 0, kR}, {0, 0, v}).world();
    EXPECT_EQ(run(wall, 0.1, 3).size(), v < 0.0 ? 1u : 0u) << "floor, " << v;
    EXPECT_EQ(velocityOf(wall).z(), std::abs(v));
  }
}

TEST(BallBall, OverlapFromRoundingIsAnImmediateHitThatKeepsTheEnergy)
{
  for (const double overlap : {1e-17, 1e-15, 1e-12, 1.5e-7})
  {
    World world = noGravity().ball({0, 0, 0}, {1, 0, 0}).ball({0.04 - overlap, 0, 0}).world();
    const std::vector<Contact> hits = run(world, 0.1, 3);
    ASSERT_EQ(hits.size(), 1u) << overlap;
    EXPECT_EQ(hits[0].time, 0.0);
    EXPECT_EQ(velocityOf(world, 0).x(), 0.0);
    EXPECT_EQ(velocityOf(world, 1).x(), 1.0);
    World apart = noGravity().ball({0, 0, 0}).ball({0.04 - overlap, 0, 0}, {1, 0, 0}).world();
    EXPECT_EQ(run(apart, 0.1, 3).size(), 0u) << overlap;
  }
}
}  // namespace
}  // namespace ping_pong
