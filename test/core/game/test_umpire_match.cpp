// What the umpire says of a whole match: points, games, ends, expedite system, preset `rally`.
#include <gtest/gtest.h>

#include <limits>

#include "match_script.h"

namespace ping_pong::game
{
namespace
{
class Match : public ::testing::TestWithParam<Player>
{
protected:
  std::string s() const { return name(GetParam()); }
  std::string r() const { return name(other(GetParam())); }
  /// A rally that `winner` wins by a double bounce, or by a fault of the opponent.
  static void rallyWonBy(MatchScript& match, Player winner)
  {
    const bool served = match.umpire().score().server == winner;
    match.service();
    if (served)
    {
      match.court(match.server());
      match.court(match.receiver());
      const End receiver = match.receiver();
      match.court(receiver);
    }
    else
      match.floor();
  }
};
INSTANTIATE_TEST_SUITE_P(FromBothSides, Match, ::testing::Values(Player::A, Player::B),
                         [](const auto& info) { return name(info.param); });

TEST_P(Match, GoesToTheWinnerOfTheGamesWithACallForEach)
{
  Rules rules;
  rules.games = 3;
  MatchScript match(GetParam(), rules);
  std::vector<Call> calls;
  for (int points = 0; points < 22; ++points)
  {
    rallyWonBy(match, GetParam());
    for (Call& call : match.umpire().takeCalls()) calls.push_back(call);
    EXPECT_EQ(match.umpire().phase(), points == 10   ? Phase::GameOver
                                      : points == 21 ? Phase::MatchOver
                                                     : Phase::RallyOver);
  }
  ASSERT_EQ(calls.size(), 22u + 2u + 1u + 1u);
  EXPECT_EQ(calls[11].kind, CallKind::Game);
  EXPECT_EQ(calls[11].reason, s() + " wins the game 11:0");
  EXPECT_EQ(calls[12].kind, CallKind::ChangeEnds);
  EXPECT_EQ(calls.back().kind, CallKind::Match);
  EXPECT_EQ(calls.back().reason, s() + " wins the match 2:0");
  EXPECT_EQ(calls.back().winner, GetParam());
  EXPECT_TRUE(match.hold());  // refused: the match is over
  match.umpire().newMatch(match.time, GetParam());
  EXPECT_EQ(match.umpire().score().games, (std::array<int, 2>{}));
  EXPECT_FALSE(match.hold());
}

// The same touches, after a change of ends, score for the other player.
TEST_P(Match, AfterAChangeOfEndsTheRacketsHaveChangedHands)
{
  MatchScript match(GetParam());
  const End before = match.umpire().endOf(GetParam());
  for (int points = 0; points < 11; ++points) rallyWonBy(match, GetParam());
  EXPECT_EQ(match.umpire().endOf(GetParam()), other(before));
  match.umpire().takeCalls();
  match.service();  // by the other player, from the end where the first has stood
  EXPECT_EQ(match.server(), before);
  match.floor();
  EXPECT_EQ(match.said(), "fault 2.6.3 " + s());
  EXPECT_EQ(match.call().score.pointsOf(GetParam()), 1);
}

// 2.15.1, 2.15.3: in the middle of a rally.
TEST_P(Match, AfterTenMinutesTheRallyIsInterruptedAndItsServerServesAgain)
{
  MatchScript match(GetParam());
  rallyWonBy(match, GetParam());
  match.umpire().takeCalls();
  match.time += 595.0;
  match.goodService();
  match.time = 601.1;  // the game began at 1 s
  match.seen(match.ball(0.0, 0.0, 0.3));
  EXPECT_EQ(match.said(), "let 2.15.3");
  ASSERT_EQ(match.calls(), 2u);
  EXPECT_EQ(match.umpire().calls()[1].kind, CallKind::Expedite);
  EXPECT_TRUE(match.umpire().score().expedite);
  EXPECT_EQ(match.umpire().score().server, GetParam());
  EXPECT_EQ(match.umpire().score().service, 1);
}

// Between rallies: the receiver of the rally before.
TEST_P(Match, BetweenRalliesTheReceiverOfTheLastOneServes)
{
  MatchScript match(GetParam());
  rallyWonBy(match, GetParam());
  match.umpire().takeCalls();
  match.umpire().clock(600.9);
  EXPECT_EQ(match.said(), "");
  match.umpire().clock(601.1);
  EXPECT_EQ(match.said(), "expedite 2.15.1");
  EXPECT_EQ(match.umpire().score().server, other(GetParam()));
  match.umpire().clock(2000.0);
  EXPECT_EQ(match.calls(), 1u);
}

// 2.15.2
TEST_P(Match, With18PointsTheExpediteSystemStaysOut)
{
  MatchScript match(GetParam());
  for (int points = 0; points < 18; ++points) rallyWonBy(match, points % 2 ? Player::A : Player::B);
  match.umpire().takeCalls();
  match.umpire().clock(match.time + 700.0);
  EXPECT_EQ(match.said(), "");
  EXPECT_TRUE(match.umpire().requestExpedite(match.time + 700.0));
}

TEST_P(Match, BothPlayersMayAskForTheExpediteSystem)
{
  MatchScript match(GetParam());
  EXPECT_FALSE(match.umpire().requestExpedite(match.time));
  EXPECT_TRUE(match.umpire().score().expedite);
  EXPECT_EQ(match.umpire().score().server, GetParam());
  EXPECT_TRUE(match.umpire().requestExpedite(match.time));
}

// 2.15.4
TEST_P(Match, ThirteenGoodReturnsScoreUnderExpedite)
{
  for (const bool expedite : {true, false})
  {
    MatchScript match(GetParam());
    if (expedite) match.umpire().requestExpedite(match.time);
    match.umpire().takeCalls();
    match.goodService();
    for (int returns = 1; returns <= 13; ++returns)
    {
      EXPECT_EQ(match.said(), "") << returns;
      match.racket(match.receiver());
      EXPECT_EQ(match.said(), "");  // struck, but not yet a return
      const End receiver = match.receiver(), server = match.server();
      match.court(server);
      if (returns == 13) break;
      match.racket(server);
      match.court(receiver);
    }
    EXPECT_EQ(match.said(), expedite ? "point 2.15.4 " + r() : "");
  }
}

TEST_P(Match, TheBestRallyIsKeptAndLetsAreNot)
{
  MatchScript match(GetParam());
  match.rallyUpToStrokeBy(match.server());
  match.floor();
  EXPECT_EQ(match.umpire().score().best_rally, 3);
  match.rallyUpToStrokeBy(match.server());
  const End receiver = match.receiver();
  match.court(receiver);
  match.racket(receiver);
  EXPECT_EQ(match.umpire().score().strokes, 4);
  match.umpire().let(match.time, "a ball rolled in");
  EXPECT_EQ(match.umpire().score().best_rally, 3);
  EXPECT_EQ(match.umpire().score().rallies, 1);
}

TEST_P(Match, ForfeitGivesItToTheOpponent)
{
  MatchScript match(GetParam());
  match.goodService();
  EXPECT_FALSE(match.umpire().forfeit(match.time, GetParam(), "has left"));
  EXPECT_EQ(match.said(), "match  " + r());
  EXPECT_EQ(match.call().reason, s() + " has left: " + r() + " wins the match");
  EXPECT_EQ(match.umpire().phase(), Phase::MatchOver);
  EXPECT_EQ(match.umpire().score().points, (std::array<int, 2>{}));
  EXPECT_TRUE(match.umpire().forfeit(match.time, other(GetParam()), "has left, too"));
}

// Preset `rally`: a launcher may serve, strokes are counted, nobody scores.
TEST_P(Match, InPresetRallyAFeedBeginsAndStrokesAreCounted)
{
  MatchScript match(GetParam(), rulesPreset("rally"));
  const auto feed = [&] { return match.umpire().feed(match.time, {MatchScript::kBall, kBallRadius, GetParam()}); };
  EXPECT_FALSE(feed());
  EXPECT_TRUE(feed());  // one is in play
  const End from = match.server(), to = match.receiver();
  match.net();
  match.court(to);
  match.racket(to);
  match.court(from);
  match.racket(from);
  match.floor();
  EXPECT_EQ(match.said(), "rally end 2.10.1.2");
  EXPECT_EQ(match.call().score.best_rally, 2);
  EXPECT_EQ(match.call().score.points, (std::array<int, 2>{}));
  EXPECT_FALSE(match.umpire().feed(match.time, {MatchScript::kBall, kBallRadius, other(GetParam())}));
  EXPECT_EQ(match.server(), to);

  MatchScript strict(GetParam());
  EXPECT_TRUE(strict.umpire().feed(strict.time, {MatchScript::kBall, kBallRadius, std::nullopt}));
}
}  // namespace
}  // namespace ping_pong::game
