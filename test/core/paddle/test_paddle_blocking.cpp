// A paddle cannot be driven through the table, the net or a wall: it stops at the surface and slides along it.
#include <gtest/gtest.h>

#include <random>

#include "geometry/separating_axis.h"
#include "paddle/paddle_drive.h"
#include "ping_pong_sim/scene_loader.h"
#include "ping_pong_sim/world.h"

namespace ping_pong
{
namespace
{
struct Player
{
  World world{loadScene(SCENES_DIR "/paddle.yaml")};
  std::size_t table = world.findBody("table");
  std::size_t paddle = world.findBody("paddle");

  explicit Player(const Pose& pose) { EXPECT_FALSE(world.setBodyPose(paddle, pose)); }
  void move(const Vector3d& v, const Vector3d& w = Vector3d::Zero())
  {
    PaddleCommand command;
    command.mode = PaddleCommand::Mode::Velocity;
    command.twist = {v, w};
    EXPECT_FALSE(world.command(paddle, command));
  }
  Vector3d p() const { return world.bodyPose(paddle).p; }
};

// Independent of separating axes: depth of the deepest of many surface points of the paddle in the boxes of the table.
double deepestPointInBoxes(const Player& player)
{
  const Pose X_WT = player.world.bodyPose(player.table);
  const Pose X_WP = player.world.bodyPose(player.paddle);
  double deepest = 0.0;
  for (const Shape& mine : player.world.body(player.paddle).shapes)
    for (int i = 0; i < 24; ++i)
      for (int k = 0; k <= 12; ++k)
        for (const double end : {-1.0, 1.0})
        {
          const double angle = i * M_PI / 12.0;
          Vector3d q(std::cos(angle), std::sin(angle), end);
          if (mine.kind == ShapeKind::Box) q.head<2>() /= q.head<2>().cwiseAbs().maxCoeff();  // the rim of a square
          q.head<2>() *= k / 12.0;
          const Vector3d p_W = X_WP.q * (mine.R_BS * mine.half_size.cwiseProduct(q) + mine.p_BS) + X_WP.p;
          for (const Shape& other : player.world.body(player.table).shapes)
          {
            if (other.kind != ShapeKind::Box) continue;
            const Vector3d y = other.R_BS.transpose() * (X_WT.q.conjugate() * (p_W - X_WT.p) - other.p_BS);
            deepest = std::max(deepest, (other.half_size - y.cwiseAbs()).minCoeff());
          }
        }
  return deepest;
}

const Quaterniond kFlat(Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitY()));  // forehand down

TEST(Blocking, APaddleStopsAtTheTable)
{
  Player player({{-0.7, 0.0, 1.0}, kFlat});
  player.move({0.0, 0.0, -1.0});
  for (int i = 0; i < 300; ++i) player.world.advance(0.002);
  // Half of the handle's 30 mm box is thicker than the blade; the paddle keeps at most 0.1 mm off.
  const double gap = player.p().z() - 0.76 - 0.0115;
  EXPECT_GE(gap, 0.0);
  EXPECT_LE(gap, 1e-4);
  EXPECT_LT(std::abs(player.world.bodyTwist(player.paddle).v.z()), 1e-9);
}

TEST(Blocking, AndSlidesAlongIt)
{
  Player player({{-1.0, 0.0, 0.8}, kFlat});
  player.move({0.5, 0.2, -2.0});
  for (int i = 0; i < 500; ++i) player.world.advance(0.002);
  EXPECT_NEAR(player.p().x(), -1.0 + 0.5, 2e-3);  // it takes a tick to reach its speed
  EXPECT_NEAR(player.p().y(), 0.2, 2e-3);
  EXPECT_GT(player.p().z(), 0.76);
}

// A tick is moved in pieces of at most 5 ms, and a turning paddle meets the table piece by piece: still it is one paddle.
TEST(Blocking, APaddleCountsOnceHoweverLongTheTick)
{
  for (const double tick : {0.002, 0.01, 0.02, 0.1})
    for (const Vector3d& w : {Vector3d(0, 0, 0), Vector3d(1.0, 0.5, 0)})
    {
      Player player({{-0.7, 0.0, 0.8}, kFlat});
      player.move({0.1, 0.0, -1.0}, w);
      player.world.advance(0.1);  // down to the table
      for (int i = 0; i < 3; ++i) EXPECT_EQ(player.world.advance(tick).blocked_paddles, 1u) << tick;
    }
}

TEST(Blocking, CountsThePaddlesThatAreBlockedNow)
{
  Scene scene = loadScene(SCENES_DIR "/paddle.yaml");
  Body second = scene.bodies[1];
  second.name = "second";
  second.pose = {{-0.7, 0.5, 0.78}, kFlat};
  scene.bodies[1].pose = {{-0.7, -0.5, 0.78}, kFlat};
  scene.bodies.push_back(second);
  World world(scene);
  const auto move = [&](const char* name, double vz)
  {
    PaddleCommand command;
    command.mode = PaddleCommand::Mode::Velocity;
    command.twist.v.z() = vz;
    ASSERT_FALSE(world.command(world.findBody(name), command));
  };
  move("paddle", -1.0);
  move("second", -1.0);
  EXPECT_EQ(world.advance(0.1).blocked_paddles, 2u);
  move("second", 1.0);
  world.advance(0.1);
  EXPECT_EQ(world.advance(0.1).blocked_paddles, 1u);
  move("paddle", 1.0);
  world.advance(0.1);
  EXPECT_EQ(world.advance(0.1).blocked_paddles, 0u);
}

TEST(Blocking, NoSpeedPassesThroughTheTwoMillimetresOfTheNet)
{
  for (const double speed : {0.1, 1.0, 10.0, 100.0})
  {
    Scene scene = loadScene(SCENES_DIR "/paddle.yaml");
    Player player({{-0.5, 0.0, 0.9}, Quaterniond::Identity()});
    scene.bodies[player.paddle].limits = {200.0, 1e6, 100.0, 1e4};
    player.world = World(scene);
    ASSERT_FALSE(player.world.setBodyPose(player.paddle, {{-0.5, 0.0, 0.95}, Quaterniond::Identity()}));
    player.move({speed, 0.0, 0.0});
    std::size_t blocked = 0;
    for (int i = 0; i < 2000 && blocked < 50 && player.p().x() < 1.0; ++i)
      blocked += player.world.advance(0.01).blocked_paddles;
    EXPECT_GT(blocked, 0u) << speed;
    EXPECT_LT(player.p().x(), -0.001) << speed;
  }
}

TEST(Blocking, ATurningPaddleNeverEntersTheTable)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  double deepest = 0.0;
  for (int run = 0; run < 40; ++run)
  {
    const Vector3d start(-0.6 + 0.5 * uniform(random), 0.5 * uniform(random), 1.2);
    Player player({start, Quaterniond(Eigen::AngleAxisd(3.0 * uniform(random), vector().normalized()))});
    for (int i = 0; i < 60; ++i)
    {
      if (i % 15 == 0) player.move(4.0 * vector() - Vector3d(0.0, 0.0, 2.0), 15.0 * vector());
      player.world.advance(0.005);
      deepest = std::max(deepest, deepestPointInBoxes(player));
    }
  }
  EXPECT_LE(deepest, 0.0) << "depth in m";
}

