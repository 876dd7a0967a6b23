// The states of the umpire. docs/game.md draws them.
#pragma once

namespace ping_pong::game
{
enum class Phase : unsigned char
{
  BeforeService,   ///< of the first rally of a match
  InHand,          ///< the ball rests on the server's palm; it is not in play yet (2.5.2)
  Toss,            ///< it is free and waits for the server's stroke
  ServiceStruck,   ///< has to touch the server's court
  ServiceBounced,  ///< has touched the server's court, has to touch the receiver's
  ReturnStruck,    ///< has to touch the opponent's court
  InCourt,         ///< has touched the court of the player who has to strike it now
  RallyOver,       ///< point or let: nothing counts until the next service
  GameOver,        ///< the same, and a game was won
  MatchOver        ///< until a new match
};

constexpr bool inPlay(Phase phase)
{
  return phase >= Phase::Toss && phase <= Phase::InCourt;
}

const char* name(Phase phase);
}  // namespace ping_pong::game
