// The part of a rally that needs no touch: balls that pass the end line or the net, that lie still, or are gone.
#include <cmath>
#include <cstdio>

#include "game/rally.h"

namespace ping_pong::game
{
namespace
{
// A ball that a surface bears. In flight gravity would have changed its speed by 1 m/s in this time.
constexpr double kLyingSpeed = 1e-3;   // [m/s]
constexpr double kLyingHeight = 1e-3;  // of a rolling ball above the playing surface [m]
constexpr double kLyingTime = 0.1;     // [s]
constexpr double kDepth =
    1.5;  // below the playing surface: twice the height of the table, no stroke comes from there [m]
}  // namespace

Rally::Decision Rally::seen(const BallSample& sample)
{
  if (!inPlay(phase_)) return std::nullopt;
  Decision decision;
  if (phase_ == Phase::Toss)
  {
    if (const auto broken = toss_.see(court_, rules_, sample)) decision = fault(sample.time, broken->law, broken->what);
  }
  else
    decision = passedThroughNet(sample);
  if (!decision) decision = passedEndLine(sample);
  if (!decision) decision = lost(sample);
  before_ = sample;
  return decision;
}

// 2.10.1.5. The net of a scene is solid: only methods that look at the ends of steps let a ball through it.
Rally::Decision Rally::passedThroughNet(const BallSample& sample) const
{
  if (!before_) return std::nullopt;
  const double from = before_->p_TB.x();
  const double to = sample.p_TB.x();
  if ((from < 0.0) == (to < 0.0)) return std::nullopt;
  const Vector3d p_T = before_->p_TB + from / (from - to) * (sample.p_TB - before_->p_TB);
  if (p_T.z() < 0.0 || p_T.z() > court_.net_height || std::abs(p_T.y()) > court_.net_half_width) return std::nullopt;
  const std::string what = "the ball passed through the net";
  if (phase_ == Phase::ServiceStruck || phase_ == Phase::ServiceBounced)
    return notReached(sample.time, "passed through the net");
  return pointAgainst(phase_ == Phase::InCourt ? other(striker_) : striker_, sample.time, "2.10.1.5", what);
}

// 2.10.1.4. Once all of the ball is past the line it can touch no edge any more.
Rally::Decision Rally::passedEndLine(const BallSample& sample) const
{
  if (phase_ == Phase::Toss || phase_ == Phase::InCourt) return std::nullopt;
  const End opponent = other(striker_);
  if (!court_.behindEndLine(opponent, sample.p_TB, setup_.radius)) return std::nullopt;
  return notReached(sample.time, "passed " + who(opponent) + "'s end line", "2.10.1.4");
}

bool Rally::lies(const BallSample& sample) const
{
  if (sample.v_TB.norm() < kLyingSpeed) return true;
  return court_.overSurface(sample.p_TB, 0.0) && std::abs(sample.p_TB.z() - setup_.radius) < kLyingHeight &&
         std::abs(sample.v_TB.z()) < kLyingSpeed;
}

Rally::Decision Rally::lost(const BallSample& sample)
{
  if (sample.p_TB.head<2>().norm() > rules_.reach || sample.p_TB.z() < -kDepth || sample.p_TB.z() > rules_.reach)
    return notReached(sample.time, "left the playing area");
  if (sample.time - touch_time_ > rules_.patience) return notReached(sample.time, "did not come back");
  const bool lay = lying_;
  lying_ = lies(sample);
  if (!lying_) return std::nullopt;
  if (!lay) lies_since_ = sample.time;
  if (sample.time - lies_since_ < kLyingTime) return std::nullopt;
  return notReached(sample.time, "lay on something");
}

// The ball did not come to where it had to. `what` continues "A's return", `law` is that of a return.
Rally::Decision Rally::notReached(double time, const std::string& what, const char* law) const
{
  switch (phase_)
  {
    case Phase::Toss:
      return fault(time, "2.6.3", "did not strike the ball: it " + what);
    case Phase::ServiceStruck:
    case Phase::ServiceBounced:
    {
      const bool own = phase_ == Phase::ServiceBounced || !rules_.service_court;
      const End missed = own ? other(striker_) : striker_;
      return fault(time, "2.6.3", "served past " + who(missed) + "'s court: the ball " + what);
    }
    case Phase::InCourt:
      return pointAgainst(other(striker_), time, "2.10.1.3",
                          who(other(striker_)) + " did not strike the ball: it " + what);
    default:
      return pointAgainst(
          striker_, time, law,
          who(striker_) + "'s return " + what + " without touching " + who(other(striker_)) + "'s court");
  }
}
}  // namespace ping_pong::game
