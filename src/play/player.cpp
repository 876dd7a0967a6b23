#include "player.h"

#include "player_impl.h"

namespace ping_pong::play
{
Player::Player(const Scene& scene, const PlayerParams& params) : impl_(std::make_unique<Impl>(scene, params)) {}
Player::~Player() = default;
Player::Player(Player&&) noexcept = default;
Player& Player::operator=(Player&&) noexcept = default;

PaddleCommand Player::update(const Observation& now)
{
  return impl_->update(now);
}

BallState Player::toss() const
{
  return impl_->toss();
}

Pose Player::ready() const
{
  return impl_->court.toWorld(impl_->ready.pose());
}

void Player::reset()
{
  impl_->reset();
}

const Court& Player::court() const
{
  return impl_->court;
}
const Prediction& Player::prediction() const
{
  return impl_->estimate.prediction();
}
const StrokePlan* Player::plan() const
{
  return impl_->plan ? &*impl_->plan : nullptr;
}
std::uint64_t Player::plans() const
{
  return impl_->plans;
}
std::uint64_t Player::unplayable() const
{
  return impl_->unplayable;
}
}  // namespace ping_pong::play
