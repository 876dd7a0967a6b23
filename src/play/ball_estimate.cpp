#include "ball_estimate.h"

#include <algorithm>
#include <cmath>

namespace ping_pong::play
{
namespace
{
// Exact looks: what the prediction's own errors leave is far below, what a touch does far above.
constexpr double kSamePlace = 1e-4, kSameVelocity = 1e-3, kSameSpin = 0.1;  // [m], [m/s], [rad/s]
// A touch changes at least so much at once; errors of looks come on top, so many deviations of them.
constexpr double kJump = 0.02, kVelocityJump = 0.5, kDeviations = 6.0;  // [m], [m/s]
constexpr double kElsewhere = 0.3;                                      // a ball that was put somewhere else [m]
constexpr double kStrikersHalf = -0.10;                                 // the opponent strikes beyond this x [m]
constexpr double kExactGuard = 1e-5, kGuard = 0.02;  // about a predicted bounce looks tell nothing [s]
constexpr std::size_t kMostLooks = 12;               // in the mean
}  // namespace

BallEstimate::BallEstimate(const Scene& scene, const Court& court, const BallParams& ball, const LevelTraits& level,
                           std::uint64_t seed)
    : level_(level), perception_(level, seed), prediction_(scene, court, ball)
{
}

void BallEstimate::forget()
{
  perception_.forget();
  prediction_.forget();
  mine_ = false;
  bounces_ = 0;
}

BallEstimate::News BallEstimate::update(double time, const BallState& state)
{
  perception_.see(time, state);
  PathSample seen;
  return perception_.look(time, seen) ? adopt(seen) : News::None;
}

bool BallEstimate::nearBounce(double time) const
{
  const double guard = perception_.exact() ? kExactGuard : kGuard;
  for (const PredictedBounce& bounce : prediction_.bounces())
    if (std::abs(bounce.time - time) < guard) return true;
  return false;
}

void BallEstimate::noteBounces(double until)
{
  for (const PredictedBounce& bounce : prediction_.bounces())
    if (bounce.touched == Touched::OwnHalf && bounce.time > bounce_until_ && bounce.time <= until)
    {
      ++bounces_;
      bounce_from_ = bounce.time;
    }
  bounce_until_ = std::max(bounce_until_, until);
}

BallEstimate::News BallEstimate::adopt(const PathSample& seen)
{
  const bool known = !prediction_.empty() && seen.time <= prediction_.end();
  if (known && nearBounce(seen.time)) return News::None;
  const BallState expected = known ? prediction_.at(seen.time) : seen.state;
  const Vector3d dp = seen.state.p_WB - expected.p_WB, dv = seen.state.v_WB - expected.v_WB;
  const bool exact = perception_.exact();
  const double blur = exact ? 0.0 : kDeviations;
  const bool jump =
      dp.norm() > kJump + blur * level_.see_place || dv.norm() > kVelocityJump + blur * level_.see_velocity;
  if (!known || jump)
  {
    const bool elsewhere = prediction_.empty() || dp.norm() > kElsewhere;
    const bool by_opponent = known && seen.state.p_WB.x() > kStrikersHalf && seen.state.v_WB.x() < 0.0 && dv.x() < 0.0;
    const bool struck = elsewhere || by_opponent;
    if (!struck) noteBounces(seen.time);
    prediction_.predict(seen.time, seen.state);
    looks_ = 1;
    if (!struck) return News::Changed;
    mine_ = false;
    bounces_ = 0;
    bounce_until_ = seen.time;
    perception_.readSpinAnew();
    return News::Struck;
  }
  if (exact)
  {
    const double dw = (seen.state.w_WB - expected.w_WB).norm();
    if (dp.norm() < kSamePlace && dv.norm() < kSameVelocity && dw < kSameSpin) return News::None;
    noteBounces(seen.time);
    prediction_.predict(seen.time, seen.state);
    return News::Changed;
  }
  looks_ = std::min(looks_ + 1, kMostLooks);
  const double share = 1.0 / static_cast<double>(looks_);
  BallState mean = expected;
  mean.p_WB += share * dp;
  mean.v_WB += share * dv;
  mean.w_WB = seen.state.w_WB;
  noteBounces(seen.time);
  prediction_.predict(seen.time, mean);
  return News::Changed;
}

bool BallEstimate::window(double& from, double& to) const
{
  if (mine_ || prediction_.empty() || bounces_ > 1) return false;
  bool on_own = bounces_ == 1;
  from = on_own ? bounce_from_ : 0.0;
  to = prediction_.end();
  for (const PredictedBounce& bounce : prediction_.bounces())
  {
    if (bounce.time <= bounce_until_) continue;
    if (on_own)
    {
      to = bounce.time;
      return true;
    }
    if (bounce.touched == Touched::Other) return false;
    on_own = bounce.touched == Touched::OwnHalf;
    from = bounce.time;
  }
  return on_own;
}
}  // namespace ping_pong::play
