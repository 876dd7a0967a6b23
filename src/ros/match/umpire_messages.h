// Between messages and what an umpire knows.
#pragma once

#include "event_order.h"
#include "game/umpire.h"
#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/Contact.h"
#include "ping_pong_sim/Score.h"
#include "ping_pong_sim/UmpireCall.h"

namespace ping_pong_sim
{
/// @param body  index of the body that it was with; kNone: with another ball
ping_pong::Contact contactOf(const Contact& message, std::size_t body);
TickEnd tickOf(const BallStates& message);

/// All but names, paddles, stroke and header.
Score scoreOf(const ping_pong::game::Umpire& umpire);
bool sameScore(const Score& a, const Score& b);
/// All but the header.
UmpireCall noticeOf(const ping_pong::game::Umpire& umpire, const std::string& text);
UmpireCall callOf(const ping_pong::game::Call& call);

constexpr ping_pong::game::Player playerOf(std::size_t index)
{
  return index == 0 ? ping_pong::game::Player::A : ping_pong::game::Player::B;
}
}  // namespace ping_pong_sim
