// Points, games, services, ends, expedite: ITTF laws 2.11 to 2.13 and 2.15, and scores that cannot be.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "game/match_score.h"
#include "match_script.h"

namespace ping_pong::game
{
namespace
{
Rules ittfOf(int games)
{
  Rules rules;
  rules.games = games;
  return rules;
}

void points(MatchScore& score, Player winner, int count)
{
  for (int i = 0; i < count; ++i)
  {
    score.beginRally(score.score().server);
    score.point(winner);
  }
}

/// Brings the game to a:b, as evenly as may be.
void playTo(MatchScore& score, int a, int b)
{
  for (int i = 0; i < std::max(a, b); ++i)
  {
    if (i < a) points(score, Player::A, 1);
    if (i < b) points(score, Player::B, 1);
  }
}

class Scoring : public ::testing::TestWithParam<Player>
{
protected:
  Player me = GetParam(), you = other(GetParam());
};
INSTANTIATE_TEST_SUITE_P(FromBothSides, Scoring, ::testing::Values(Player::A, Player::B),
                         [](const auto& info) { return name(info.param); });

// 2.11.1
TEST_P(Scoring, AGameIsWonByElevenPoints)
{
  MatchScore score(ittfOf(5), me);
  points(score, me, 10);
  EXPECT_FALSE(score.score().game_won);
  points(score, you, 9);
  EXPECT_TRUE(score.point(me).game);
  EXPECT_EQ(score.score().gamesOf(me), 1);
  EXPECT_EQ(score.score().pointsOf(me), 11);
  EXPECT_EQ(score.score().pointsOf(you), 9);
  EXPECT_FALSE(score.point(me).game);  // nothing counts until the next service
  EXPECT_EQ(score.score().pointsOf(me), 11);
}

TEST_P(Scoring, AtDeuceALeadOfTwoWins)
{
  MatchScore score(ittfOf(5), me);
  playTo(score, 10, 10);
  EXPECT_TRUE(score.score().deuce);
  points(score, me, 1);
  EXPECT_FALSE(score.score().game_won);
  points(score, you, 2);
  EXPECT_FALSE(score.score().game_won);
  points(score, me, 2);
  EXPECT_FALSE(score.score().game_won);
  points(score, me, 1);
  EXPECT_TRUE(score.score().game_won);
  EXPECT_EQ(score.score().pointsOf(me), 14);
  EXPECT_EQ(score.score().pointsOf(you), 12);
}

// 2.12.1
TEST_P(Scoring, AMatchIsTheBestOfItsGames)
{
  for (const int games : {1, 3, 5, 7})
  {
    MatchScore score(ittfOf(games), me);
    for (int i = 0; i < games / 2; ++i)
    {
      points(score, you, 11);
      points(score, me, 11);
    }
    EXPECT_FALSE(score.score().winner) << games;
    points(score, me, 11);
    ASSERT_TRUE(score.score().winner) << games;
    EXPECT_EQ(*score.score().winner, me);
    EXPECT_EQ(score.finishedGames().size(), static_cast<std::size_t>(games));
  }
}

// 2.13.3
TEST_P(Scoring, EachServesTwiceAndAtDeuceOnce)
{
  MatchScore score(ittfOf(5), me);
  for (int played = 0; played < 20; ++played)
  {
    EXPECT_EQ(score.score().server, played / 2 % 2 == 0 ? me : you) << played;
    EXPECT_EQ(score.score().service, 1 + played % 2) << played;
    points(score, played % 2 == 0 ? me : you, 1);
  }
  for (int played = 20; played < 26; ++played)
  {
    EXPECT_EQ(score.score().server, played % 2 == 0 ? me : you) << played;
    EXPECT_EQ(score.score().service, 1) << played;
    points(score, played % 2 == 0 ? me : you, 1);
  }
}

// 2.13.6
TEST_P(Scoring, WhoServedFirstInAGameReceivesFirstInTheNext)
{
  MatchScore score(ittfOf(5), me);
  points(score, me, 11);
  EXPECT_EQ(score.score().server, you);
  points(score, you, 11);
  EXPECT_EQ(score.score().server, me);
  playTo(score, 3, 11);
  EXPECT_EQ(score.score().server, you);
}

// 2.13.7
TEST_P(Scoring, EndsChangeAfterEachGameAndAtFiveInTheLast)
{
  MatchScore score(ittfOf(3), me);
  EXPECT_EQ(score.endOf(Player::A), End::Minus);
  points(score, me, 10);
  EXPECT_EQ(score.endOf(Player::A), End::Minus);
  EXPECT_TRUE(score.point(me).ends_changed);
  EXPECT_EQ(score.endOf(Player::A), End::Plus);
  EXPECT_EQ(score.playerAt(End::Plus), Player::A);
  points(score, you, 11);
  EXPECT_EQ(score.endOf(Player::A), End::Minus);
  points(score, you, 4);
  points(score, me, 4);
  EXPECT_EQ(score.endOf(Player::A), End::Minus);
  score.beginRally(score.score().server);
  EXPECT_TRUE(score.point(me).ends_changed);
  EXPECT_EQ(score.endOf(Player::A), End::Plus);
  EXPECT_FALSE(score.point(you).ends_changed);  // 5:5 changes nothing
  EXPECT_EQ(score.endOf(Player::A), End::Plus);
}

TEST_P(Scoring, EndsStayWhereRulesSaySo)
{
  Rules rules = ittfOf(3);
  rules.change_ends = false;
  MatchScore score(rules, me);
  for (const Player winner : {me, you, me}) points(score, winner, 11);
  EXPECT_EQ(score.endOf(Player::A), End::Minus);
}

// 2.15.4, 2.15.5
TEST_P(Scoring, UnderExpediteEachServesOnce)
{
  MatchScore score(ittfOf(5), me);
  points(score, me, 3);
  score.expedite(me);
  for (const Player server : {me, you, me, you})
  {
    EXPECT_EQ(score.score().server, server);
    points(score, you, 1);
  }
  points(score, me, 8);
  EXPECT_TRUE(score.score().game_won);
  EXPECT_TRUE(score.score().expedite);   // until the end of the match (2.15.6)
  EXPECT_EQ(score.score().server, you);  // the order of games stays (2.15.5)
}

/// Whether a score of a game can be: nobody goes on after the game is won.
bool legal(int a, int b, bool won)
{
  const int high = std::max(a, b), low = std::min(a, b);
  if (won) return high == 11 ? low <= 9 : high > 11 && high - low == 2;
  return high <= 10 || (low >= 10 && high - low <= 1);
}

TEST(Score, NoRandomMatchHasAnIllegalScore)
{
  std::mt19937 random(20261129);
  int played = 0, matches = 0, longest = 0;
  while (played < 10000)
  {
    MatchScore score(ittfOf(1 + 2 * static_cast<int>(random() % 4)), random() % 2 ? Player::A : Player::B);
    const unsigned skill = 20 + random() % 60;
    std::array<int, 2> services{};
    int points_of_game = 0;
    while (!score.score().winner)
    {
      if (score.score().game_won) services = {}, points_of_game = 0;
      score.beginRally(score.score().server);
      ASSERT_TRUE(legal(score.score().points[0], score.score().points[1], false));
      ++services[index(score.score().server)];
      const std::array<int, 2> before = score.score().points;
      const Player winner = random() % 100 < skill ? Player::A : Player::B;
      const PointResult result = score.point(winner);
      ++played, ++points_of_game;
      ASSERT_EQ(score.score().pointsOf(winner), before[index(winner)] + 1);
      ASSERT_EQ(score.score().pointsOf(other(winner)), before[index(other(winner))]);
      ASSERT_TRUE(legal(score.score().points[0], score.score().points[1], result.game));
      ASSERT_LE(std::abs(services[0] - services[1]), 2);
      longest = std::max(longest, points_of_game);
    }
    const Score& end = score.score();
    ASSERT_EQ(end.games[0] + end.games[1], static_cast<int>(score.finishedGames().size()));
    ASSERT_GT(end.gamesOf(*end.winner), end.gamesOf(other(*end.winner)));
    for (const auto& game : score.finishedGames()) ASSERT_TRUE(legal(game[0], game[1], true));
    ++matches;
  }
  EXPECT_GT(matches, 50);
  EXPECT_GT(longest, 22);  // some went to deuce
}

TEST(RulesOfPlay, PresetsHaveNamesAndUnknownOnesAreRefusedWithThem)
{
  EXPECT_TRUE(rulesPreset("ittf").toss);
  EXPECT_FALSE(rulesPreset("relaxed").toss);
  EXPECT_TRUE(rulesPreset("relaxed").keep_score);
  EXPECT_FALSE(rulesPreset("rally").keep_score);
  for (const char* name : {"ittf", "relaxed", "rally"})
  {
    EXPECT_EQ(rulesPreset(name).name, name);
    EXPECT_NO_THROW(checkRules(rulesPreset(name)));
  }
  try
  {
    rulesPreset("itff");
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(error.what(), "unknown rules 'itff': expected one of ittf, relaxed, rally");
  }
}

TEST(RulesOfPlay, WhatCannotBePlayedIsRefused)
{
  const auto refused = [](auto change)
  {
    Rules rules;
    change(rules);
    try
    {
      Umpire umpire(matchCourt(), rules);
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused([](Rules& rules) { rules.games = 4; }), "rules: games: 4: expected an odd number, 1 to 99");
  EXPECT_NE(refused([](Rules& rules) { rules.points_per_game = 0; }), "");
  EXPECT_NE(refused([](Rules& rules) { rules.lead = 0; }), "");
  EXPECT_NE(refused([](Rules& rules) { rules.services = 0; }), "");
  EXPECT_NE(refused([](Rules& rules) { rules.toss_height = std::nan(""); }), "");
  EXPECT_NE(refused([](Rules& rules) { rules.patience = -1.0; }), "");
}
}  // namespace
}  // namespace ping_pong::game
