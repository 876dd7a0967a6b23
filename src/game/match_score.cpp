#include "game/match_score.h"

#include <algorithm>

namespace ping_pong::game
{
MatchScore::MatchScore(const Rules& rules, Player first_server) : rules_(rules)
{
  score_.server = score_.first_server = first_server;
}

Player MatchScore::playerAt(End end) const
{
  return (end == End::Minus) != score_.ends_changed ? Player::A : Player::B;
}

End MatchScore::endOf(Player player) const
{
  return playerAt(End::Minus) == player ? End::Minus : End::Plus;
}

bool MatchScore::lastPossibleGame() const
{
  return score_.games[0] + score_.games[1] == rules_.games - 1;
}

bool MatchScore::tooLateForExpedite() const
{
  return score_.points[0] + score_.points[1] >= rules_.expedite_points;
}

void MatchScore::beginRally(Player server)
{
  if (score_.game_won)
  {
    score_.points = {};
    score_.game_won = score_.deuce = false;
  }
  score_.server = server;
  score_.strokes = 0;
}

void MatchScore::showStrokes(int strokes)
{
  score_.strokes = strokes;
}

void MatchScore::endRally()
{
  ++score_.rallies;
  score_.best_rally = std::max(score_.best_rally, score_.strokes);
}

bool MatchScore::gameWonBy(Player player) const
{
  return score_.pointsOf(player) >= rules_.points_per_game &&
         score_.pointsOf(player) - score_.pointsOf(other(player)) >= rules_.lead;
}

// 2.13.3
void MatchScore::turnService()
{
  const int in_turn = score_.deuce || score_.expedite ? 1 : rules_.services;
  if (++score_.service <= in_turn) return;
  score_.server = other(score_.server);
  score_.service = 1;
}

// 2.13.7: when the first of them comes to 5 points, once.
bool MatchScore::changeOfEndsInLastGame() const
{
  return rules_.change_ends && lastPossibleGame() &&
         std::max(score_.points[0], score_.points[1]) == rules_.change_ends_at;
}

PointResult MatchScore::point(Player winner)
{
  PointResult result;
  if (score_.winner || score_.game_won) return result;
  const int before = std::max(score_.points[0], score_.points[1]);
  ++score_.points[index(winner)];
  score_.deuce = std::min(score_.points[0], score_.points[1]) >= rules_.points_per_game - 1;
  if (gameWonBy(winner))
  {
    winGame(winner, result);
    return result;
  }
  turnService();
  if (before < rules_.change_ends_at && changeOfEndsInLastGame())
  {
    score_.ends_changed = !score_.ends_changed;
    result.ends_changed = true;
  }
  return result;
}

void MatchScore::winGame(Player winner, PointResult& result)
{
  result.game = true;
  finished_.push_back(score_.points);
  score_.game_won = true;
  score_.service = 1;
  ++score_.games[index(winner)];
  if (score_.gamesOf(winner) > rules_.games / 2)
  {
    score_.winner = winner;
    result.match = true;
    return;
  }
  score_.server = score_.first_server = other(score_.first_server);  // 2.13.6
  if (rules_.change_ends) score_.ends_changed = !score_.ends_changed;
  result.ends_changed = rules_.change_ends;
}

void MatchScore::expedite(Player server)
{
  score_.expedite = true;
  score_.server = server;
  score_.service = 1;
}

void MatchScore::forfeit(Player loser)
{
  if (!score_.winner) score_.winner = other(loser);
}
}  // namespace ping_pong::game
