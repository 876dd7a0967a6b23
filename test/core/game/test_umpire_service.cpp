// Services, clause by clause, from both sides: scripted touches.
#include <gtest/gtest.h>

#include "match_script.h"

namespace ping_pong::game
{
namespace
{
class Serving : public ::testing::TestWithParam<Player>
{
protected:
  std::string s() const { return name(GetParam()); }         // who serves
  std::string r() const { return name(other(GetParam())); }  // who receives
  /// Held where `held` is from the palm, thrown with v, struck after `fall` [s] of free flight there.
  std::string served(const Vector3d& held, const Vector3d& v, double fall)
  {
    MatchScript told(GetParam());
    told.hold();
    const double side = sign(told.server());
    const Vector3d p = told.palm(told.server()) + Vector3d(side * held.x(), held.y(), held.z());
    told.umpire().thrown(told.time, told.ball(p.x(), p.y(), p.z(), {side * v.x(), v.y(), v.z()}));
    told.gap = fall;
    told.racketAt(told.server(),
                  p + fall * Vector3d(side * v.x(), v.y(), v.z()) - 0.5 * 9.81 * fall * fall * Vector3d::UnitZ(),
                  {side * v.x(), v.y(), v.z() - 9.81 * fall});
    return told.said();
  }
  MatchScript match{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(FromBothSides, Serving, ::testing::Values(Player::A, Player::B),
                         [](const auto& info) { return name(info.param); });

double upBy(double height)
{
  return std::sqrt(2.0 * 9.81 * height);
}

// 2.6.2: "at least 16 cm".
TEST_P(Serving, ATossOf16CmIsEnoughAndOf15IsNot)
{
  EXPECT_EQ(served({0, 0, 0}, {0, 0, upBy(0.16)}, 2.0 * upBy(0.16) / 9.81), "");
  EXPECT_EQ(served({0, 0, 0}, {0, 0, upBy(0.159)}, 2.0 * upBy(0.159) / 9.81), "fault 2.6.2 " + r());
  EXPECT_EQ(served({0, 0, 0}, {0, 0, upBy(0.15)}, 2.0 * upBy(0.15) / 9.81), "fault 2.6.2 " + r());
  EXPECT_EQ(served({0, 0, 0}, {0, 0, upBy(2.0)}, 2.0 * upBy(2.0) / 9.81), "");
}

// The height that counts is that above the palm, seen at the ends of ticks or not.
TEST_P(Serving, TheTopOfATossIsFoundBetweenTicks)
{
  match.hold();
  match.throwUp(0.16);
  const Vector3d palm = match.palm(match.server());
  const double start = match.time, flight = 2.0 * upBy(0.16) / 9.81;
  for (double t = 0.05; t < flight; t += 0.1)
  {
    match.time = start + t;
    match.seen(
        match.ball(palm.x(), palm.y(), palm.z() + upBy(0.16) * t - 0.5 * 9.81 * t * t, {0, 0, upBy(0.16) - 9.81 * t}));
  }
  match.gap = start + flight - match.time;
  match.racketAt(match.server(), palm, {0, 0, -upBy(0.16)});
  EXPECT_EQ(match.said(), "");
  EXPECT_EQ(match.umpire().phase(), Phase::ServiceStruck);
}

TEST_P(Serving, ATossIsNearlyVerticalAndWithoutSpin)
{
  EXPECT_EQ(served({0.3, 0, 0}, {0.5 * upBy(0.2), 0, upBy(0.2)}, 0.4), "");
  EXPECT_EQ(served({0.3, 0, 0}, {0.7 * upBy(0.2), 0, upBy(0.2)}, 0.4), "fault 2.6.2 " + r());
  match.hold();
  BallState spinning = match.ball(sign(match.server()) * 1.6, 0, 0.2, {0, 0, 2.0});
  spinning.w_WB = Vector3d(0, 10, 0);
  match.umpire().thrown(match.time, spinning);
  EXPECT_EQ(match.said(), "fault 2.6.2 " + r());
}

TEST_P(Serving, ABallStruckOutOfTheHandIsAFault)
{
  match.hold();
  match.racket(match.server());
  EXPECT_EQ(match.said(), "fault 2.6.2 " + r());
}

TEST_P(Serving, ATossTouchesNothingBeforeItIsStruck)
{
  match.hold();
  match.throwUp(0.2);
  match.floor();
  EXPECT_EQ(match.said(), "fault 2.6.2 " + r());
}

// 2.6.3: struck as it falls.
TEST_P(Serving, ABallStruckAsItRisesIsAFault)
{
  EXPECT_EQ(served({0, 0, 0}, {0, 0, upBy(0.3)}, 0.1), "fault 2.6.3 " + r());
  EXPECT_EQ(served({0, 0, 0}, {0, 0, upBy(0.3)}, upBy(0.3) / 9.81), "");  // at the very top it has risen no more
}

// 2.6.4: behind the end line, above the level of the playing surface, all of the ball, all of the time.
TEST_P(Serving, TheBallIsBehindTheEndLine)
{
  const double line = 1.37 + kBallRadius - 1.6;  // from the palm's place, outwards
  EXPECT_EQ(served({line, 0, 0}, {0, 0, upBy(0.2)}, 0.4), "");
  EXPECT_EQ(served({line - 0.001, 0, 0}, {0, 0, upBy(0.2)}, 0.4), "fault 2.6.4 " + r());
  EXPECT_EQ(served({line + 0.01, 0, 0}, {-0.1, 0, upBy(0.2)}, 0.4), "fault 2.6.4 " + r());  // thrown over the line
  EXPECT_EQ(served({line, 3.0, 0}, {0, 0, upBy(0.2)}, 0.4), "");                            // it has no ends (2.5.15)
}

TEST_P(Serving, TheBallIsAboveTheLevelOfThePlayingSurface)
{
  const double level = kBallRadius - 0.2;
  EXPECT_EQ(served({0, 0, level}, {0, 0, upBy(0.2)}, 0.4), "");
  EXPECT_EQ(served({0, 0, level - 0.001}, {0, 0, upBy(0.2)}, 0.4), "fault 2.6.4 " + r());
  EXPECT_EQ(served({0, 0, level + 0.01}, {0, 0, upBy(0.2)}, 0.45), "fault 2.6.4 " + r());  // struck too low
}

TEST_P(Serving, ATossThatIsNotStruckIsAFaultOnceItIsTooLow)
{
  match.hold();
  match.throwUp(0.2);
  const Vector3d palm = match.palm(match.server());
  match.time += 0.5;
  match.seen(match.ball(palm.x(), palm.y(), 0.01, {0, 0, -3.0}));
  EXPECT_EQ(match.said(), "fault 2.6.4 " + r());
}

// 2.6.3: the own court, then the receiver's.
TEST_P(Serving, AServiceTouchesTheOwnCourtFirst)
{
  match.service();
  match.court(match.receiver());
  EXPECT_EQ(match.said(), "fault 2.6.3 " + r());
  MatchScript into_net(GetParam());
  into_net.service();
  into_net.net();
  EXPECT_EQ(into_net.said(), "fault 2.6.3 " + r());
  MatchScript off_the_table(GetParam());
  off_the_table.service();
  off_the_table.floor();
  EXPECT_EQ(off_the_table.said(), "fault 2.6.3 " + r());
}

TEST_P(Serving, AServiceTouchesTheOwnCourtOnce)
{
  match.service();
  match.court(match.server());
  match.court(match.server());
  EXPECT_EQ(match.said(), "fault 2.6.3 " + r());
}

TEST_P(Serving, AServiceBesideTheReceiversCourtIsAFault)
{
  match.service();
  match.court(match.server());
  match.side(match.receiver());
  EXPECT_EQ(match.said(), "fault 2.6.3 " + r());
  MatchScript too_long(GetParam());
  too_long.service();
  too_long.court(too_long.server());
  too_long.seen(too_long.ball(sign(too_long.receiver()) * 1.4, 0, 0.3));
  EXPECT_EQ(too_long.said(), "fault 2.6.3 " + r());
}

// 2.9.1.1
TEST_P(Serving, AnOtherwiseGoodServiceOffTheNetIsALet)
{
  match.service();
  match.court(match.server());
  match.net();
  match.court(match.receiver());
  EXPECT_EQ(match.said(), "let 2.9.1.1");
  EXPECT_EQ(match.umpire().score().points[0] + match.umpire().score().points[1], 0);
  EXPECT_EQ(match.umpire().score().server, GetParam());
  EXPECT_EQ(match.umpire().score().service, 1);
}

TEST_P(Serving, AServiceOffTheNetThatFailsIsAFault)
{
  match.service();
  match.court(match.server());
  match.post();
  match.floor();
  EXPECT_EQ(match.said(), "fault 2.6.3 " + r());
}

TEST_P(Serving, AServiceThatTheReceiverObstructs)
{
  const auto obstructed = [&](bool net)
  {
    MatchScript told(GetParam());
    told.service();
    told.court(told.server());
    if (net) told.net();
    told.racketAt(told.receiver(), {sign(told.receiver()) * 0.9, 0, 0.3}, {sign(told.receiver()) * 4.0, 0, 0});
    return told.said();
  };
  EXPECT_EQ(obstructed(true), "let 2.9.1.1");
  EXPECT_EQ(obstructed(false), "point 2.10.1.6 " + s());

  MatchScript out(GetParam());  // past the end line already: no service any more that could be good
  out.service();
  out.court(out.server());
  out.net();
  out.racketAt(out.receiver(), {sign(out.receiver()) * 1.5, 0, 0.3}, {sign(out.receiver()) * 4.0, 0, 0});
  EXPECT_EQ(out.said(), "fault 2.6.3 " + r());
}

TEST_P(Serving, AServiceStruckTwiceIsLost)
{
  match.service();
  match.racket(match.server());
  EXPECT_EQ(match.said(), "point 2.10.1.7 " + r());
}

TEST_P(Serving, ATossThatTheReceiverTouchesIsALet)
{
  match.hold();
  match.throwUp(0.2);
  match.racket(match.receiver());
  EXPECT_EQ(match.said(), "let 2.9.2.4");
}

// 2.9.1.2
TEST_P(Serving, AReceiverWhoWasNotReadyMayNotHaveStruck)
{
  match.goodService();
  EXPECT_FALSE(match.umpire().receiverNotReady(match.time));
  EXPECT_EQ(match.said(), "let 2.9.1.2");
  EXPECT_TRUE(match.umpire().receiverNotReady(match.time));  // nothing to stop any more

  MatchScript struck(GetParam());
  struck.rallyUpToStrokeBy(struck.receiver());
  EXPECT_TRUE(struck.umpire().receiverNotReady(struck.time));
  EXPECT_EQ(struck.said(), "");
}

TEST_P(Serving, RelaxedRulesAskForNoTossAndNoPlace)
{
  MatchScript relaxed(GetParam(), rulesPreset("relaxed"));
  relaxed.hold();
  relaxed.racketAt(relaxed.server(), {sign(relaxed.server()) * 1.0, 0, 0.3}, {0, 0, 1.0});
  EXPECT_EQ(relaxed.said(), "");
  relaxed.court(relaxed.receiver());
  EXPECT_EQ(relaxed.said(), "fault 2.6.3 " + r());  // but for the own court first
}
}  // namespace
}  // namespace ping_pong::game
