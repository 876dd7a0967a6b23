// Matches of computer players without ROS: they end, with a score that the laws allow, and the same one from the same seed.
#include <gtest/gtest.h>

#include "match/headless_match.h"
#include "ping_pong_sim/scene_loader.h"

namespace
{
using namespace ping_pong;

std::shared_ptr<const Scene> matchScene()
{
  static const auto scene = std::make_shared<const Scene>(loadScene(SCENES_DIR "/match.yaml"));
  return scene;
}

MatchSetup setupOf(std::array<int, 2> levels, std::uint64_t seed)
{
  MatchSetup setup;
  setup.scene = matchScene();
  setup.rules = game::rulesPreset("ittf");
  setup.rules.games = 1;
  setup.rules.change_ends = false;
  setup.levels = levels;
  setup.seed = seed;
  return setup;
}

void expectLegal(const std::array<int, 2>& game)
{
  const int high = std::max(game[0], game[1]), low = std::min(game[0], game[1]);
  EXPECT_TRUE(high == 11 ? low <= 9 : high > 11 && low == high - 2) << game[0] << " : " << game[1];
}

TEST(HeadlessMatch, TwentyGamesOfMixedLevelsEndWithLegalScores)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    const int a = 1 + static_cast<int>(seed % 5), b = 1 + static_cast<int>(seed / 5 % 5);
    const MatchResult result = HeadlessMatch(setupOf({a, b}, seed)).play();
    ASSERT_TRUE(result.winner) << "levels " << a << " and " << b << ", seed " << seed;
    ASSERT_EQ(result.games.size(), 1u);
    expectLegal(result.games[0]);
    EXPECT_EQ(result.games[0][index(*result.winner)], std::max(result.games[0][0], result.games[0][1]));
  }
}

TEST(HeadlessMatch, TheSameSeedGivesTheSameMatch)
{
  const MatchResult one = HeadlessMatch(setupOf({4, 3}, 7)).play(), two = HeadlessMatch(setupOf({4, 3}, 7)).play();
  EXPECT_EQ(one.games, two.games);
  EXPECT_EQ(one.time, two.time);
  EXPECT_EQ(one.strokes, two.strokes);
  const MatchResult other = HeadlessMatch(setupOf({4, 3}, 8)).play();
  EXPECT_NE(one.time, other.time);
}

TEST(HeadlessMatch, AHigherLevelWinsMore)
{
  int won = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
  {
    const MatchResult result = HeadlessMatch(setupOf({5, 1}, seed)).play();
    won += result.winner == game::Player::A;
  }
  EXPECT_EQ(won, 5);
}

TEST(HeadlessMatch, WhatCannotBePlayedIsRefused)
{
  MatchSetup setup = setupOf({5, 9}, 1);
  EXPECT_THROW(HeadlessMatch{setup}, std::invalid_argument);
  setup = setupOf({5, 5}, 1);
  setup.rules.change_ends = true;
  EXPECT_THROW(HeadlessMatch{setup}, std::invalid_argument);
  setup = setupOf({5, 5}, 1);
  setup.scene = std::make_shared<const Scene>(loadScene(SCENES_DIR "/drop.yaml"));
  EXPECT_THROW(HeadlessMatch{setup}, std::invalid_argument);
}
}  // namespace
