#include "match/headless_match.h"

#include <stdexcept>

#include "game/observe.h"

namespace ping_pong
{
namespace
{
// Neither ball nor seeds of the players shall have to do with each other.
std::uint64_t mixed(std::uint64_t seed, std::uint64_t salt)
{
  std::uint64_t z = seed + 0x9e3779b97f4a7c15ull * (salt + 1);  // splitmix64 (Steele et al. 2014)
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

const MatchSetup& checked(const MatchSetup& setup)
{
  if (!setup.scene) throw std::invalid_argument("match: no scene");
  if (setup.rules.change_ends)
    throw std::invalid_argument("match: change_ends: true: players without legs keep their ends");
  if (!(setup.tick > 0.0 && setup.tick <= 0.1))
    throw std::invalid_argument("match: tick: expected above 0, up to 0.1 [s]");
  return setup;
}
}  // namespace

HeadlessMatch::HeadlessMatch(const MatchSetup& setup)
    : setup_(checked(setup)),
      world_(setup.scene),
      umpire_(game::findCourt(*setup.scene), setup.rules, setup.first_server)
{
  for (std::size_t i = 0; i < 2; ++i)
  {
    const game::Player player = i == 0 ? game::Player::A : game::Player::B;
    paddle_[i] = umpire_.court().racket[index(umpire_.endOf(player))];
    play::PlayerParams params;
    params.paddle = setup.scene->bodies[paddle_[i]].name;
    params.end = play::endOfPaddle(*setup.scene, params.paddle);
    params.level = setup.levels[i];
    params.style = setup.styles[i];
    params.seed = mixed(setup.seed, i);
    players_.emplace_back(*setup.scene, params);
  }
}

bool HeadlessMatch::advance()
{
  if (umpire_.score().winner || world_.time() >= setup_.time_limit) return false;
  serveIfDue();
  movePlayers();
  world_.advance(setup_.tick);
  game::observe(world_, umpire_);
  if (umpire_.ball()) idle_since_ = world_.time();
  for (const game::Call& call : umpire_.takeCalls())
  {
    note(call);
    calls_.push_back(call);
  }
  return true;
}

void HeadlessMatch::serveIfDue()
{
  if (umpire_.ball() || world_.time() - idle_since_ < setup_.pause) return;
  if (ball_) world_.deleteBall(*ball_);
  const std::size_t server = index(umpire_.score().server);
  const BallParams params = setup_.scene->balls.empty() ? BallParams() : setup_.scene->balls.front().params;
  const BallState state = players_[server].toss();
  BallId id = 0;
  if (world_.spawnBall(params, state, &id)) return;  // a racket is in the way: a tick later perhaps
  ball_ = id;
  for (play::Player& player : players_) player.reset();
  ++result_.services[server];
  umpire_.putInPlay(world_.time(), {id, params.radius, std::nullopt});
  umpire_.thrown(world_.time(), state);
}

void HeadlessMatch::movePlayers()
{
  play::Observation now;
  now.time = world_.time();
  now.tick = setup_.tick;
  const std::size_t found = ball_ ? world_.findBall(*ball_) : kNone;
  if (found != kNone)
  {
    const BallState state = world_.ballState(found);
    now.balls.push_back({*ball_, state.p_WB, state.v_WB, state.w_WB});
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    now.pose = world_.bodyPose(paddle_[i]);
    now.twist = world_.bodyTwist(paddle_[i]);
    now.to_serve = umpire_.phase() == game::Phase::Toss && index(umpire_.score().server) == i;
    world_.command(paddle_[i], players_[i].update(now));
  }
}

void HeadlessMatch::note(const game::Call& call)
{
  const bool rally = call.kind == game::CallKind::Point || call.kind == game::CallKind::Fault;
  if (rally) result_.strokes += static_cast<std::size_t>(call.score.strokes);
  if (call.kind == game::CallKind::Fault && call.winner) ++result_.faults[1 - index(*call.winner)];
}

std::vector<game::Call> HeadlessMatch::takeCalls()
{
  std::vector<game::Call> taken;
  taken.swap(calls_);
  return taken;
}

MatchResult HeadlessMatch::result() const
{
  MatchResult result = result_;
  result.winner = umpire_.score().winner;
  result.games = umpire_.finishedGames();
  result.score = umpire_.score();
  result.time = world_.time();
  return result;
}

MatchResult HeadlessMatch::play()
{
  while (advance()) calls_.clear();
  return result();
}
}  // namespace ping_pong
