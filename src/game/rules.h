// The rules that a match is played by: numbers of the ITTF laws, and what a preset leaves out of them.
#pragma once

#include <string>

namespace ping_pong::game
{
/// The defaults are those of preset `ittf`. Clauses are those of the ITTF Laws of Table Tennis, chapter 2 of the handbook.
struct Rules
{
  std::string name = "ittf";

  // What is asked.
  bool keep_score = true;     ///< false: no points, strokes are counted, anybody may serve
  bool toss = true;           ///< 2.6.1, 2.6.2: the ball is thrown up from the palm before it is struck
  bool service_place = true;  ///< 2.6.4: behind the end line and above the playing surface until it is struck
  bool service_court = true;  ///< 2.6.3: the service touches the server's court first; false: it may, and may be a feed
  bool net_let = true;        ///< 2.9.1.1: a service that touches the net assembly is played again
  bool change_ends = true;    ///< 2.13.7

  // Score.
  int points_per_game = 11;  ///< 2.11.1
  int lead = 2;              ///< 2.11.1, points
  int games = 5;             ///< 2.12.1: best of this odd number
  int services = 2;          ///< 2.13.3: in turn
  int change_ends_at = 5;    ///< 2.13.7: points of the first player to reach it in the last possible game

  // Service.
  double toss_height = 0.16;  ///< 2.6.2: least rise after leaving the palm [m]
  double toss_tilt = 0.52;    ///< 2.6.2 "near vertically": largest angle [rad], 30 deg: what umpires let pass by sight
  double toss_spin = 6.3;     ///< 2.6.2 "without imparting spin": at most a turn a second, which none would see [rad/s]

  // Rally.
  double double_hit = 0.05;  ///< 2.10.1.7: touches of one racket within this of the first are one stroke [s]

  // Expedite system, 2.15.
  double expedite_after = 600.0;  ///< of a game [s]; infinity: only on request
  int expedite_points = 18;       ///< from this sum of points on it is not introduced
  int expedite_returns = 13;      ///< good returns of the receiver that score

  // When a ball is given up.
  double patience = 5.0;  ///< without a touch; a lob of 10 m takes 3 s [s]
  double reach = 15.0;    ///< from the middle of the table; the playing area is 14 m long [m]
};

/// - `ittf`: all of the laws that are modelled, docs/game.md. Best of five.
/// - `relaxed`: no toss, place of service or change of ends is asked; one game.
/// - `rally`: no score; any service or feed will do, strokes are counted.
/// Throws std::invalid_argument that lists the known names.
Rules rulesPreset(const std::string& name);

/// "ittf, relaxed, rally", for messages.
std::string rulesPresetNames();

/// Throws std::invalid_argument "rules: KEY: VALUE: expected ..." if no match could be played by them.
void checkRules(const Rules& rules);
}  // namespace ping_pong::game
