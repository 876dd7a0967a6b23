// Calls of the umpire in rallies, clause by clause, from both sides: scripted touches.
#include <gtest/gtest.h>

#include "match_script.h"

namespace ping_pong::game
{
namespace
{
class Umpiring : public ::testing::TestWithParam<Player>
{
protected:
  std::string s() const { return name(GetParam()); }         // who serves
  std::string r() const { return name(other(GetParam())); }  // who receives
  MatchScript match{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(FromBothSides, Umpiring, ::testing::Values(Player::A, Player::B),
                         [](const auto& info) { return name(info.param); });

TEST_P(Umpiring, ARallyGoesThroughThePhasesThatThePageDraws)
{
  EXPECT_EQ(match.umpire().phase(), Phase::BeforeService);
  match.hold();
  EXPECT_EQ(match.umpire().phase(), Phase::InHand);
  match.throwUp(0.2);
  EXPECT_EQ(match.umpire().phase(), Phase::Toss);
  match.strikeTossed(0.2);
  EXPECT_EQ(match.umpire().phase(), Phase::ServiceStruck);
  match.court(match.server());
  EXPECT_EQ(match.umpire().phase(), Phase::ServiceBounced);
  match.court(match.receiver());
  EXPECT_EQ(match.umpire().phase(), Phase::InCourt);
  match.racket(match.receiver());
  EXPECT_EQ(match.umpire().phase(), Phase::ReturnStruck);
  match.court(match.server());
  EXPECT_EQ(match.umpire().phase(), Phase::InCourt);
  EXPECT_EQ(match.umpire().score().strokes, 2);
  EXPECT_EQ(match.said(), "");
}

// 2.7.1: over, around, or off the net assembly.
TEST_P(Umpiring, AReturnMayTouchTheNetAssembly)
{
  match.rallyUpToStrokeBy(match.receiver());
  match.net();
  match.post();
  match.court(match.server());
  EXPECT_EQ(match.said(), "");
  EXPECT_EQ(match.umpire().phase(), Phase::InCourt);
}

// 2.1.1: the edge of the top belongs to the playing surface; 2.1.2: the side does not.
TEST_P(Umpiring, TheEdgeOfTheTopIsCourtAndTheSideIsNot)
{
  match.rallyUpToStrokeBy(match.receiver());
  match.edge(match.server());
  EXPECT_EQ(match.umpire().phase(), Phase::InCourt);
  match.racket(match.server());
  match.side(match.receiver());
  EXPECT_EQ(match.said(), "point 2.10.1.2 " + r());
}

// 2.10.1.2
TEST_P(Umpiring, AReturnOntoTheOwnCourtIsLost)
{
  match.rallyUpToStrokeBy(match.receiver());
  match.court(match.receiver());
  EXPECT_EQ(match.said(), "point 2.10.1.2 " + s());
}

TEST_P(Umpiring, AReturnIntoTheNetAndBackIsLost)
{
  match.rallyUpToStrokeBy(match.server());
  match.net();
  match.court(match.server());
  EXPECT_EQ(match.said(), "point 2.10.1.2 " + r());
}

TEST_P(Umpiring, AReturnOntoFloorOrLegIsLost)
{
  match.rallyUpToStrokeBy(match.server());
  match.floor();
  EXPECT_EQ(match.said(), "point 2.10.1.2 " + r());
  MatchScript again(GetParam());
  again.rallyUpToStrokeBy(again.receiver());
  again.leg();
  EXPECT_EQ(again.said(), "point 2.10.1.2 " + s());
  EXPECT_NE(again.call().reason.find("leg"), std::string::npos) << again.call().reason;
}

// 2.10.1.3
TEST_P(Umpiring, ADoubleBounceIsLostByThePlayerWhoseCourtItIs)
{
  match.goodService();
  match.court(match.receiver());
  EXPECT_EQ(match.said(), "point 2.10.1.3 " + s());
}

TEST_P(Umpiring, ABallNotStruckBeforeItTouchesAnythingElseIsLost)
{
  match.rallyUpToStrokeBy(match.receiver());
  match.court(match.server());
  match.floor();
  EXPECT_EQ(match.said(), "point 2.10.1.3 " + r());
}

// A ball that spins back over the net: the receiver has to reach it before it touches anything.
TEST_P(Umpiring, ABallThatSpinsBackOverTheNetIsLostOnTheOpponentsCourt)
{
  match.goodService();
  match.net();
  EXPECT_EQ(match.said(), "");
  match.court(match.server());
  EXPECT_EQ(match.said(), "point 2.10.1.3 " + s());
}

// 2.10.1.4
TEST_P(Umpiring, ABallBeyondTheEndLineIsOutOnceAllOfItIsPast)
{
  match.rallyUpToStrokeBy(match.receiver());
  const double side = sign(match.server());
  match.time += 0.1;
  match.seen(match.ball(side * (1.37 + 0.019), 0.0, 0.2, {side * 6.0, 0, 0}));
  EXPECT_EQ(match.said(), "");
  match.seen(match.ball(side * (1.37 + 0.0201), 0.0, 0.2, {side * 6.0, 0, 0}));
  EXPECT_EQ(match.said(), "point 2.10.1.4 " + s());
}

TEST_P(Umpiring, ABallThatWasOutIsNotObstructed)
{
  match.rallyUpToStrokeBy(match.receiver());
  match.racketAt(match.server(), {sign(match.server()) * 1.5, 0.0, 0.3}, {sign(match.server()) * 6.0, 0, 0});
  EXPECT_EQ(match.said(), "point 2.10.1.4 " + s());
}

// 2.10.1.5: methods that look at the ends of steps let fast balls through.
TEST_P(Umpiring, ABallThroughTheNetIsLost)
{
  match.rallyUpToStrokeBy(match.receiver());
  const double side = sign(match.server());
  match.seen(match.ball(-side * 0.1, 0.0, 0.1));
  match.time += 0.01;
  match.seen(match.ball(side * 0.1, 0.0, 0.1));
  EXPECT_EQ(match.said(), "point 2.10.1.5 " + s());
}

TEST_P(Umpiring, ABallOverOrAroundTheNetIsNotThroughIt)
{
  match.rallyUpToStrokeBy(match.receiver());
  const double side = sign(match.server());
  match.seen(match.ball(-side * 0.1, 0.0, 0.18));
  match.seen(match.ball(side * 0.1, 0.0, 0.18));
  match.seen(match.ball(side * 0.1, 1.1, 0.05));
  match.seen(match.ball(-side * 0.1, 1.1, 0.05));
  EXPECT_EQ(match.said(), "");
}

// 2.5.8 and 2.10.1.6
TEST_P(Umpiring, AVolleyOverThePlayingSurfaceObstructs)
{
  match.rallyUpToStrokeBy(match.receiver());
  match.racketAt(match.server(), {sign(match.server()) * 1.2, 0.0, 0.3}, {sign(match.server()) * 6.0, 0, 0});
  EXPECT_EQ(match.said(), "point 2.10.1.6 " + r());
}

TEST_P(Umpiring, AVolleyBesideTheTableObstructsOnlyABallOnItsWayToTheTable)
{
  const auto volley = [&](double v_y)
  {
    MatchScript told(GetParam());
    told.rallyUpToStrokeBy(told.receiver());
    told.racketAt(told.server(), {sign(told.server()) * 0.6, 1.0, 0.2}, {sign(told.server()) * 2.0, v_y, 0});
    return told.said();
  };
  EXPECT_EQ(volley(-2.0), "point 2.10.1.6 " + r());
  EXPECT_EQ(volley(+2.0), "point 2.10.1.4 " + s());
}

// 2.10.1.7; touches within 50 ms of the first are one stroke.
TEST_P(Umpiring, TwoTouchesWithin50MsAreOneStroke)
{
  match.rallyUpToStrokeBy(match.receiver());
  match.gap = 0.03;
  match.racket(match.receiver());
  EXPECT_EQ(match.said(), "");
  EXPECT_EQ(match.umpire().score().strokes, 2);
  match.racket(match.receiver());  // 60 ms after the first
  EXPECT_EQ(match.said(), "point 2.10.1.7 " + s());
}

TEST_P(Umpiring, TwoStrokesInSuccessionAreLost)
{
  match.rallyUpToStrokeBy(match.receiver());
  match.racket(match.receiver());
  EXPECT_EQ(match.said(), "point 2.10.1.7 " + s());

  MatchScript off_the_net(GetParam());
  off_the_net.rallyUpToStrokeBy(off_the_net.server());
  off_the_net.gap = 0.02;
  off_the_net.net();
  off_the_net.racket(off_the_net.server());  // soon, but something was touched between
  EXPECT_EQ(off_the_net.said(), "point 2.10.1.7 " + r());
}

TEST_P(Umpiring, WhoStruckLastMayNotStrikeABallThatIsInTheOpponentsCourt)
{
  match.goodService();
  match.racket(match.server());
  EXPECT_EQ(match.said(), "point 2.10.1.7 " + r());
}

// 2.10.1.9, 2.10.1.10
TEST_P(Umpiring, ARacketAtTheNetIsLost)
{
  match.rallyUpToStrokeBy(match.receiver());
  match.umpire().racketTouchedNet(match.time, match.receiver());
  EXPECT_EQ(match.said(), "point 2.10.1.10 " + s());
}

TEST_P(Umpiring, WhoMovesTheTableLosesAndWhatElseMovesItMakesALet)
{
  match.rallyUpToStrokeBy(match.receiver());
  match.umpire().tableMoved(match.time, match.umpire().court().X_WB, other(GetParam()));
  EXPECT_EQ(match.said(), "point 2.10.1.9 " + s());

  MatchScript pushed(GetParam());
  pushed.goodService();
  Pose there = pushed.umpire().court().X_WB;
  there.p += Vector3d(0.0, 0.5, 0.0);
  pushed.umpire().tableMoved(pushed.time, there);
  EXPECT_EQ(pushed.said(), "let 2.9.2.4");
  EXPECT_NEAR(pushed.umpire().court().positionInT({0.0, 0.5, kTableHeight}).norm(), 0.0, 1e-12);
}

TEST_P(Umpiring, AfterAPointNothingCounts)
{
  match.goodService();
  match.court(match.receiver());
  const Score then = match.umpire().score();
  match.racket(match.receiver());
  match.floor();
  match.anotherBall();
  match.umpire().racketTouchedNet(match.time, End::Minus);
  match.seen(match.ball(9.0, 9.0, -0.7));
  EXPECT_EQ(match.calls(), 1u);
  EXPECT_EQ(match.umpire().score().points, then.points);
  EXPECT_EQ(match.umpire().score().strokes, 1);
}

TEST_P(Umpiring, TouchesOfOtherBallsDoNotCount)
{
  match.goodService();
  Contact contact;
  contact.time = match.time;
  contact.ball = 99;
  contact.body = match.umpire().court().table;
  contact.shape = 0;
  contact.p_WC = Vector3d(0.7, 0, kTableHeight);
  match.umpire().contact(contact);
  EXPECT_EQ(match.said(), "");
}
}  // namespace
}  // namespace ping_pong::game
