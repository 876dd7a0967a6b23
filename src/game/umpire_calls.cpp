// What the umpire does with a decision: counts it, and says it.
#include "game/umpire.h"

namespace ping_pong::game
{
const char* name(CallKind kind)
{
  switch (kind)
  {
    case CallKind::Point:
      return "point";
    case CallKind::Fault:
      return "fault";
    case CallKind::Let:
      return "let";
    case CallKind::RallyEnd:
      return "rally end";
    case CallKind::Game:
      return "game";
    case CallKind::Match:
      return "match";
    case CallKind::ChangeEnds:
      return "change ends";
    case CallKind::Expedite:
      break;
  }
  return "expedite";
}

void Umpire::call(double time, CallKind kind, const std::string& law, const std::string& reason,
                  std::optional<Player> winner)
{
  calls_.push_back({time, rally_.ball(), kind, law, reason, winner, score()});
}

void Umpire::decide(const std::optional<Verdict>& verdict)
{
  if (!verdict) return;
  if (verdict->kind == CallKind::Let) return callLet(verdict->time, verdict->law, verdict->reason);
  last_server_ = score().server;
  score_.endRally();
  rally_.end();
  if (rules_.keep_score) return callPoint(*verdict);
  call(verdict->time, CallKind::RallyEnd, verdict->law, verdict->reason);
}

void Umpire::callLet(double time, const std::string& law, const std::string& reason)
{
  if (inPlay(phase())) last_server_ = score().server;
  rally_.end();
  call(time, CallKind::Let, law, reason);
}

void Umpire::callPoint(const Verdict& verdict)
{
  const Player winner = playerAt(verdict.winner);
  const PointResult result = score_.point(winner);
  if (result.match)
    rally_.end(Phase::MatchOver);
  else if (result.game)
    rally_.end(Phase::GameOver);
  call(verdict.time, verdict.kind, verdict.law, verdict.reason, winner);

  const std::string who = name(winner);
  const auto against = [&](int won, int lost) { return std::to_string(won) + ":" + std::to_string(lost); };
  const Score& now = score();
  if (result.game)
    call(verdict.time, CallKind::Game, "2.11.1",
         who + " wins the game " + against(now.pointsOf(winner), now.pointsOf(other(winner))), winner);
  if (result.match)
    call(verdict.time, CallKind::Match, "2.12.1",
         who + " wins the match " + against(now.gamesOf(winner), now.gamesOf(other(winner))), winner);
  if (result.ends_changed) call(verdict.time, CallKind::ChangeEnds, "2.13.7", "the players change ends");
}

// 2.15.1, 2.15.2
void Umpire::expediteIfDue(double time)
{
  const Score& now = score();
  if (!rules_.keep_score || now.expedite || now.winner || now.game_won || !game_start_) return;
  if (time - *game_start_ < rules_.expedite_after || score_.tooLateForExpedite()) return;
  introduceExpedite(time, "the game has lasted " + std::to_string(static_cast<long>(time - *game_start_)) + " s");
}

// 2.15.3: the server of a rally that it interrupts serves again; else the receiver of the rally before.
void Umpire::introduceExpedite(double time, const std::string& why)
{
  Player server = score().server;
  if (inPlay(phase()))
    callLet(time, "2.15.3", "play is interrupted to introduce the expedite system");
  else
  {
    if (last_server_) server = other(*last_server_);
    if (phase() == Phase::InHand) rally_.end();  // perhaps in the wrong hand now
  }
  score_.expedite(server);
  call(time, CallKind::Expedite, "2.15.1", why + ": the expedite system is in operation, " + name(server) + " serves");
}

Refusal Umpire::requestExpedite(double time)
{
  if (!timeRuns(time)) return {"the time went back"};
  const Score& now = score();
  if (!rules_.keep_score) return {"rules '" + rules_.name + "' keep no score"};
  if (now.winner) return {"the match is over"};
  if (now.expedite) return {"the expedite system is in operation"};
  if (!now.game_won && score_.tooLateForExpedite())
    return {std::to_string(rules_.expedite_points) + " points have been scored in this game (2.15.2)"};
  introduceExpedite(time, "both players ask for it");
  return {};
}

Refusal Umpire::forfeit(double time, Player loser, const std::string& reason)
{
  if (!timeRuns(time)) return {"the time went back"};
  if (!rules_.keep_score) return {"rules '" + rules_.name + "' keep no score"};
  if (score().winner) return {"the match is over"};
  score_.forfeit(loser);
  rally_.end(Phase::MatchOver);
  call(time, CallKind::Match, "",
       std::string(name(loser)) + " " + reason + ": " + name(other(loser)) + " wins the match", other(loser));
  return {};
}
}  // namespace ping_pong::game
