// What the shipped scenes with air promise in their first lines.
#include <gtest/gtest.h>

#include "ping_pong_sim/scene_loader.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
Scene shipped(const std::string& name)
{
  return loadScene(std::string(SCENES_DIR) + "/" + name + ".yaml");
}

struct Touch
{
  std::string material;
  Contact contact;
};

/// What happens until a time; path holds the centre of ball 0 at every millisecond.
struct Story
{
  std::vector<Touch> touches;
  std::vector<Vector3d> path;
};

Story told(const Scene& scene, double duration)
{
  World world(scene);
  Story story;
  while (world.time() < duration)
  {
    EXPECT_TRUE(world.advance(1e-3).ok());
    for (const Contact& contact : world.contacts())
    {
      const Body& body = scene.bodies.at(contact.body);
      story.touches.push_back({scene.materials.at(body.shapes.at(contact.shape).material), contact});
    }
    story.path.push_back(world.ballState(0).p_WB);
  }
  return story;
}

/// Height of the ball's lowest point where it passes over x = 0, between two samples [m].
double heightOverTheNet(const std::vector<Vector3d>& path)
{
  for (std::size_t i = 1; i < path.size(); ++i)
    if (path[i - 1].x() > 0.0 && path[i].x() <= 0.0) return std::min(path[i - 1].z(), path[i].z()) - kBallRadius;
  return 0.0;
}

TEST(RallyScene, ServeBouncesOnceOnEachSideAndClearsTheNet)
{
  const Story story = told(shipped("rally"), 0.8);
  ASSERT_EQ(story.touches.size(), 3u);
  const Touch &own = story.touches[0], &far = story.touches[1], &paddle = story.touches[2];
  EXPECT_EQ(own.material, "table");
  EXPECT_NEAR(own.contact.p_WC.x(), 0.72, 0.005);  // as the file says, to its last digit
  EXPECT_NEAR(own.contact.time, 0.128, 0.0005);
  EXPECT_EQ(far.material, "table");
  EXPECT_NEAR(far.contact.p_WC.x(), -0.98, 0.005);
  EXPECT_NEAR(far.contact.time, 0.565, 0.0005);
  EXPECT_EQ(paddle.material, "forehand");
  EXPECT_NEAR(paddle.contact.time, 0.756, 0.0005);
  for (const Touch& bounce : {own, far})
  {
    EXPECT_LT(std::abs(bounce.contact.p_WC.y()), kTableWidth / 2);
    EXPECT_EQ(bounce.contact.n_W, Vector3d::UnitZ());
  }
  EXPECT_NEAR(heightOverTheNet(story.path) - kTableHeight - kNetHeight, 0.10, 0.005);
}

/// How fast the ball's surface moves over the still body that it touches [m/s].
Vector3d slip(const Contact& contact, const Vector3d& v, const Vector3d& w)
{
  const Vector3d over = v - kBallRadius * w.cross(contact.n_W);
  return over - contact.n_W.dot(over) * contact.n_W;
}

TEST(RallyScene, EitherRubberGripsAndSpringsBack)
{
  for (const double side : {1.0, -1.0})
  {
    Scene scene = shipped("rally");
    BallState& ball = scene.balls.at(0).state;
    ball.p_WB = scene.bodies.at(1).pose.p + Vector3d(0.2 * side, 0, 0);
    ball.v_WB = Vector3d(-5.0 * side, 0, 0);
    ball.w_WB = Vector3d(0, 100.0 * side, 0);
    const Story story = told(scene, 0.06);
    ASSERT_EQ(story.touches.size(), 1u);
    EXPECT_EQ(story.touches[0].material, side > 0.0 ? "forehand" : "backhand");
    const Contact& contact = story.touches[0].contact;
    const Vector3d before = slip(contact, contact.v_before, contact.w_before);
    const Vector3d after = slip(contact, contact.v_after, contact.w_after);
    EXPECT_GT(before.norm(), 1.0);
    EXPECT_LT((after + 0.70 * before).norm(), 1e-14);  // a few roundings of numbers of size 2
    const double e = -contact.v_after.x() / contact.v_before.x();
    EXPECT_NEAR(e, 0.917 - 0.0217 * std::abs(contact.v_before.x()), 1e-14);
  }
}

TEST(ArcAirScene, LandsShorterThanArc)
{
  const Scene arc = shipped("arc"), arc_air = shipped("arc_air");
  EXPECT_EQ(arc.balls.at(0).state.p_WB, arc_air.balls.at(0).state.p_WB);
  EXPECT_EQ(arc.balls.at(0).state.v_WB, arc_air.balls.at(0).state.v_WB);
  const Story vacuum = told(arc, 1.0), air = told(arc_air, 1.0);
  ASSERT_FALSE(vacuum.touches.empty() || air.touches.empty());
  EXPECT_NEAR(vacuum.touches[0].contact.p_WC.x(), 2.64, 0.005);
  EXPECT_NEAR(air.touches[0].contact.p_WC.x(), 0.69, 0.005);
  EXPECT_EQ(air.touches[0].material, "table");
  EXPECT_GT(air.touches[0].contact.w_after.y(), air.touches[0].contact.w_before.y());
}
}  // namespace
}  // namespace ping_pong
