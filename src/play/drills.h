// Players put to the test: against a launcher, in their service, with each other.
#pragma once

#include "trial.h"

namespace ping_pong::play
{
enum class Outcome
{
  Returned,    ///< lands on the other half
  NotItsHalf,  ///< the launch does not come to the player's half: nothing to return
  Untouched,   ///< the racket does not meet it
  Volley,      ///< the racket meets it before it has bounced
  TouchedTwice,
  IntoNet,  ///< touches net or own half first
  Out       ///< lands beside the other half
};
const char* name(Outcome outcome);

struct ReturnResult
{
  Outcome outcome = Outcome::Untouched;
  Stroke stroke = Stroke::Drive;
  std::string why;             ///< of NotItsHalf: where the launch ends
  double landing_error = 0.0;  ///< from the target, if it lands on the table [m]
  double spin = 0.0;           ///< with which it comes to the racket [rad/s]
  double speed = 0.0;          ///< the same [m/s]
};

/// One ball from a launcher to player 0.
/// @param launch  in frame O of that player
ReturnResult returnOf(Trial& trial, const BallState& launch, std::uint64_t seed);

struct ServeResult
{
  bool legal = false;
  std::string fault;           ///< empty if legal
  double rise = 0.0;           ///< of the ball after the toss [m]
  double landing_error = 0.0;  ///< on the other half [m]
  Stroke stroke = Stroke::LongServe;
};
/// Toss and service of player 0: rises 16 cm or more, struck as it falls, behind the end line and above the surface (ITTF 2.6.2 to 2.6.4),
/// lands on the own half, then on the other.
ServeResult serveOf(Trial& trial, std::uint64_t seed);

struct RallyResult
{
  std::size_t strokes = 0;    ///< the service is one
  std::size_t loser = kNone;  ///< whose stroke was bad or missing; kNone: stopped
};

/// Two players after the service of player 0, until a ball is not returned; at most so many strokes.
RallyResult rallyOf(Trial& trial, std::uint64_t seed, std::size_t most);
}  // namespace ping_pong::play
