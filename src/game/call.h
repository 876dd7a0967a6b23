// What an umpire says.
#pragma once

#include <optional>
#include <string>

#include "game/match_score.h"
#include "ping_pong_sim/types.h"

namespace ping_pong::game
{
enum class CallKind : unsigned char
{
  Point,       ///< the winner scores
  Fault,       ///< the service was not good: the receiver scores
  Let,         ///< the rally is not scored
  RallyEnd,    ///< of rules that keep no score
  Game,        ///< won
  Match,       ///< won
  ChangeEnds,  ///< players are to change ends before the next service
  Expedite     ///< the expedite system comes into operation
};

const char* name(CallKind kind);

struct Call
{
  double time = 0.0;  ///< world time of what decided it [s]
  BallId ball = 0;    ///< that was in play last
  CallKind kind = CallKind::Let;
  std::string law;               ///< "2.6.2", of the ITTF laws; empty if none is behind it
  std::string reason;            ///< one sentence without a full stop: what happened
  std::optional<Player> winner;  ///< of the point, game or match
  Score score;                   ///< after it
};
}  // namespace ping_pong::game
