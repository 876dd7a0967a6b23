// Boards whose tops lie flush are one plane: a ball passes over their seams as if there were none. Even a micrometre is a step.
#include <gtest/gtest.h>

#include "testing/contact_scenes.h"

namespace ping_pong
{
namespace
{
constexpr double kTick = 0.01;   // [s]
constexpr double kSame = 1e-13;  // rounding of a metre and of 0.5 m/s over 150 ticks and a few dozen seams

enum class Deck
{
  OneBoard,
  Planks,       ///< 26 of 0.1 m across x, of one body
  PlanksOfTwo,  ///< the same, of two bodies in turn
  Tiles         ///< of 0.1 m by 0.1 m, of one body
};

Shape board(const Vector3d& size, double x, double y)
{
  Shape shape = boxShape(size);
  shape.p_BS = {x, y, -0.5 * size.z()};
  return shape;
}

/// Tops in the plane z = 0 of the deck's frame, from x = -0.5 to 2.1 m. Sums like 0.1 + 0.1 + ... place the seams, rounded as they are.
std::vector<Shape> shapesOf(Deck deck)
{
  if (deck == Deck::OneBoard) return {board({2.6, 1.6, 0.02}, 0.8, 0)};
  std::vector<Shape> shapes;
  double x = -0.45;
  for (int i = 0; i < 26; ++i, x += 0.1)
    if (deck != Deck::Tiles)
      shapes.push_back(board({0.1, 1.6, 0.02}, x, 0));
    else
      for (int k = 0; k < 16; ++k) shapes.push_back(board({0.1, 0.1, 0.02}, x, -0.75 + 0.1 * k));
  return shapes;
}

Scene onDeck(Deck deck, const Pose& pose, const Surface& law, const Twist& twist = {})
{
  SceneBuilder builder;
  builder.gravity(kG);
  const bool moves = !twist.v.isZero(0.0);
  const BodyKind kind = moves ? BodyKind::Kinematic : BodyKind::Static;
  std::vector<Shape> shapes = shapesOf(deck);
  if (deck == Deck::PlanksOfTwo)
  {
    std::vector<Shape> parts[2];
    for (std::size_t i = 0; i < shapes.size(); ++i) parts[i % 2].push_back(shapes[i]);
    builder.body("even", kind, parts[0], pose).body("odd", kind, parts[1], pose);
  }
  else
    builder.body("deck", kind, shapes, pose);
  const Vector3d along = pose.q * Vector3d(0.5, 0.2, 0);
  Scene scene = builder.ball(pose.p + pose.q * Vector3d(0.013, 0.007, kR), along + twist.v).build();
  for (Body& body : scene.bodies) body.twist = twist;
  setSurface(scene, "ball", "wall", law);
  return scene;
}

/// Largest difference from the path on one board [m], [m/s], [rad/s] r.
double differenceFromOneBoard(Deck deck, const Pose& pose, const Surface& law, const Twist& twist = {})
{
  World seams(onDeck(deck, pose, law, twist)), one(onDeck(Deck::OneBoard, pose, law, twist));
  double worst = 0.0;
  for (int i = 0; i < 150; ++i)
  {
    EXPECT_TRUE(seams.advance(kTick).ok() && one.advance(kTick).ok());
    EXPECT_EQ(seams.contacts().size(), 0u) << seams.time();
    const BallState a = seams.ballState(0), b = one.ballState(0);
    worst = std::max({worst, (a.p_WB - b.p_WB).norm(), (a.v_WB - b.v_WB).norm(), kR * (a.w_WB - b.w_WB).norm()});
  }
  return worst;
}

constexpr Deck kDecks[] = {Deck::Planks, Deck::PlanksOfTwo, Deck::Tiles};

TEST(Seams, OnALevelDeckAreNotThere)
{
  double worst = 0.0;
  for (const Deck deck : kDecks)
    for (const double mu : {0.0, 0.3, kInf})
      worst = std::max(worst, differenceFromOneBoard(deck, at({0, 0, 0}), rough(0.8, mu)));
  measured("difference from one board", worst);
  EXPECT_LE(worst, kSame);
  World smooth(onDeck(Deck::Tiles, at({0, 0, 0}), rough(0.8, 0.0)));
  runFor(smooth, 1.5, kTick);
  EXPECT_LE((positionOf(smooth) - Vector3d(0.013 + 0.75, 0.007 + 0.3, kR)).norm(), kSame);
}

TEST(Seams, OnATiltedDeckAreNotThere)
{
  double worst = 0.0;
  for (const Deck deck : kDecks)
    for (const double mu : {0.0, 0.3})
      for (const Pose& pose : {at({0, 0, 0}, 0.05, {0, 1, 0}), at({0.3, -0.2, 1.0}, 0.1, {1, 2, 0.5})})
        worst = std::max(worst, differenceFromOneBoard(deck, pose, rough(0.8, mu)));
  measured("difference from one board", worst);
  EXPECT_LE(worst, 10.0 * kSame);  // planks are placed by turned coordinates, each rounded: tops differ by 1e-16 m
}

TEST(Seams, OfABodyThatMovesAreNotThere)
{
  double worst = 0.0;
  for (const Deck deck : {Deck::Planks, Deck::Tiles})
    for (const double mu : {0.0, 0.3})
      worst = std::max(
          worst, differenceFromOneBoard(deck, at({0, 0, 0}), rough(0.8, mu), {{-0.3, 0.1, 0.2}, Vector3d::Zero()}));
  measured("difference from one board", worst);
  EXPECT_LE(worst, 10.0 * kSame);
}

TEST(Seams, ABallComesToRestOnOneAsOnABoard)
{
  // Within 2 nm of the seam both faces are as near as the edge between them, to a rounding.
  for (const double off : {0.0, 1e-8, -1e-8, 1e-6})
  {
    World world(
        SceneBuilder()
            .gravity(kG)
            .restitution(0.5)
            .body("deck", BodyKind::Static, {board({1, 1, 0.1}, -0.5, 0), board({1, 1, 0.1}, 0.5, 0)}, at({0, 0, 0}))
            .ball({off, 0, kR + 0.1})
            .build());
    const Sum sum = runFor(world, 3.0, kTick);
    EXPECT_TRUE(sum.ok);
    EXPECT_TRUE(world.resting(0)) << off;
    EXPECT_LE((positionOf(world) - Vector3d(off, 0, kR)).norm(), 1e-15) << off;
  }
}

/// Two boards that meet at x = 0, the second higher by `step`.
Scene acrossStep(double step, double e)
{
  return SceneBuilder()
      .gravity(kG)
      .restitution(e)
      .box("first", {1, 1, 0.1}, at({-0.5, 0, -0.05}))
      .box("second", {1, 1, 0.1}, at({0.5, 0, step - 0.05}))
      .ball({-0.1, 0, kR}, {0.5, 0, 0})
      .build();
}

TEST(Seams, AStepUpIsAnImpactHoweverSmall)
{
  for (const double step : {1e-6, 1e-4})
  {
    // The edge is met sqrt(2 r step - step^2) before it, and there the normal is that much tilted back.
    const double before = std::sqrt(2.0 * kR * step - step * step), e = 0.8;
    const Vector3d n = Vector3d(-before, 0, kR - step) / kR;
    World world(acrossStep(step, e));
    const std::vector<Contact> contacts = run(world, 1e-3, 250);
    ASSERT_GE(contacts.size(), 1u) << step;
    EXPECT_NEAR(contacts[0].time, (0.1 - before) / 0.5, 1e-8) << step;  // the root is found to nanometres
    EXPECT_LE((contacts[0].n_W - n).norm(), 1e-6) << step;
    const Vector3d v(0.5, 0, 0);
    EXPECT_LE((contacts[0].v_after - (v - (1.0 + e) * v.dot(n) * n)).norm(), 1e-6) << step;
  }
}

TEST(Seams, AStepDownIsNoImpactButADescent)
{
  for (const double step : {1e-6, 1e-4})
  {
    World world(acrossStep(-step, 0.5));
    const Sum sum = runFor(world, 1.0, kTick);
    EXPECT_TRUE(sum.ok);
    EXPECT_NEAR(positionOf(world).z(), kR - step, 1e-12) << step;
    // v^2 grows by what the step gives, at most; the landing takes the rest.
    EXPECT_GE(velocityOf(world).x(), 0.5);
    EXPECT_LE(velocityOf(world).x(), std::sqrt(0.25 + 2.0 * kG * step)) << step;
  }
}
}  // namespace
}  // namespace ping_pong
