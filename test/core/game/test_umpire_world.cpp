// The umpire in a world that changes: paddles that strike and touch the net, balls that vanish, tables that move, resets.
#include <gtest/gtest.h>

#include "flown_match.h"
#include "game/net_touch.h"
#include "testing/scene_builder.h"

namespace ping_pong::game
{
namespace
{
class InWorld : public ::testing::TestWithParam<Player>
{
protected:
  Player me = GetParam();
  std::string s() const { return name(GetParam()); }
  std::string r() const { return name(other(GetParam())); }
  double side = me == Player::A ? -1.0 : 1.0;
};
INSTANTIATE_TEST_SUITE_P(FromBothSides, InWorld, ::testing::Values(Player::A, Player::B),
                         [](const auto& info) { return name(info.param); });

// A paddle swings at a ball that is thrown up beside it: its real touches are one stroke.
TEST_P(InWorld, APaddleServes)
{
  int good = 0;
  for (const double speed : {2.0, 2.5, 3.0, 3.5})
  {
    FlownMatch match(me, {1.9, 0.0, 1.06});
    const std::size_t paddle = match.umpire.court().racket[index(match.umpire.endOf(me))];
    match.toss({side * 1.6, 0.0, 1.05}, 0.3);
    while (match.world.ballState(0).v_WB.z() > -1.9) match.tick();
    match.world.command(paddle, velocityCommand({-side * speed, 0, -0.35 * speed}));
    match.flyUntil(Phase::InCourt);
    EXPECT_EQ(match.umpire.score().strokes, 1) << match.touches << " " << match.said();
    EXPECT_EQ(match.touches[0], 'r');
    good += match.umpire.phase() == Phase::InCourt;
    std::printf("[ measured ] %.1f m/s: %s %s\n", speed, match.touches.c_str(), match.said().c_str());
  }
  EXPECT_GE(good, 1);
}

TEST_P(InWorld, APaddleThatIsStoppedByTheNetTouchesIt)
{
  for (const double speed : {0.2, 3.0, 20.0})
  {
    FlownMatch match(me, {0.25, 0.0, 0.94});
    const std::size_t paddle = match.umpire.court().racket[index(match.umpire.endOf(me))];
    match.world.command(paddle, velocityCommand({-side * speed, 0, 0}));
    match.toss({side * 1.6, 0.5, 1.05}, 4.0);
    match.fly(1.8);
    EXPECT_EQ(match.said(), "point 2.10.1.10 " + r()) << speed;
  }
}

TEST_P(InWorld, APaddleOverTheNetDoesNotTouchIt)
{
  FlownMatch match(me, {0.5, 0.0, kTableHeight + kNetHeight + 0.173});  // the handle reaches 172 mm down
  const std::size_t paddle = match.umpire.court().racket[index(match.umpire.endOf(me))];
  match.world.command(paddle, velocityCommand({-side * 1.0, 0, 0}));
  match.toss({side * 1.6, 0.5, 1.05}, 4.0);
  match.fly(1.0);
  EXPECT_LT(side * match.world.bodyPose(paddle).p.x(), -0.1);
  EXPECT_EQ(match.said(), "");
}

TEST_P(InWorld, ABallThatIsDeletedMakesALet)
{
  FlownMatch match(me);
  match.toss({side * 1.6, 0.0, 1.05}, 0.3);
  match.tick();
  match.world.deleteBall(match.ball());
  match.tick();
  EXPECT_EQ(match.said(), "let 2.9.2.4");
  EXPECT_EQ(match.umpire.calls()[0].reason, "ball " + std::to_string(match.ball()) + " is gone");
}

TEST_P(InWorld, AResetOfTheWorldMakesALetAndTheMatchGoesOn)
{
  FlownMatch match(me);
  match.toss({side * 1.6, 0.0, 1.05}, 0.3);
  for (int i = 0; i < 5; ++i) match.tick();
  match.world.reset();
  match.tick();
  EXPECT_EQ(match.said(), "let 2.9.2.4");
  match.umpire.takeCalls();
  match.toss({side * 1.6, 0.0, 1.05}, 0.3);
  match.tick();
  EXPECT_EQ(match.umpire.phase(), Phase::Toss);
}

TEST_P(InWorld, ATableThatIsMovedMakesALetAndIsTheCourtFromThenOn)
{
  FlownMatch match(me);
  match.toss({side * 1.6, 0.0, 1.05}, 0.3);
  match.tick();
  Pose moved = match.world.bodyPose(match.umpire.court().table);
  moved.p.y() += 0.3;
  match.world.setBodyPose(match.umpire.court().table, moved);
  match.tick();
  EXPECT_EQ(match.said(), "let 2.9.2.4");
  EXPECT_NEAR(match.umpire.court().X_WT.p.y(), 0.3, 1e-12);
  match.tick();
  EXPECT_EQ(match.umpire.calls().size(), 1u);
}

TEST(Gap, IsThatOfClosedForms)
{
  const auto expectGap = [](double gap, const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB)
  {
    EXPECT_FALSE(nearerThan(gap - 1e-5, a, X_WA, b, X_WB)) << gap;
    EXPECT_TRUE(nearerThan(gap + 1e-5, a, X_WA, b, X_WB)) << gap;
    EXPECT_FALSE(nearerThan(gap - 1e-5, b, X_WB, a, X_WA)) << gap;
    EXPECT_TRUE(nearerThan(gap + 1e-5, b, X_WB, a, X_WA)) << gap;
  };
  const Shape box = boxShape({2, 2, 2});
  const Pose here = at({0, 0, 0});
  expectGap(1.0, box, here, box, at({3, 0.5, 0.5}));                                     // faces
  expectGap(std::sqrt(8.0), box, here, box, at({4, 4, 0}));                              // edges
  expectGap(std::sqrt(3.0) - 0.5, box, here, sphereShape(0.5), at({2, 2, 2}));           // a corner
  expectGap(0.3, box, here, box, at({0, 0, 1.3 + std::sqrt(2.0)}, kPi / 4, {1, 0, 0}));  // an edge over a face
  expectGap(0.2, box, here, cylinderShape(0.5, 1.0), at({0, 0, 1.7}, kPi / 2, {0, 1, 0}));
  expectGap(0.3, box, here, box,
            at({0, 0, 1.3 + std::cos(0.01) + std::sin(0.01)}, 0.01, {1, 0, 0}));  // almost parallel
  EXPECT_TRUE(nearerThan(1e-9, box, here, box, at({1.9, 0, 0})));                 // overlap
}
}  // namespace
}  // namespace ping_pong::game
