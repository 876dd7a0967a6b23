#include "game/umpire.h"

#include <cmath>
#include <cstdio>

namespace ping_pong::game
{
namespace
{
constexpr double kSameTime = 1e-9;  // rounding of a contact at the very end of a tick [s]
}

Umpire::Umpire(const Court& court, const Rules& rules, Player first_server)
    : rules_((checkRules(rules), rules)), rally_(court, rules), score_(rules, first_server)
{
}

void Umpire::newMatch(double time, Player first_server)
{
  if (std::isfinite(time)) time_ = time;
  score_ = MatchScore(rules_, first_server);
  rally_.end(Phase::BeforeService);
  game_start_.reset();
  last_server_.reset();
}

Refusal Umpire::mayServe(const Service& service) const
{
  const Score& now = score();
  if (now.winner) return {std::string("the match is over, ") + name(*now.winner) + " has won: begin a new one"};
  if (ball()) return {"ball " + std::to_string(*ball()) + " is in play"};
  if (!(service.radius > 0.0) || !std::isfinite(service.radius)) return {"the ball's radius is not positive"};
  if (rules_.keep_score && service.server && *service.server != now.server)
    return {std::string("it is ") + name(now.server) + "'s turn to serve, not " + name(*service.server) + "'s"};
  return {};
}

RallySetup Umpire::setupOf(double time, const Service& service) const
{
  RallySetup setup;
  setup.time = time;
  setup.ball = service.ball;
  setup.radius = service.radius;
  setup.server = endOf(score().server);
  setup.players = {playerAt(End::Minus), playerAt(End::Plus)};
  setup.expedite = score().expedite;
  return setup;
}

Refusal Umpire::putInPlay(double time, const Service& service)
{
  if (!timeRuns(time)) return {"the time went back"};
  if (Refusal refusal = mayServe(service)) return refusal;
  if (score().game_won)
  {
    game_start_.reset();
    last_server_.reset();
  }
  score_.beginRally(service.server.value_or(score().server));
  if (!game_start_) game_start_ = time;
  received_ = false;
  rally_.begin(setupOf(time, service));
  return {};
}

Refusal Umpire::thrown(double time, const BallState& state)
{
  if (!timeRuns(time)) return {"the time went back"};
  if (phase() != Phase::InHand && phase() != Phase::Toss) return {"no ball is in the server's hand"};
  decide(rally_.thrown(sampleOf(time, state)));
  return {};
}

Refusal Umpire::feed(double time, const Service& service)
{
  if (rules_.service_court) return {"rules '" + rules_.name + "': a ball is served by a player, not fed"};
  if (Refusal refusal = putInPlay(time, service)) return refusal;
  rally_.feed(setupOf(time, service));
  return {};
}

std::optional<BallId> Umpire::ball() const
{
  if (phase() == Phase::InHand || inPlay(phase())) return rally_.ball();
  return std::nullopt;
}

BallSample Umpire::sampleOf(double time, const BallState& state) const
{
  return {time, court().positionInT(state.p_WB), court().vectorInT(state.v_WB), state.w_WB.norm()};
}

// False: what is told of that time is not to be believed.
bool Umpire::timeRuns(double time)
{
  if (time >= time_ - kSameTime)
  {
    time_ = std::max(time, time_);
    return true;
  }
  char reason[80];
  std::snprintf(reason, sizeof(reason), "the time went from %.6g s to %.6g s", time_, time);
  if (std::isfinite(time))
  {
    if (game_start_) game_start_ = *game_start_ + (time - time_);  // what was played of the game stays played
    time_ = time;
  }
  if (ball()) callLet(time_, "2.9.2.4", reason);
  return false;
}

void Umpire::contact(const Contact& contact)
{
  if (!timeRuns(contact.time)) return;
  const std::optional<BallId> mine = ball();
  if (!mine || (contact.ball != *mine && !(contact.with_ball && contact.other_ball == *mine))) return;
  const Touch touch = court().touchOf(contact, *mine, rally_.radius());
  received_ |= touch.part == Part::Racket && playerAt(touch.end) != score().server;
  const std::optional<Verdict> verdict = rally_.touched(touch);
  score_.showStrokes(rally_.strokes());
  decide(verdict);
}

void Umpire::ballAt(double time, const BallState& state)
{
  if (!timeRuns(time) || !inPlay(phase())) return;
  if (!state.p_WB.allFinite() || !state.v_WB.allFinite())
    return callLet(time, "2.9.2.4", "where the ball is, is not a number");
  decide(rally_.seen(sampleOf(time, state)));
  expediteIfDue(time);
}

void Umpire::clock(double time)
{
  if (timeRuns(time)) expediteIfDue(time);
}

void Umpire::racketTouchedNet(double time, End end)
{
  if (timeRuns(time)) decide(rally_.racketTouchedNet(time, end));
}

void Umpire::tableMoved(double time, const Pose& X_WB, std::optional<Player> by)
{
  rally_.moveTable(X_WB);
  if (!timeRuns(time) || !inPlay(phase())) return;
  if (by) return decide(rally_.movedPlayingSurface(time, endOf(*by)));
  callLet(time, "2.9.2.4", "the table was moved");
}

Refusal Umpire::let(double time, const std::string& reason, const char* law)
{
  if (!timeRuns(time)) return {"the time went back"};
  if (!ball()) return {"no ball is in play"};
  callLet(time, law, reason);
  return {};
}

Refusal Umpire::receiverNotReady(double time)
{
  if (!timeRuns(time)) return {"the time went back"};
  if (!inPlay(phase())) return {"no ball is in play"};
  if (received_) return {std::string(name(other(score().server))) + " has attempted to strike the ball (2.9.1.2)"};
  callLet(time, "2.9.1.2", std::string(name(other(score().server))) + " was not ready to receive");
  return {};
}

std::vector<Call> Umpire::takeCalls()
{
  std::vector<Call> taken;
  taken.swap(calls_);
  return taken;
}
}  // namespace ping_pong::game
