// Two and three walls at the same instant. From any direction: test_stability.cpp.
#include <gtest/gtest.h>

#include <algorithm>

#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
// Walls x < 0, y < 0, z < 0 as boxes, listed in this order.
World corner(const std::vector<int>& order, double e, const Vector3d& p, const Vector3d& v)
{
  SceneBuilder builder;
  builder.restitution(e);
  for (const int axis : order)
  {
    Vector3d middle = Vector3d::Constant(1.5);
    middle[axis] = -2.0;
    builder.box("wall", {4, 4, 4}, at(middle));
  }
  return builder.ball(p, v).world();
}

TEST(Corner, TwoWallsAtOnceReverseBothDirections)
{
  for (const double e : {1.0, 0.6, 0.0})
  {
    const double z = 0.5;
    World one = corner({0, 1}, e, {0.52, 0.52, z}, {-1, -1, 0.25});
    World other = corner({1, 0}, e, {0.52, 0.52, z}, {-1, -1, 0.25});
    EXPECT_EQ(run(one, 0.1, 10).size(), 2u);
    EXPECT_EQ(run(other, 0.1, 10).size(), 2u);
    EXPECT_LE((velocityOf(one) - Vector3d(e, e, 0.25)).norm(), 1e-15);
    EXPECT_EQ(velocityOf(other), velocityOf(one));
    EXPECT_EQ(positionOf(other), positionOf(one));
    EXPECT_NEAR(positionOf(one).x(), kR + e * 0.5, 1e-15);
  }
}

TEST(Corner, ThreeWallsAtOnceReverseAllInAnyOrder)
{
  std::vector<int> order{0, 1, 2};
  do
  {
    World world = corner(order, 0.7, {0.52, 0.52, 0.52}, {-1, -1, -1});
    EXPECT_EQ(run(world, 0.1, 10).size(), 3u);
    EXPECT_LE((velocityOf(world) - Vector3d(0.7, 0.7, 0.7)).norm(), 1e-15);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Corner, ABallBetweenFloorAndCeilingOfItsOwnSizeStaysThere)
{
  World world = SceneBuilder()
                    .restitution(0.5)
                    .gravity(kG)
                    .floor()
                    .box("lid", {1, 1, 0.1}, at({0, 0, 0.05 + 2.0 * kR}))
                    .ball({0, 0, kR}, {0.3, 0, 0})
                    .world();
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(world.advance(0.01).ok());
  EXPECT_NEAR(positionOf(world).x(), 0.3, 1e-14);
  EXPECT_EQ(positionOf(world).z(), kR);
}
}  // namespace
}  // namespace ping_pong