// A plate turns in its plane just over a table. One look knows it clear for as long as its fastest point would take to use up
// the gap but for half of the band of 0.1 mm in which it touches. After 64 looks the motion ends, and the next piece goes on.
TEST(Blocking, ATurnJustOverTheTableIsMovedAsFarAs64LooksReach)
{
  Shape plate, table;
  plate.half_size = {0.1, 0.1, 0.005};
  table.half_size = {1.0, 1.0, 0.05};
  const std::vector<Shape> plates{plate}, tables{table};
  const double gap = 1.5e-4, h = 5e-3;
  std::vector<ShapePair> near;
  for (const double w : {5.0, 10.0, 14.0})
  {
    BodyMotion motion;
    motion.pose.p.z() = 0.055 + gap;
    motion.twist.w.z() = w;
    const BlockedMotion allowed = stopAtObstacles(plates, motion, h, {{&tables, Pose()}}, near);
    const double reach = 64.0 * (gap - 0.5e-4) / (w * plate.half_size.norm());
    EXPECT_NEAR(allowed.duration, std::min(reach, h), 1e-12)
        << w;  // the gap is a difference of numbers near 0.05: 1e-17
    EXPECT_EQ(allowed.motion.twist.w.z(), w);
    EXPECT_EQ(allowed.blocked, reach < h) << w;
  }
}

