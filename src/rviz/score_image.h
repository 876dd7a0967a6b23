// The score board as a picture: who plays, who serves, games and points; the last call; what the last stroke was.
#pragma once

#include <QColor>
#include <QImage>
#include <string>

#include "ping_pong_sim/Score.h"
#include "ping_pong_sim/UmpireCall.h"

namespace ping_pong_sim
{
struct ScoreBoard
{
  Score score;
  int level = 0;                     ///< of the opponent; 0: not known
  int player = -1;                   ///< who looks at the board; -1: nobody of the match
  const UmpireCall* call = nullptr;  ///< that is still news
};

/// What a call says to the players: "Point to You: the ball bounced twice (2.10.1.3)".
std::string callText(const UmpireCall& call, const Score& score);
/// "5 strokes, best 12   11.3 m/s   45 turns/s"
std::string strokeText(const Score& score);

/// @param size  height of the letters of names [pixels]; points are larger
QImage scoreImage(const ScoreBoard& board, int size, const QColor& background);
}  // namespace ping_pong_sim
