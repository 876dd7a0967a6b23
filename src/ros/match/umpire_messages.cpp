#include "umpire_messages.h"

#include <ros/serialization.h>

#include <cstring>

#include "teleop/messages.h"

namespace ping_pong_sim
{
namespace game = ping_pong::game;

namespace
{
void setPoints(const game::Score& score, boost::array<std::uint16_t, 2>& points, boost::array<std::uint16_t, 2>& games)
{
  for (std::size_t i = 0; i < 2; ++i)
  {
    points[i] = static_cast<std::uint16_t>(score.points[i]);
    games[i] = static_cast<std::uint16_t>(score.games[i]);
  }
}

std::uint8_t kindOf(game::CallKind kind)
{
  switch (kind)
  {
    case game::CallKind::Point:
      return UmpireCall::POINT;
    case game::CallKind::Fault:
      return UmpireCall::FAULT;
    case game::CallKind::Let:
      return UmpireCall::LET;
    case game::CallKind::RallyEnd:
      return UmpireCall::RALLY_END;
    case game::CallKind::Game:
      return UmpireCall::GAME;
    case game::CallKind::Match:
      return UmpireCall::MATCH;
    case game::CallKind::ChangeEnds:
      return UmpireCall::ENDS;
    case game::CallKind::Expedite:
      return UmpireCall::EXPEDITE;
  }
  return UmpireCall::NOTICE;
}
}  // namespace

ping_pong::Contact contactOf(const Contact& message, std::size_t body)
{
  ping_pong::Contact contact;
  contact.time = message.time;
  contact.ball = message.ball;
  contact.with_ball = message.with_ball;
  contact.other_ball = message.other_ball;
  contact.body = body;
  contact.shape = message.shape < 0 ? ping_pong::kNone : static_cast<std::size_t>(message.shape);
  contact.p_WC = fromMessage(message.point);
  contact.n_W = fromMessage(message.normal);
  contact.v_before = fromMessage(message.velocity_before);
  contact.v_after = fromMessage(message.velocity_after);
  contact.w_before = fromMessage(message.spin_before);
  contact.w_after = fromMessage(message.spin_after);
  contact.v_other = fromMessage(message.velocity_other);
  contact.impulse = fromMessage(message.impulse);
  return contact;
}

TickEnd tickOf(const BallStates& message)
{
  TickEnd tick;
  tick.time = message.time;
  for (const BallState& ball : message.balls)
  {
    SeenBall seen;
    seen.id = ball.id;
    seen.radius = ball.radius;
    seen.state.p_WB = fromMessage(ball.pose.position);
    seen.state.v_WB = fromMessage(ball.twist.linear);
    seen.state.w_WB = fromMessage(ball.twist.angular);
    tick.balls.push_back(seen);
  }
  return tick;
}

Score scoreOf(const game::Umpire& umpire)
{
  const game::Score& score = umpire.score();
  Score message;
  message.rules = umpire.rules().name;
  message.state = game::name(umpire.phase());
  setPoints(score, message.points, message.games);
  for (std::size_t i = 0; i < 2; ++i) message.ends[i] = umpire.endOf(playerOf(i)) == game::End::Minus ? -1 : 1;
  message.game = static_cast<std::uint16_t>(umpire.finishedGames().size() + (score.game_won ? 0 : 1));
  message.best_of = static_cast<std::uint16_t>(umpire.rules().games);
  message.server = static_cast<std::uint8_t>(index(score.server));
  message.deuce = score.deuce;
  message.expedite = score.expedite;
  message.winner = score.winner ? static_cast<std::int8_t>(index(*score.winner)) : -1;
  message.rally = static_cast<std::uint32_t>(score.strokes);
  message.best_rally = static_cast<std::uint32_t>(score.best_rally);
  return message;
}

bool sameScore(const Score& a, const Score& b)
{
  namespace ser = ros::serialization;
  const ros::SerializedMessage left = ser::serializeMessage(a), right = ser::serializeMessage(b);
  return left.num_bytes == right.num_bytes && std::memcmp(left.buf.get(), right.buf.get(), left.num_bytes) == 0;
}

UmpireCall noticeOf(const game::Umpire& umpire, const std::string& text)
{
  UmpireCall message;
  message.kind = UmpireCall::NOTICE;
  message.reason = text;
  message.winner = -1;
  setPoints(umpire.score(), message.points, message.games);
  return message;
}

UmpireCall callOf(const game::Call& call)
{
  UmpireCall message;
  message.kind = kindOf(call.kind);
  message.law = call.law;
  message.reason = call.reason;
  message.ball = call.ball;
  message.winner = call.winner ? static_cast<std::int8_t>(index(*call.winner)) : -1;
  setPoints(call.score, message.points, message.games);
  return message;
}
}  // namespace ping_pong_sim
