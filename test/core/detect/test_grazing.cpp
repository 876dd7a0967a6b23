// A micrometre decides between hit and miss. Over a net: test_stability.cpp.
#include <gtest/gtest.h>

#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
constexpr double kHair = 1e-6;  // [m]

std::size_t hitsWithin(SceneBuilder& builder, double duration)
{
  World world = builder.world();
  return run(world, 0.01, static_cast<int>(std::lround(100.0 * duration))).size();
}

TEST(Grazing, AMicrometreDecidesAtAnEdge)
{
  for (const double angle : {0.0, 0.4, 1.1})
    for (const double v : {1.0, 30.0})
      for (const int side : {-1, 1})
      {
        // The edge is the y axis; the ball passes outside the corner x = 0, z = 0 at 45 degrees, then all is turned.
        const Eigen::AngleAxisd turn(angle, Vector3d(1, 2, 3).normalized());
        SceneBuilder builder;
        builder.box("box", {0.4, 0.4, 0.4}, {turn * Vector3d(-0.2, 0, -0.2), Quaterniond(turn)});
        const Vector3d out = Vector3d(1, 0, 1).normalized();
        const Vector3d along = Vector3d(1, 0.3, -1).normalized();
        builder.ball(turn * ((kR + side * kHair) * out - 0.1 * along), turn * (v * along));
        EXPECT_EQ(hitsWithin(builder, 0.2), side < 0 ? 1u : 0u) << angle << " " << v << " " << side;
      }
}

TEST(Grazing, AMicrometreDecidesAtACornerABallAndACylinder)
{
  for (const int side : {-1, 1})
  {
    const std::size_t expected = side < 0 ? 1u : 0u;
    SceneBuilder corner;
    corner.box("box", {0.4, 0.4, 0.4}, at({-0.2, -0.2, -0.2}));
    const Vector3d out = Vector3d(1, 1, 1).normalized();
    const Vector3d along = Vector3d(1, -1, 0).normalized();
    corner.ball((kR + side * kHair) * out - 0.1 * along, 5.0 * along);
    EXPECT_EQ(hitsWithin(corner, 0.1), expected) << "corner";

    SceneBuilder balls;
    balls.ball({0, 0, 0}).ball({-0.5, 2.0 * kR + side * kHair, 0}, {7, 0, 0});
    EXPECT_EQ(hitsWithin(balls, 0.2), expected) << "ball";

    SceneBuilder side_of_cylinder;
    side_of_cylinder.body("tube", BodyKind::Static, {cylinderShape(0.05, 0.3)}, at({0, 0, 0}));
    side_of_cylinder.ball({-0.5, 0.05 + kR + side * kHair, 0.02}, {7, 0, 0});
    EXPECT_EQ(hitsWithin(side_of_cylinder, 0.2), expected) << "cylinder";

    SceneBuilder sphere;
    sphere.body("knob", BodyKind::Static, {sphereShape(0.05)}, at({0, 0, 0}));
    sphere.ball({-0.5, 0, 0.05 + kR + side * kHair}, {7, 0, 0});
    EXPECT_EQ(hitsWithin(sphere, 0.2), expected) << "sphere";
  }
}

TEST(Grazing, AMicrometreDecidesForATurningBlade)
{
  // The tip of a blade passes the ball at 60 rad/s: a thin box whose end face comes within a hair.
  for (const int side : {-1, 1})
  {
    SceneBuilder builder;
    builder.paddle("blade", boxShape({0.4, 0.001, 0.05}), at({0, 0, 0}));
    const double tip = std::hypot(0.2, 0.0005);  // the edges of the end face sweep furthest
    builder.ball({0, tip + kR + side * kHair, 0});
    World world = builder.world();
    world.command(0, velocityCommand({0, 0, 0}, {0, 0, 60}));
    std::size_t hits = 0;
    for (int i = 0; i < 8; ++i) hits += world.advance(4e-3).contacts;  // 1.8 rad: past the ball once
    EXPECT_EQ(hits, side < 0 ? 1u : 0u);
  }
}
}  // namespace
}  // namespace ping_pong
