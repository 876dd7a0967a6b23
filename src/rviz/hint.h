// The key that is useful next, for people.
#pragma once

#include <string>

#include "ping_pong_sim/HandsState.h"
#include "ping_pong_sim/Score.h"
#include "ping_pong_sim/SimStatus.h"

namespace ping_pong_sim
{
/// @param hands         of the window's own keys; null: none are there
/// @param score         null: no match
/// @param ball_in_play  a ball is at or above the table, and moves
/// @return empty: nothing to say
std::string hintLine(const SimStatus* status, const HandsState* hands, const Score* score, bool ball_in_play);
}  // namespace ping_pong_sim