TEST(Blocking, APaddleThatATableWasMovedOntoIsPushedOutSlowly)
{
  Player player({{-0.7, 0.0, 0.80}, kFlat});
  ASSERT_FALSE(player.world.setBodyPose(player.table, {{0.0, 0.0, 0.80}, Quaterniond::Identity()}));
  player.move({0.0, 0.0, -0.001});  // any command: a paddle on hold does not work
  double fastest = 0.0;
  for (int i = 0; i < 500; ++i)
  {
    player.world.advance(0.002);
    fastest = std::max(fastest, player.world.bodyTwist(player.paddle).v.norm());
  }
  EXPECT_LT(deepestPointInBoxes(player), 1e-4);
  EXPECT_LE(fastest, 1.0 + 1e-9);
}

Shape box(const Vector3d& half)
{
  Shape shape;
  shape.half_size = half;
  return shape;
}

TEST(Separation, FacesEdgesAndCornersOfBoxes)
{
  const Shape cube = box({1.0, 1.0, 1.0});
  const Pose at_origin;
  const Separation face = separation(cube, {{0.3, 0.2, 2.5}, Quaterniond::Identity()}, cube, at_origin);
  EXPECT_NEAR(face.gap, 0.5, 1e-15);
  EXPECT_NEAR(face.n_W.z(), 1.0, 1e-15);
  // Two cubes on edge, crossed: sqrt(2) each above the middle.
  const Quaterniond on_x(Eigen::AngleAxisd(M_PI / 4, Vector3d::UnitX()));
  const Quaterniond on_y(Eigen::AngleAxisd(M_PI / 4, Vector3d::UnitY()));
  const Separation edges = separation(cube, {{0.0, 0.0, 2.0 * std::sqrt(2.0) + 0.1}, on_x}, cube, {{0, 0, 0}, on_y});
  EXPECT_NEAR(edges.gap, 0.1, 1e-12);
  // Corner to corner along the diagonal.
  const Separation corners = separation(cube, {{2.1, 2.1, 2.1}, Quaterniond::Identity()}, cube, at_origin);
  EXPECT_GE(corners.gap, 0.1 - 1e-15);  // of two boxes a lower bound
  EXPECT_LE(corners.gap, 0.1 * std::sqrt(3.0));
  const Separation deep = separation(cube, {{0.0, 0.0, 1.9}, Quaterniond::Identity()}, cube, at_origin);
  EXPECT_NEAR(deep.gap, -0.1, 1e-15);
}

TEST(Separation, OfACylinderFromABoxAndTheFloor)
{
  Shape blade;
  blade.kind = ShapeKind::Cylinder;
  blade.half_size = {0.08, 0.08, 0.006};
  const Shape table = box({1.0, 1.0, 0.1});
  const Quaterniond upright(Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitY()));
  EXPECT_NEAR(separation(blade, {{0.0, 0.0, 0.2}, Quaterniond::Identity()}, table, Pose()).gap, 0.094, 1e-15);
  EXPECT_NEAR(separation(blade, {{0.0, 0.0, 0.2}, upright}, table, Pose()).gap, 0.02, 1e-15);
  Shape floor;
  floor.kind = ShapeKind::HalfSpace;
  EXPECT_NEAR(separation(blade, {{0.0, 0.0, 0.2}, upright}, floor, Pose()).gap, 0.12, 1e-15);
}
}  // namespace
}  // namespace ping_pong
