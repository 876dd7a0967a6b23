// Points, games, who serves, who stands where: ITTF laws 2.11 to 2.13 and 2.15.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "game/rules.h"
#include "game/sides.h"

namespace ping_pong::game
{
/// What a score board shows. Arrays are by index(Player).
struct Score
{
  std::array<int, 2> points{};   ///< of this game; of a game that is won, until the next one begins
  std::array<int, 2> games{};    ///< won
  Player server = Player::A;     ///< of the rally in play, else of the next
  int service = 1;               ///< which of the server's turn it is, from 1
  Player first_server{};         ///< of this game (2.13.6)
  bool ends_changed = false;     ///< A stands at the +x end
  bool deuce = false;            ///< both one point short of a game or further: one service each (2.13.3)
  bool expedite = false;         ///< 2.15 is in operation, until the end of the match
  bool game_won = false;         ///< and the next one has not begun
  std::optional<Player> winner;  ///< of the match
  int strokes = 0;               ///< of the rally in play, else of the last; the service is one
  int best_rally = 0;            ///< most strokes of a rally of this match that was no let
  int rallies = 0;               ///< of this match that were no lets

  int pointsOf(Player player) const { return points[index(player)]; }
  int gamesOf(Player player) const { return games[index(player)]; }
};

/// What a point brought with it.
struct PointResult
{
  bool game = false;          ///< was won
  bool match = false;         ///< was won
  bool ends_changed = false;  ///< players are to change ends now
};

class MatchScore
{
public:
  /// @param rules  checkRules() finds nothing wrong with them
  explicit MatchScore(const Rules& rules, Player first_server = Player::A);

  const Score& score() const { return score_; }
  /// Points of each game that was won, in order.
  const std::vector<std::array<int, 2>>& finishedGames() const { return finished_; }
  Player playerAt(End end) const;
  End endOf(Player player) const;
  bool lastPossibleGame() const;

  void beginRally(Player server);  ///< begins the next game after one that was won
  void showStrokes(int strokes);   ///< of the rally in play
  void endRally();                 ///< it was no let: it counts as a rally
  PointResult point(Player winner);
  /// Introduces the expedite system, with the next service by `server` (2.15.3).
  void expedite(Player server);
  /// The opponent wins the match; the score stays.
  void forfeit(Player loser);
  /// Whether at least as many points have been scored as keep the expedite system out (2.15.2).
  bool tooLateForExpedite() const;

private:
  bool gameWonBy(Player player) const;
  void turnService();
  bool changeOfEndsInLastGame() const;
  void winGame(Player winner, PointResult& result);

  Rules rules_;
  Score score_;
  std::vector<std::array<int, 2>> finished_;
};
}  // namespace ping_pong::game
