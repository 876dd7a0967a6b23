// Flush shapes are one surface to method `impulse`: a ball goes as on one board.
#include <gtest/gtest.h>

#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
constexpr double kTile = 0.1, kThick = 0.02;  // [m]
constexpr int kTiles = 12;                    // in a row

// From two tiles before the origin along x and four along y: the top of the body, at z = 0.
std::vector<Shape> tiles(double edge = kTile)
{
  std::vector<Shape> all;
  for (int i = 0; i < kTiles; ++i)
    for (int k = 0; k < kTiles; ++k)
    {
      all.push_back(boxShape({edge, edge, kThick}));
      all.back().p_BS = Vector3d(edge * (i - 2) + 0.5 * edge, edge * (k - 4) + 0.5 * edge, -0.5 * kThick);
    }
  return all;
}

std::vector<Shape> planks()
{
  std::vector<Shape> all;
  for (int i = 0; i < kTiles; ++i)
  {
    all.push_back(boxShape({kTile, kTiles * kTile, kThick}));
    all.back().p_BS = Vector3d(kTile * (i - 2) + 0.5 * kTile, 2.0 * kTile, -0.5 * kThick);
  }
  return all;
}

std::vector<Shape> board(double edge = kTile)
{
  Shape shape = boxShape({kTiles * edge, kTiles * edge, kThick});
  shape.p_BS = Vector3d(4.0 * edge, 2.0 * edge, -0.5 * kThick);
  return {shape};
}

enum class Bodies
{
  One,
  Each  // a body of its own for each shape
};

struct Ride
{
  Pose pose = at(Vector3d::Zero());
  Vector3d p{0.013, 0.007, kR}, v{0.5, 0.2, 0};  // of the ball in the frame of the board [m], [m/s]
  double friction = 0.0, restitution = 0.8, dt = 1e-3, duration = 1.5;
  BodyKind kind = BodyKind::Static;
  PaddleCommand command{};
};

Surface lawOf(const Ride& ride)
{
  Surface law;
  law.restitution = ride.restitution;
  law.friction = ride.friction;
  return law;
}

struct End
{
  BallState ball;
  std::size_t contacts;
};

End endOn(const std::vector<Shape>& shapes, const Ride& ride, Bodies bodies = Bodies::One)
{
  SceneBuilder builder(Method::Impulse, ride.dt);
  builder.gravity(kG).ball(ride.pose.q * ride.p + ride.pose.p, ride.pose.q * ride.v);
  if (bodies == Bodies::One)
    builder.body("deck", ride.kind, shapes, ride.pose);
  else
    for (std::size_t s = 0; s < shapes.size(); ++s)
      builder.body("deck" + std::to_string(s), ride.kind, {shapes[s]}, ride.pose);
  Scene scene = builder.build();
  for (MaterialId a = 0; a < scene.materials.size(); ++a)
    for (MaterialId b = 0; b < scene.materials.size(); ++b) scene.surfaces.set(a, b, lawOf(ride));
  World world(scene);
  std::size_t contacts = 0;
  for (int i = 0; i < 100; ++i)
  {
    if (ride.kind == BodyKind::Kinematic) world.command(0, ride.command);
    contacts += world.advance(0.01 * ride.duration).contacts;
  }
  return {world.ballState(0), contacts};
}

void expectSame(const End& seams, const End& whole, double tolerance, const std::string& what)
{
  EXPECT_LE((seams.ball.p_WB - whole.ball.p_WB).norm(), tolerance) << what;
  EXPECT_LE((seams.ball.v_WB - whole.ball.v_WB).norm(), tolerance) << what;
  EXPECT_LE((seams.ball.w_WB - whole.ball.w_WB).norm(), tolerance / kR) << what;
  EXPECT_EQ(seams.contacts, whole.contacts) << what;
}

void expectAsOnOneBoard(const Ride& ride, double tolerance, const std::string& what)
{
  const End whole = endOn(board(), ride);
  expectSame(endOn(tiles(), ride), whole, tolerance, what + ", tiles of one body");
  expectSame(endOn(tiles(), ride, Bodies::Each), whole, tolerance, what + ", tiles of many bodies");
  expectSame(endOn(planks(), ride), whole, tolerance, what + ", planks");
}

// Slow, fast, along a seam, over corners: (10 m/s leaves the board.)
const Vector3d kWays[] = {{0.5, 0.2, 0}, {0.01, 0.2, 0}, {0.3, 0.0, 0}, {0.2, 0.2, 0}, {3.0, 0.7, 0}, {10.0, 3.0, 0}};

