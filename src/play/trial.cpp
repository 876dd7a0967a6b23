#include "trial.h"

#include <algorithm>
#include <ctime>

namespace ping_pong::play
{
namespace
{
constexpr double kStowed = 10.0;  // above the floor [m]

std::vector<Player> makePlayers(const Scene& scene, const std::vector<PlayerParams>& params)
{
  std::vector<Player> players;
  for (const PlayerParams& its : params) players.emplace_back(scene, its);
  return players;
}

// Time that this thread was at work: others on the same core do not count [s].
double threadTime()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
}  // namespace

Trial::Trial(std::shared_ptr<const Scene> scene, const std::vector<PlayerParams>& players, double tick)
    : scene_(std::move(scene)), params_(players), tick_(tick), world_(scene_), players_(makePlayers(*scene_, params_))
{
  for (const PlayerParams& params : params_) bodies_.push_back(world_.findBody(params.paddle));
  before_.assign(players_.size(), Vector3d::Zero());
  seen_.balls.resize(1);
}

std::size_t Trial::playerOf(std::size_t body) const
{
  const auto found = std::find(bodies_.begin(), bodies_.end(), body);
  return found == bodies_.end() ? kNone : static_cast<std::size_t>(found - bodies_.begin());
}

void Trial::restart(const BallState& ball, std::uint64_t seed)
{
  world_.reset();
  for (std::size_t i = 0; i < params_.size(); ++i)
  {
    PlayerParams params = params_[i];
    params.seed = 2 * seed + i;
    players_[i] = Player(*scene_, params);
    before_[i].setZero();
  }
  // A paddle without a player is out of the way.
  for (std::size_t body = 0; body < world_.bodyCount(); ++body)
    if (world_.body(body).kind == BodyKind::Kinematic && playerOf(body) == kNone)
      world_.setBodyPose(body, {Vector3d(0.0, 0.0, kStowed), Quaterniond::Identity()});
  world_.setBallState(world_.ballId(0), ball);
  server_ = kNone;
}

void Trial::tick()
{
  const BallState ball = world_.ballState(0);
  seen_.time = world_.time();
  seen_.tick = tick_;
  seen_.balls[0] = {world_.ballId(0), ball.p_WB, ball.v_WB, ball.w_WB};
  for (std::size_t i = 0; i < players_.size(); ++i)
  {
    seen_.pose = world_.bodyPose(bodies_[i]);
    seen_.twist = world_.bodyTwist(bodies_[i]);
    seen_.to_serve = server_ == i;
    const double start = threadTime();
    const PaddleCommand command = players_[i].update(seen_);
    const double took = threadTime() - start;
    planning_ += took;
    worst_ = std::max(worst_, took);
    ++updates_;
    world_.command(bodies_[i], command);
  }
  blocked_ += world_.advance(tick_).blocked_paddles;
  for (std::size_t i = 0; i < players_.size(); ++i)
  {
    const Vector3d v = world_.bodyTwist(bodies_[i]).v;
    top_speed_ = std::max(top_speed_, v.norm());
    top_acceleration_ = std::max(top_acceleration_, (v - before_[i]).norm() / tick_);
    before_[i] = v;
  }
}
}  // namespace ping_pong::play
