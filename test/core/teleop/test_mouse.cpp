// What the mouse does to a paddle: reach, the plane of the hand, strokes, and help.
#include <gtest/gtest.h>

#include <cmath>

#include "teleop/glide.h"
#include "teleop/play_hand.h"

using namespace ping_pong;
using Eigen::Vector3d;

namespace
{
constexpr double kTick = 0.01;  ///< [s]

// The middle of a table's surface, as in the scenes.
Eigen::Isometry3d table()
{
  return Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.76));
}

BallSight comingBall()
{
  return {{1.5, 0.1, 0.4}, {-4.0, 0.0, 0.0}, Vector3d::Zero()};
}

Vector3d normalOf(const Eigen::Quaterniond& q)
{
  return q * Vector3d::UnitX();
}
}  // namespace

TEST(Reach, EitherEndSeesTheNetInFrontOfIt)
{
  const TableEnd near = nearerEnd(table(), {-1.6, 0.2, 1.0});
  EXPECT_EQ(near.sign, -1.0);
  EXPECT_TRUE((near.X_WE * Vector3d(1.37, 0, 0)).isApprox(Vector3d(0, 0, 0.76), 1e-12));
  const TableEnd far = nearerEnd(table(), {1.6, 0.2, 1.0});
  EXPECT_EQ(far.sign, 1.0);
  EXPECT_TRUE((far.X_WE * Vector3d(-0.3, 0.1, 0.2)).isApprox(Vector3d(1.67, -0.1, 0.96), 1e-12));
}

TEST(Reach, AKeyHeldForASecondStaysWithin)
{
  const Reach reach;
  const GlideParams keys;
  for (const Vector3d& push : {Vector3d(1, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, -1, 0.0),
                               Vector3d(0, 0, 1), Vector3d(0, 0, -1), Vector3d(1, 1, 1)})
  {
    Glide state;
    Vector3d p(-0.2, 0.0, 0.2);
    for (int i = 0; i < 300; ++i)
    {
      state = glide(state, keys.acceleration * push, Vector3d::Zero(), keys.damping, kTick);
      state.v_W = slowedAtBorder(reach, p, state.v_W, keys.damping);
      p += kTick * state.v_W;
      ASSERT_TRUE(contains(reach, p)) << p.transpose();
    }
    EXPECT_LT((p - clampTo(reach, p + push)).norm(), 1e-3) << "it gets to the border";
  }
}

TEST(Reach, WithinItNothingIsSlowedThatStopsInTime)
{
  const Reach reach;
  const Vector3d v(2.0, -1.0, 0.5);
  EXPECT_EQ(slowedAtBorder(reach, {-0.5, 0, 0.3}, v, 14.0), v);
  // Outside it leads back.
  const Vector3d outside(1.0, 0, 0.3);
  EXPECT_EQ(slowedAtBorder(reach, outside, {1, 0, 0}, 14.0), Vector3d(-0.5, 0, 0));
  EXPECT_EQ(slowedAtBorder(reach, outside, {-1, 0, 0}, 14.0), Vector3d(-1, 0, 0));
}

TEST(Plane, TheRayThroughTheMouseMeetsItInFrontOfTheEyeOnly)
{
  const Vector3d eye(-3.0, 0.0, 1.5);
  const auto hit = onPlane(eye, Vector3d(2.5, 0.5, -1.0), -0.5);
  ASSERT_TRUE(hit);
  EXPECT_TRUE(hit->isApprox(Vector3d(-0.5, 0.5, 0.5), 1e-12));
  EXPECT_FALSE(onPlane(eye, Vector3d(-1, 0, 0), -0.5)) << "behind the eye";
  EXPECT_FALSE(onPlane(eye, Vector3d(0, 0, -1), -0.5)) << "along the plane";
}

TEST(Swing, GoesThroughTheHandsPlaceWithItsSpeedAndEndsThere)
{
  const Swing swing{{4.0, 0.0, 2.0}, 1.0, 0.1};
  EXPECT_TRUE(at(swing, 1.0).p.isZero(1e-12));
  EXPECT_TRUE(at(swing, 1.0).v.isApprox(swing.v, 1e-12));
  for (const double time : {0.9, 1.1, 0.5, 2.0})
  {
    EXPECT_TRUE(at(swing, time).p.isZero(1e-9)) << time;
    EXPECT_TRUE(at(swing, time).v.isZero(1e-9)) << time;
  }
  // The speed is that of the way.
  const double h = 1e-6;
  for (double t = 0.91; t < 1.1; t += 0.03)
  {
    const Vector3d slope = (at(swing, t + h).p - at(swing, t - h).p) / (2 * h);
    EXPECT_LT((slope - at(swing, t).v).norm(), 1e-6) << t;
  }
}