TEST(SolverSeams, ABallSlidesAndRollsAsOnOneBoard)
{
  for (const Vector3d& v : kWays)
    for (const double friction : {0.0, 0.05, 0.3})
      for (const double dt : {1e-3, 4e-3})
      {
        Ride ride;
        ride.v = v;
        if (v.y() == 0.0 || v.x() == v.y()) ride.p.head<2>().setZero();
        ride.friction = friction;
        ride.dt = dt;
        expectAsOnOneBoard(ride, 1e-12, "v_x " + std::to_string(v.x()) + ", friction " + std::to_string(friction));
      }
}

// What rounding makes of a tilted board differs from shape to shape, and impulses have 24 bits: of 1 m/s some 1e-8 m/s are left.
TEST(SolverSeams, TheSameOnATiltedBoard)
{
  for (const double friction : {0.0, 0.3})
    for (const double angle : {0.02, -0.1})
    {
      Ride ride;
      ride.pose = at({0.3, -0.2, 0.7}, angle, {0.3, 1.0, 0.2});
      ride.friction = friction;
      ride.duration = 0.8;
      expectAsOnOneBoard(ride, 1e-7, "tilted by " + std::to_string(angle) + ", friction " + std::to_string(friction));
    }
}

TEST(SolverSeams, ABallBouncesAsOnOneBoard)
{
  for (const double friction : {0.0, 0.3})
    for (const double restitution : {0.0, 0.5, 0.9, 1.0})
    {
      Ride ride;
      ride.p.z() = 0.1;
      ride.friction = friction;
      ride.restitution = restitution;
      expectAsOnOneBoard(ride, 1e-12, "restitution " + std::to_string(restitution));
    }
}

// A paddle of tiles rises, slides and turns below the ball.
TEST(SolverSeams, TheSameOnAPaddleThatMoves)
{
  for (const double friction : {0.0, 0.3})
  {
    Ride ride;
    ride.kind = BodyKind::Kinematic;
    ride.command = velocityCommand({-0.3, 0.1, 0.1}, {0.02, 0.05, 0.3});
    ride.friction = friction;
    ride.duration = 0.8;
    const End whole = endOn(board(), ride);
    expectSame(endOn(tiles(), ride), whole, 1e-9, "tiles, friction " + std::to_string(friction));
    expectSame(endOn(planks(), ride), whole, 1e-9, "planks, friction " + std::to_string(friction));
  }
}

// Over the end of the board the edges of all tiles are one edge.
TEST(SolverSeams, ABallLeavesTheBoardAsOneWithoutSeams)
{
  for (const Vector3d& v : {Vector3d(0.3, 0.2, 0), Vector3d(0.08, 0.1, 0), Vector3d(2.0, 0.5, 0)})
    for (const double friction : {0.0, 0.3})
    {
      Ride ride;
      ride.p = Vector3d(0.96, 0.007, kR);
      ride.v = v;
      ride.friction = friction;
      ride.duration = 1.2;
      const End whole = endOn(board(), ride);
      EXPECT_LT(whole.ball.p_WB.z(), -0.1);
      expectSame(endOn(tiles(), ride), whole, 1e-9, "v_x " + std::to_string(v.x()));
    }
}

// Half a pipe's length of a pole that lies on its side: a seam runs round it.
TEST(SolverSeams, ARoundSideOfTwoPiecesIsOne)
{
  const auto pole = [](int pieces)
  {
    std::vector<Shape> all;
    for (int i = 0; i < pieces; ++i)
    {
      Shape shape = cylinderShape(0.05, 1.2 / pieces);
      shape.R_BS << 0, 0, 1, 0, 1, 0, -1, 0, 0;  // its axis along x
      shape.p_BS = Vector3d(-0.2 + 1.2 / pieces * (i + 0.5), 0, -0.05);
      all.push_back(shape);
    }
    return all;
  };
  for (const double y : {0.0, 1e-4})
  {
    Ride ride;
    ride.p = Vector3d(0.013, y, kR);
    ride.v = Vector3d(0.7, 0, 0);
    ride.duration = 1.0;
    expectSame(endOn(pole(12), ride), endOn(pole(1), ride), 1e-9, "pole");
  }
}

// --- what is no seam ---

