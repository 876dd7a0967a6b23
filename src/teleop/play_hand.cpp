#include "play_hand.h"

#include <algorithm>
#include <cmath>

namespace ping_pong
{
namespace
{
constexpr double kRate = 40.0;         ///< of the spring between mouse and blade: 25 ms behind [1/s]
constexpr double kMostTilt = 1.3;      ///< [rad]
constexpr double kButtonSwing = 0.10;  ///< from the button to the hit [s]
constexpr double kHelpedSwing = 0.14;  ///< from the start of a helper's stroke to the hit [s]
constexpr double kTooLate = 0.04;      ///< with less time than this a helper does not begin a stroke [s]
constexpr double kDriveAngle = 0.6;    ///< of a drive's way above the horizontal [rad]
constexpr double kPushAngle = -0.35;   ///< of a push's
constexpr double kDriveTilt = -0.25;   ///< closed
constexpr double kPushTilt = 0.5;      ///< open

Eigen::Vector3d inPlane(double angle)
{
  return {std::cos(angle), 0.0, std::sin(angle)};
}
}  // namespace

void PlayHand::point(const Eigen::Vector3d& p_E, const Reach& reach)
{
  wanted_ = Eigen::Vector3d(params_.depth, p_E.y(), p_E.z());
  if (reach.limited) wanted_ = clampTo(reach, wanted_);
}

void PlayHand::tilt(double angle)
{
  tilt_ = std::clamp(tilt_ + angle, -kMostTilt, kMostTilt);
}

void PlayHand::stroke(bool up)
{
  swing_ = Swing{params_.stroke_speed * inPlane(up ? kDriveAngle : kPushAngle), time_ + kButtonSwing, kButtonSwing};
  swing_tilt_ = up ? kDriveTilt : kPushTilt;
  by_helper_ = false;
}

void PlayHand::take(const Followed& paddle)
{
  hand_ = blade_ = paddle;
  swing_.reset();
  help_.reset();
}

const Followed& PlayHand::move(double dt, const std::optional<BallSight>& ball)
{
  time_ += dt;
  ask(ball);
  Eigen::Vector3d target = wanted_;
  if (help_) target.x() += params_.assistance * (help_->depth - target.x());
  hand_ = follow(hand_, target, attitude(), kRate, dt);
  blade_ = hand_;
  if (swing_ && over(*swing_, time_)) swing_.reset();
  if (swing_)
  {
    const SwingPoint offset = at(*swing_, time_);
    blade_.p += offset.p;
    blade_.v += offset.v;
  }
  return blade_;
}

// After the hit the ball flies away, and what was held for it is held a little longer: the stroke goes through.
void PlayHand::ask(const std::optional<BallSight>& ball)
{
  std::optional<Help> help;
  Followed hand = hand_;
  hand.p.x() = wanted_.x();
  if (ball && params_.assistance > 0.0) help = helper_(*ball, hand);
  if (help || !swing_) help_ = help;
  if (help) strikeWithHelp();
}

void PlayHand::strikeWithHelp()
{
  if (swing_ && !by_helper_) return;  // a button counts more
  if (help_->in > kHelpedSwing || (!swing_ && help_->in < kTooLate)) return;
  swing_ = Swing{std::min(1.0, 2.0 * params_.assistance) * help_->v, time_ + help_->in, kHelpedSwing};
  by_helper_ = true;
}

Eigen::Quaterniond PlayHand::attitude() const
{
  const double tilt = swing_ && !by_helper_ ? tilt_ + swing_tilt_ : tilt_;
  const Eigen::Quaterniond own = heldAt(wanted_, inPlane(tilt));
  return help_ ? own.slerp(params_.assistance, help_->q) : own;
}
}  // namespace ping_pong
