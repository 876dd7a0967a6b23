// What no law foresees: balls that vanish, lie still or never come back, time that jumps, scenes without a court.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "match_script.h"

namespace ping_pong::game
{
namespace
{
class Trouble : public ::testing::TestWithParam<Player>
{
protected:
  std::string s() const { return name(GetParam()); }
  std::string r() const { return name(other(GetParam())); }
  MatchScript match{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(FromBothSides, Trouble, ::testing::Values(Player::A, Player::B),
                         [](const auto& info) { return name(info.param); });

TEST_P(Trouble, AnotherBallMakesALet)
{
  match.goodService();
  match.anotherBall();
  EXPECT_EQ(match.said(), "let 2.9.2.4");
}

TEST_P(Trouble, TimeThatGoesBackMakesALetAndTheGameGoesOn)
{
  match.goodService();
  const double later = match.time;
  match.time = 0.0;
  match.gap = 0.001;
  match.racket(match.receiver());
  EXPECT_EQ(match.said(), "let 2.9.2.4");
  EXPECT_NE(match.call().reason.find("the time went from " + std::to_string(later).substr(0, 3)), std::string::npos)
      << match.call().reason;
  EXPECT_FALSE(match.hold());
  EXPECT_EQ(match.calls(), 1u);
}

TEST_P(Trouble, ContactsOutOfOrderMakeALet)
{
  match.goodService();
  match.seen(match.ball(0.0, 0.0, 0.3));
  match.gap = -0.01;
  match.racket(match.receiver());
  EXPECT_EQ(match.said(), "let 2.9.2.4");
  EXPECT_EQ(match.umpire().score().strokes, 1);
}

TEST_P(Trouble, ATimeOrPlaceThatIsNotANumberMakesALet)
{
  match.goodService();
  match.umpire().clock(std::nan(""));
  EXPECT_EQ(match.said(), "let 2.9.2.4");
  MatchScript lost(GetParam());
  lost.goodService();
  lost.seen(lost.ball(0.0, std::numeric_limits<double>::infinity(), 0.3));
  EXPECT_EQ(lost.said(), "let 2.9.2.4");
}

// The clock of a game counts what was played, whatever the world's clock does.
TEST_P(Trouble, AResetDoesNotLengthenTheGame)
{
  match.service();
  match.floor();
  match.umpire().clock(500.0);
  match.umpire().clock(0.0);
  match.umpire().clock(90.0);
  EXPECT_FALSE(match.umpire().score().expedite);
  match.umpire().clock(110.0);
  EXPECT_TRUE(match.umpire().score().expedite);
}

TEST_P(Trouble, ABallThatDoesNotComeBackIsDecided)
{
  const auto after = [&](auto begin)
  {
    MatchScript told(GetParam());
    begin(told);
    told.time += 5.1;
    told.seen(told.ball(0.0, 1.2, 0.5, {0, 0, 1.0}));
    return told.said();
  };
  EXPECT_EQ(after([](MatchScript& told) { told.service(); }), "fault 2.6.3 " + r());
  EXPECT_EQ(after([](MatchScript& told) { told.goodService(); }), "point 2.10.1.3 " + s());
  EXPECT_EQ(after([](MatchScript& told) { told.rallyUpToStrokeBy(told.receiver()); }), "point 2.10.1.2 " + s());
  EXPECT_EQ(after([](MatchScript& told) { told.rallyUpToStrokeBy(told.server()); }), "point 2.10.1.2 " + r());
}

TEST_P(Trouble, ABallInTheHandMayBeHeldForLong)
{
  match.hold();
  match.time += 60.0;
  match.umpire().clock(match.time);
  match.floor();  // it is not in play yet
  EXPECT_EQ(match.said(), "");
  EXPECT_EQ(match.umpire().phase(), Phase::InHand);
}

TEST_P(Trouble, ABallThatLiesOrRollsOnACourtIsNotStruckAnyMore)
{
  for (const double speed : {0.0, 0.5})
  {
    MatchScript told(GetParam());
    told.goodService();
    const double side = sign(told.receiver());
    for (int tick = 0; tick < 12 && told.said().empty(); ++tick)
    {
      told.time += 0.01;
      told.seen(told.ball(side * (0.7 + speed * 0.01 * tick), 0, kBallRadius, {side * speed, 0, 0}));
    }
    EXPECT_EQ(told.said(), "point 2.10.1.3 " + s()) << speed;
  }
}

TEST_P(Trouble, ABallFarAwayOrUnderTheFloorIsDecided)
{
  for (const Vector3d& p : {Vector3d(0, 16, 1), Vector3d(0, 3, -2), Vector3d(0, 0, 16)})
  {
    MatchScript told(GetParam());
    told.rallyUpToStrokeBy(told.receiver());
    told.seen(told.ball(p.x(), p.y(), p.z(), {0, 0, -1}));
    EXPECT_EQ(told.said(), "point 2.10.1.2 " + s());
  }
}

TEST_P(Trouble, ALetFromOutsideStopsOnlyAPlay)
{
  EXPECT_TRUE(match.umpire().let(match.time, "the world is paused"));
  match.goodService();
  EXPECT_FALSE(match.umpire().let(match.time, "the world is paused"));
  EXPECT_EQ(match.said(), "let 2.9.2.4");
  EXPECT_EQ(match.call().reason, "the world is paused");
  EXPECT_TRUE(match.umpire().let(match.time, "twice"));
}

TEST_P(Trouble, ServicesOutOfTurnAreRefused)
{
  const Refusal refusal = match.umpire().putInPlay(match.time, {1, kBallRadius, other(GetParam())});
  EXPECT_EQ(refusal.reason, "it is " + s() + "'s turn to serve, not " + r() + "'s");
  EXPECT_TRUE(match.umpire().thrown(match.time, match.ball(0, 0, 0)));
  EXPECT_TRUE(match.umpire().putInPlay(match.time, {1, -1.0, std::nullopt}));
  EXPECT_FALSE(match.umpire().putInPlay(match.time, {1, kBallRadius, GetParam()}));
  EXPECT_EQ(match.umpire().putInPlay(match.time, {2, kBallRadius, GetParam()}).reason, "ball 1 is in play");
  EXPECT_EQ(match.said(), "");
}

/// Anything that can be told, at random.
void tellAnything(MatchScript& match, std::mt19937& random)
{
  const End end = random() % 2 ? End::Plus : End::Minus;
  const double side = sign(end);
  switch (random() % 16)
  {
    case 0:
    case 1:
      match.hold();
      match.throwUp(0.2);
      return match.strikeTossed(0.2);
    case 2:
    case 3:
      return match.court(match.server());
    case 4:
    case 5:
      return match.court(match.receiver());
    case 6:
      return match.racket(end);
    case 7:
      return match.net();
    case 8:
      return match.floor();
    case 9:
      return match.side(end);
    case 10:
      return match.seen(match.ball(side * 1.0, 0, 0.3));
    case 11:
      match.hold();
      return match.throwUp(0.1);
    case 12:
      return static_cast<void>(match.umpire().receiverNotReady(match.time));
    case 13:
      return match.umpire().racketTouchedNet(match.time, end);
    case 14:
      if (random() % 50 == 0) match.anotherBall();
      return;
    default:
      if (random() % 50 == 0) match.time -= 0.5;
      return;
  }
}

// Whatever happens, a rally is decided once, and scores are those of a game of table tennis.
TEST(AnythingTold, LeavesALegalScore)
{
  std::mt19937 random(7);
  MatchScript match(Player::A);
  int sum = 0, decided = 0, matches = 0;
  bool open = false;  // a rally that may be decided
  for (int i = 0; i < 100000; ++i)
  {
    open |= match.umpire().ball().has_value();
    tellAnything(match, random);
    open |= match.umpire().ball().has_value();
    for (const Call& call : match.umpire().takeCalls())
    {
      const auto& [a, b] = call.score.points;
      ASSERT_FALSE(std::max(a, b) > 11 && std::abs(a - b) > 2) << a << ":" << b;
      ASSERT_FALSE(std::max(a, b) > 10 && std::abs(a - b) > 1 && !call.score.game_won) << a << ":" << b;
      if (call.kind == CallKind::Point || call.kind == CallKind::Fault)
      {
        ASSERT_EQ(a + b, sum + 1) << call.reason;
        sum = call.score.game_won ? 0 : a + b;
        ++decided;
      }
      matches += call.kind == CallKind::Match;
      ASSERT_TRUE(call.kind == CallKind::Game || call.kind == CallKind::Match || call.kind == CallKind::ChangeEnds ||
                  call.kind == CallKind::Expedite || open)
          << call.reason;
      open = match.umpire().ball().has_value();
    }
    if (match.umpire().phase() == Phase::MatchOver) match.umpire().newMatch(match.time);
  }
  EXPECT_GT(decided, 10000);
  EXPECT_GT(matches, 100);
}

std::string refusalOf(const Scene& scene)
{
  try
  {
    findCourt(scene);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

std::size_t bodyNamed(const Scene& scene, const std::string& name)
{
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (scene.bodies[b].name == name) return b;
  return kNone;
}

TEST(FindCourt, MeasuresTheTableOfTheUrdf)
{
  const Court court = matchCourt();
  EXPECT_NEAR(court.half_length, 0.5 * kTableLength, 1e-12);
  EXPECT_NEAR(court.half_width, 0.5 * kTableWidth, 1e-12);
  EXPECT_NEAR(court.net_height, kNetHeight, 1e-12);
  EXPECT_NEAR(court.net_half_width, 0.915, 1e-12);
  EXPECT_NEAR((court.X_WT.p - Vector3d(0, 0, kTableHeight)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(court.X_WT.q.angularDistance(Quaterniond::Identity()), 0.0, 1e-7);
}

// A table that stands across has its ends at -y and +y.
TEST(FindCourt, ATableMayStandAnywhere)
{
  Scene scene = matchScene();
  const Pose turn{Vector3d(3, 4, 0), Quaterniond(Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitZ()))};
  for (Body& body : scene.bodies)
  {
    if (body.name == "floor") continue;
    body.pose.p = turn.p + turn.q * body.pose.p;
    body.pose.q = turn.q * body.pose.q;
  }
  const Court court = findCourt(scene);
  EXPECT_EQ(scene.bodies[court.racket[index(End::Minus)]].name, "paddle_a");
  EXPECT_NEAR((court.positionInT({3, 4 + 1.37, kTableHeight}) - Vector3d(1.37, 0, 0)).norm(), 0.0, 1e-12);
}

TEST(FindCourt, ScenesWithoutACourtAreRefused)
{
  Scene none = matchScene();
  none.bodies.erase(none.bodies.begin() + static_cast<long>(bodyNamed(none, "table")));
  EXPECT_NE(refusalOf(none).find("scene 'rally': no table"), std::string::npos) << refusalOf(none);

  Scene two = matchScene();
  two.bodies.push_back(two.bodies[bodyNamed(two, "table")]);
  two.bodies.back().name = "second";
  EXPECT_NE(refusalOf(two).find("two tables, 'table' and 'second'"), std::string::npos) << refusalOf(two);

  Scene bare = matchScene();
  for (std::string& material : bare.materials)
    if (material == "net") material = "string";
  EXPECT_NE(refusalOf(bare).find("no net"), std::string::npos) << refusalOf(bare);

  Scene alone = matchScene();
  alone.bodies.pop_back();
  EXPECT_NE(refusalOf(alone).find("no paddle starts at the +x end"), std::string::npos) << refusalOf(alone);

  Scene crowded = matchScene();
  crowded.bodies.back().pose.p.x() *= -1.0;
  EXPECT_NE(refusalOf(crowded).find("'paddle_a' and 'paddle_b', start at the -x end"), std::string::npos)
      << refusalOf(crowded);
}
}  // namespace
}  // namespace ping_pong::game