// The ball touches the edge of a step up by 0.1 mm under acos(1 - h / r) = 0.1 rad, and is thrown.
TEST(SolverSeams, AStepOfATenthOfAMillimetreIsAStep)
{
  constexpr double kStep = 1e-4;
  std::vector<Shape> step = planks();
  for (std::size_t i = 5; i < step.size(); ++i) step[i].p_BS.z() += kStep;
  Ride up;
  up.v = Vector3d(1.0, 0, 0);
  up.duration = 0.5;
  const End after = endOn(step, up);
  EXPECT_GT(after.contacts, 0u);
  EXPECT_LT(after.ball.v_WB.x(), 0.9999);
  Ride down;
  down.p = Vector3d(0.4, 0.007, kR + kStep);
  down.v = Vector3d(-0.5, 0, 0);
  down.duration = 0.5;
  EXPECT_NEAR(endOn(step, down).ball.p_WB.z(), kR, 1e-6);
}

// A ramp that begins at the end of a board, in its plane: the ball is turned upwards.
TEST(SolverSeams, ARampIsNoSeam)
{
  constexpr double kSlope = 0.2;
  std::vector<Shape> all = board();
  Shape ramp = boxShape({1.0, 1.2, kThick});
  ramp.R_BS = Eigen::AngleAxisd(-kSlope, Vector3d::UnitY()).toRotationMatrix();
  ramp.p_BS = Vector3d(0.5, 0.2, 0) + ramp.R_BS * Vector3d(0.5, 0, -0.5 * kThick);
  all.push_back(ramp);
  for (const double speed : {0.3, 2.0})
  {
    Ride ride;
    ride.p.x() = 0.4;
    ride.v = Vector3d(speed, 0, 0);
    ride.restitution = 0.0;
    ride.duration = 0.15 / speed;
    const End end = endOn(all, ride);
    // cos(slope) of the speed is left along the ramp, less what gravity takes on its way.
    EXPECT_NEAR(end.ball.v_WB.z() / end.ball.v_WB.x(), std::tan(kSlope), 1e-3) << speed;
    EXPECT_LT(end.ball.v_WB.norm(), std::cos(kSlope) * speed + 1e-9);
  }
}

TEST(SolverSeams, AWallThatStandsOnTheTilesIsAWall)
{
  std::vector<Shape> all = tiles();
  Shape wall = boxShape({0.1, 1.2, 0.2});
  wall.p_BS = Vector3d(0.55, 0.2, 0.1);  // flush with a seam below it, and its bottom with the tiles
  all.push_back(wall);
  Ride ride;
  ride.v = Vector3d(1.0, 0.3, 0);
  ride.duration = 1.0;
  const End end = endOn(all, ride);
  EXPECT_EQ(end.contacts, 1u);
  EXPECT_NEAR(end.ball.v_WB.x(), -0.8, 1e-9);
  EXPECT_NEAR(end.ball.v_WB.y(), 0.3, 1e-9);
  EXPECT_NEAR(end.ball.p_WB.x(), 0.48 - 0.8 * (1.0 - 0.467), 1e-9);  // 0.467 s to the wall
}

// A crowd is a fine instrument: what differs by a bit anywhere differs everywhere half a second later.
TEST(SolverSeams, ACrowdOnTilesGoesAsOnOneBoard)
{
  const auto crowdOn = [](const std::vector<Shape>& shapes)
  {
    SceneBuilder builder(Method::Impulse);
    builder.gravity(kG).restitution(0.8).body("deck", BodyKind::Static, shapes, at(Vector3d::Zero()));
    for (int i = 0; i < 125; ++i)
      builder.ball({0.25 + 0.045 * (i % 5), 0.05 + 0.045 * (i / 5 % 5), 0.1 + 0.045 * (i / 25)},
                   {0.2 * std::sin(i), 0.2 * std::cos(2.0 * i), 0});
    return builder.world();
  };
  constexpr double kExact = 0.125;  // no corner is rounded [m]
  World seams = crowdOn(tiles(kExact)), whole = crowdOn(board(kExact));
  std::size_t hits = 0;
  for (int i = 0; i < 80; ++i)
  {
    const std::size_t contacts = whole.advance(0.01).contacts;
    EXPECT_EQ(seams.advance(0.01).contacts, contacts);
    hits += contacts;
  }
  EXPECT_GT(hits, 1000u);
  for (std::size_t i = 0; i < whole.ballCount(); ++i)
  {
    EXPECT_EQ(positionOf(seams, i), positionOf(whole, i)) << i;
    EXPECT_EQ(velocityOf(seams, i), velocityOf(whole, i)) << i;
  }
}
}  // namespace
}  // namespace ping_pong
