// A smooth ball slides off a table: over the edge it turns about it, and leaves it where nothing presses any more.
#include <gtest/gtest.h>

#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
World sliding(double speed)
{
  return SceneBuilder()
      .gravity(kG)
      .restitution(0.5)
      .box("table", {1, 1, 0.1}, at({-0.5, 0, -0.05}))
      .ball({-0.05, 0, kR}, {speed, 0, 0})
      .world();
}

// Of kinetic energy and height, as a part of the kinetic energy and of what a fall by r gives.
double energyError(const World& world, double speed)
{
  const double kinetic = 0.5 * speed * speed;
  const double now = 0.5 * velocityOf(world).squaredNorm() + kG * (positionOf(world).z() - kR);
  return std::abs(now - kinetic) / (kinetic + kG * kR);
}

TEST(OverTheEdge, ASlowBallLeavesWhereCosIsTwoThirdsAndAQuarterMore)
{
  for (const double speed : {0.02, 0.1, 0.3, 0.43})
  {
    World world = sliding(speed);
    double worst = 0.0;
    double inside = 0.0;
    for (int i = 0; i < 30000 && positionOf(world).z() > -0.3; ++i)
    {
      world.advance(1e-4);
      ASSERT_EQ(world.contacts().size(), 0u);
      worst = std::max(worst, energyError(world, speed));
      // It never enters the edge, the y axis.
      const Vector3d p = positionOf(world);
      if (p.x() > 0.0) inside = std::max(inside, kR - std::hypot(p.x(), p.z()));
    }
    ASSERT_LE(positionOf(world).z(), -0.3);
    // On the edge v^2 = v0^2 + 2 g r (1 - cos), and gravity has to supply v^2 / r: cos = (2 + v0^2 / (g r)) / 3.
    const double cosine = (2.0 + speed * speed / (kG * kR)) / 3.0;
    const double leaving = std::sqrt(kG * kR * cosine);
    std::printf("[ measured ] v0 = %g m/s, leaves at %.2f degrees\n", speed, std::acos(cosine) * 180.0 / kPi);
    measured("error of the horizontal velocity [m/s]", velocityOf(world).x() - leaving * cosine);
    measured("relative energy error on the way", worst);
    measured("deepest in the edge [m]", inside);
    // A surface that carries nothing is left at 1e-8 m/s.
    EXPECT_NEAR(velocityOf(world).x(), leaving * cosine, 1e-8);
    // A piece is a polynomial: between its nodes it is the circle to less than a picometre, and keeps 1e-9 of the energy.
    EXPECT_LE(inside, 1e-12);
    EXPECT_LE(worst, 1e-9);
    EXPECT_LE(energyError(world, speed), 1e-10);
  }
}

TEST(OverTheEdge, AFastBallLeavesAtOnce)
{
  const double speed = 1.0;  // v^2 > g r
  World world = sliding(speed);
  world.advance(0.25);
  const double t = 0.25 - 0.05 / speed;
  EXPECT_NEAR(velocityOf(world).x(), speed, 1e-14);
  EXPECT_NEAR(positionOf(world).x(), -0.05 + 0.25 * speed, 1e-14);
  EXPECT_NEAR(positionOf(world).z(), kR - 0.5 * kG * t * t,
              2e-9);  // a face counts to 1 nm beyond its edge: g t times 1 ns
}

TEST(OverTheEdge, ABallComesToRestOnTopOfAnEdgeOnlyOnTheFace)
{
  World world = SceneBuilder()
                    .gravity(kG)
                    .restitution(0.5)
                    .floor(-0.5)
                    .box("table", {1, 1, 0.1}, at({-0.5, 0, -0.05}))
                    .ball({1e-4, 0, kR + 0.01})
                    .ball({-1e-4, 0.2, kR + 0.01})
                    .world();
  run(world, 0.01, 500);
  EXPECT_LT(positionOf(world, 0).z(), 0.0);
  EXPECT_TRUE(world.resting(1));
  EXPECT_EQ(positionOf(world, 1).x(), -1e-4);
}
}  // namespace
}  // namespace ping_pong
