#include "steady_move.h"

#include <algorithm>

namespace ping_pong_sim
{
namespace
{
constexpr double kPeriod = 1.0 / 30.0;  ///< each move is a service call [s]
}  // namespace

std::string SteadyMove::go(SimLink& link, const std::string& name, const ping_pong::Wish& wish,
                           const Eigen::Matrix3d& axes, const ping_pong::GlideParams& params, double now)
{
  if (moved_at_ == 0.0)
  {
    const std::optional<FramePose> pose = link.pose(name);
    if (!pose) return "nobody knows where " + name + " is";
    moved_to_ = *pose;
    moved_at_ = now - kPeriod;
  }
  const double dt = std::min(now - moved_at_, 3.0 * kPeriod);
  if (dt < kPeriod) return "";
  moved_at_ = now;
  moved_to_.p += params.speed * dt * (axes * wish.move);
  const Eigen::Vector3d turn = params.angular_speed * dt * (axes * wish.turn);
  if (!turn.isZero(0.0)) moved_to_.q = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * moved_to_.q;
  moved_to_.q.normalize();
  const std::optional<std::uint32_t> ball = ballOfFrame(name);
  const Eigen::Vector3d still = Eigen::Vector3d::Zero();
  const std::string refusal = ball ? link.place(*ball, moved_to_, still, still) : link.place(name, moved_to_);
  if (!refusal.empty()) stop();
  return refusal;
}
}  // namespace ping_pong_sim
