// The key table, keys held together and lost, gliding, and the viewer's axes.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "teleop/follow.h"
#include "teleop/glide.h"
#include "teleop/held_keys.h"

using namespace ping_pong;
using Eigen::Vector3d;

TEST(Keys, EachKeyStandsOnceInTableAndHelp)
{
  std::set<Key> keys;
  for (const KeyEntry& entry : keyTable())
  {
    EXPECT_TRUE(keys.insert(entry.key).second) << entry.label;
    EXPECT_NE(keyHelp().find(std::string(entry.label) + " "), std::string::npos) << entry.label;
  }
  EXPECT_EQ(findKey('5')->group, Group::Paddles);
  EXPECT_EQ(findKey('z'), nullptr);
}

TEST(Keys, HeldTogetherTheyCombineAndOppositesCancel)
{
  HeldKeys held(windowHold());
  held.press('w', 0.0);
  held.press('a', 0.0);
  held.press('v', 0.0);
  EXPECT_EQ(held.wish().move, Vector3d(1, 1, 0));
  EXPECT_EQ(held.wish().turn, Vector3d(0, 0, 1));
  held.press('s', 0.1);
  EXPECT_EQ(held.wish().move, Vector3d(0, 1, 0));
  held.release('w');
  EXPECT_EQ(held.wish().move, Vector3d(-1, 1, 0));
  held.releaseAll();
  EXPECT_TRUE(held.wish().isZero());
}

TEST(Keys, ALostReleaseEndsByItself)
{
  HeldKeys held(windowHold());
  held.press('w', 0.0);
  held.press('a', 0.5);
  held.press('a', 2.9);  // a repetition: the hand is still there
  held.expire(5.0);
  EXPECT_EQ(held.wish().move, Vector3d(1, 1, 0));
  held.expire(5.9);
  EXPECT_FALSE(held.any());
}

TEST(Keys, InATerminalATapIsShortAndRepetitionsHold)
{
  HeldKeys held(terminalHold());
  held.press('w', 0.0);
  held.expire(0.24);
  EXPECT_TRUE(held.any());
  held.expire(0.26);
  EXPECT_FALSE(held.any());
  held.press('w', 0.5);
  for (double t = 0.53; t < 1.0; t += 0.03)
  {
    held.press('w', t);
    held.expire(t);
    EXPECT_TRUE(held.any()) << t;
  }
  held.expire(1.3);
  EXPECT_FALSE(held.any());
}

TEST(Glide, ReachesTopSpeedAndThenRests)
{
  const GlideParams p;
  Glide state;
  for (int i = 0; i < 200; ++i) state = glide(state, {p.acceleration, 0, 0}, Vector3d::Zero(), p.damping, 0.01);
  EXPECT_NEAR(state.v_W.x(), p.acceleration / p.damping, 1e-5);
  int ticks = 0;
  for (; !state.v_W.isZero(0.0); ++ticks) state = glide(state, Vector3d::Zero(), Vector3d::Zero(), p.damping, 0.01);
  // From top speed to 1 mm/s, exponentially; then exactly zero.
  EXPECT_NEAR(0.01 * ticks, std::log(p.acceleration / p.damping / 1e-3) / p.damping, 0.011);
}

TEST(Glide, ALongTickIsAsGoodAsManyShortOnes)
{
  Glide fine;
  for (int i = 0; i < 100; ++i) fine = glide(fine, {1, 2, 3}, {4, 5, 6}, 7.0, 0.001);
  const Glide coarse = glide({}, {1, 2, 3}, {4, 5, 6}, 7.0, 0.1);
  EXPECT_TRUE(fine.v_W.isApprox(coarse.v_W, 1e-12));
  EXPECT_TRUE(fine.w_W.isApprox(coarse.w_W, 1e-12));
}

TEST(Follow, ArrivesWithoutOvershootAtTheSpeedOfASpring)
{
  const Vector3d target(0.3, 0, 0);
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(1.0, Vector3d::UnitZ()));
  Followed hand;
  double fastest = 0.0;
  for (int i = 0; i < 100 && !arrived(hand, target, turned); ++i)
  {
    hand = follow(hand, target, turned, 25.0, 0.01);
    fastest = std::max(fastest, hand.v.x());
    EXPECT_LE(hand.p.x(), 0.3 + 1e-12);
  }
  EXPECT_TRUE(arrived(hand, target, turned));
  EXPECT_NEAR(fastest, 0.3 * 25.0 / std::exp(1.0), 1e-3);  // at t = 1 / rate, a tick's end
  EXPECT_LT(hand.q.angularDistance(turned), 2e-3);
}

TEST(Follow, TheVelocityIsThatOfThePath)
{
  const Followed from{{0.1, 0, 0}, Eigen::Quaterniond::Identity(), {1, -2, 0}, {0, 0, 1}};
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.5, Vector3d::UnitZ()));
  const double h = 1e-6;
  const Followed a = follow(from, {0, 0, 0.2}, turned, 25.0, 0.02);
  const Followed b = follow(from, {0, 0, 0.2}, turned, 25.0, 0.02 + h);
  EXPECT_TRUE(((b.p - a.p) / h).isApprox(a.v, 1e-3));
  EXPECT_NEAR(Eigen::AngleAxisd(b.q * a.q.conjugate()).angle() / h, a.w.norm(), 1e-3 * a.w.norm() + 1e-4);
}

TEST(ViewAxes, AwayIsAwayFromTheViewerAndUpStaysUp)
{
  const Vector3d player_right(0, -1, 0);  // behind the -x end, looking along +x and down
  EXPECT_TRUE(viewAxes(player_right, {0.4, 0, 0.9}).isApprox(Eigen::Matrix3d::Identity(), 1e-12));
  const Vector3d umpire_right(1, 0, 0);  // at -y, looking along +y
  EXPECT_TRUE(viewAxes(umpire_right, {0, 0, 1}).col(0).isApprox(Vector3d::UnitY(), 1e-12));
  EXPECT_TRUE(viewAxes(umpire_right, {0, 1, 0}).col(0).isApprox(Vector3d::UnitY(), 1e-12));  // straight from above
  EXPECT_TRUE(viewAxes({0, 0, 1}, {0, 1, 0}).col(0).isApprox(Vector3d::UnitX(), 1e-12));     // on its side
  for (const double angle : {0.3, 1.7, 4.0})
  {
    const Eigen::Matrix3d axes = viewAxes({std::cos(angle), std::sin(angle), 0.0}, {0, 0, 1});
    EXPECT_NEAR(axes.determinant(), 1.0, 1e-12);
    EXPECT_TRUE(axes.col(2).isApprox(Vector3d::UnitZ(), 1e-12));
  }
}