TEST(PlayHand, FollowsTheMouseWithinReachAndTheWheelTilts)
{
  PlayHand hand;
  PlayParams params;
  params.assistance = 0.0;
  hand.setParams(params);
  hand.point({0.0, 5.0, 0.3}, Reach());
  for (int i = 0; i < 100; ++i) hand.move(kTick, {});
  EXPECT_LT((hand.blade().p - Vector3d(params.depth, Reach().side, 0.3)).norm(), 1e-3);
  EXPECT_LT((normalOf(hand.blade().q) - Vector3d::UnitX()).norm(), 1e-2);
  hand.tilt(0.4);
  for (int i = 0; i < 100; ++i) hand.move(kTick, {});
  EXPECT_NEAR(std::asin(normalOf(hand.blade().q).z()), 0.4, 1e-2);
}

TEST(PlayHand, AButtonStrikesForwardOnce)
{
  PlayHand hand;
  hand.point({0.0, 0.0, 0.2}, Reach());
  for (int i = 0; i < 100; ++i) hand.move(kTick, {});
  hand.stroke(true);
  double fastest = 0.0, up = 0.0;
  for (int i = 0; i < 30; ++i)
  {
    hand.move(kTick, {});
    if (hand.blade().v.x() > fastest) up = hand.blade().v.z();
    fastest = std::max(fastest, hand.blade().v.x());
  }
  EXPECT_GT(fastest, 0.9 * hand.params().stroke_speed * std::cos(0.6));
  EXPECT_GT(up, 1.0) << "a drive goes up";
  EXPECT_LT(hand.blade().v.norm(), 0.05) << "and is over";
}

TEST(Assistance, TheMirrorSendsTheBallToTheOtherHalf)
{
  Followed hand;
  hand.p = {-0.3, 0.1, 0.2};
  const std::optional<Help> help = mirrorHelp(comingBall(), hand);
  ASSERT_TRUE(help);
  EXPECT_GT(help->in, 0.3);
  EXPECT_LT(help->in, 0.6);
  EXPECT_GT(normalOf(help->q).x(), 0.5);
  EXPECT_LT(normalOf(help->q).y(), 0.0) << "back to the middle";
  EXPECT_GT(help->v.x(), 0.5) << "a blade that waits would not carry it over the net";
  EXPECT_FALSE(mirrorHelp({{1.5, 0, 0.4}, {4.0, 0, 0}, Vector3d::Zero()}, hand)) << "it flies away";
  EXPECT_FALSE(mirrorHelp({{2.5, 0, 0.1}, {-2.0, 0, 0}, Vector3d::Zero()}, hand)) << "it lands on the other half first";
}

TEST(Assistance, NoneLeavesTheHandAloneAndAllOfItKeepsItsPlace)
{
  for (const double amount : {0.0, 1.0})
  {
    PlayHand hand;
    PlayParams params;
    params.assistance = amount;
    hand.setParams(params);
    hand.point({0.0, 0.4, 0.3}, Reach());
    for (int i = 0; i < 100; ++i) hand.move(kTick, {});
    BallSight ball = comingBall();
    double fastest = 0.0;
    for (int i = 0; i < 60 && ball.p.x() > -0.3; ++i)
    {
      ball.p += kTick * ball.v;
      ball.v.z() -= 9.81 * kTick;
      if (ball.p.z() < 0.02) ball.v.z() = std::abs(ball.v.z());
      hand.move(kTick, ball);
      fastest = std::max(fastest, hand.blade().v.norm());
      EXPECT_NEAR(hand.blade().p.y(), 0.4, 0.1) << "the hand is carried nowhere";
    }
    EXPECT_EQ(fastest > 0.5, amount > 0.5);
  }
}

TEST(Assistance, AThrownBallIsServedFromWhereItFalls)
{
  Followed hand;
  hand.p = {-0.3, 0.0, 0.2};
  const std::optional<Help> help = mirrorHelp({{-0.12, 0.0, 0.45}, Vector3d::Zero(), Vector3d::Zero()}, hand);
  ASSERT_TRUE(help);
  EXPECT_NEAR(help->depth, -0.15, 1e-9) << "just behind the ball";
  EXPECT_NEAR(help->in, std::sqrt(2.0 * 0.25 / 9.81), 1e-9);
  EXPECT_GT(help->v.x(), 2.0);
  EXPECT_FALSE(mirrorHelp({{-0.12, 0.0, 0.1}, Vector3d::Zero(), Vector3d::Zero()}, hand)) << "too low";
}
