#include "paddle_play.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "messages.h"
#include "ping_pong_sim/PaddleCommand.h"

namespace ping_pong_sim
{
namespace
{
constexpr double kLongestTick = 0.1;  ///< [s]; what is longer is a jump of time
constexpr double kFarSide = 4.0;      ///< balls beyond are not played [m]
constexpr double kAside = 2.0;        ///< likewise [m]
constexpr double kThrown =
    0.5;  ///< slower along the table than this, a ball is thrown up and may drift either way [m/s]
}  // namespace

void PaddlePlay::take(const std::string& paddle, const std::optional<ping_pong::TableEnd>& end)
{
  end_ = end;
  if (paddle == paddle_) return;
  release();
  paddle_ = paddle;
  command_ = paddle.empty() ? ros::Publisher() : nh_.advertise<PaddleCommand>(paddle + "/command", 1);
}

void PaddlePlay::release()
{
  pointed_ = taken_ = false;
  balls_topic_.shutdown();
  ball_.reset();
}

void PaddlePlay::point(const EyeRay& ray, const ping_pong::Reach& reach)
{
  if (!end_ || paddle_.empty()) return;
  const Eigen::Isometry3d X_EW = end_->X_WE.inverse();
  const auto p_E = ping_pong::onPlane(X_EW * ray.origin, X_EW.linear() * ray.direction, hand_.params().depth);
  if (!p_E) return;
  hand_.point(*p_E, reach);
  if (!pointed_)
  {
    const boost::function<void(const BallStates::ConstPtr&)> see = [this](const BallStates::ConstPtr& balls)
    { onBalls(*balls); };
    balls_topic_ = nh_.subscribe<BallStates>("balls", 1, see, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  }
  pointed_ = true;
  // Ahead of the next state, by a tick at most.
  if (taken_ && tick_ > 0.0 && ahead_ == 0.0)
  {
    move(tick_);
    ahead_ = tick_;
  }
}

void PaddlePlay::follow(const PaddleState& state, double time)
{
  const double dt = time - time_;
  time_ = time;
  if (!pointed_ || !end_) return;
  if (!taken_ || dt < 0.0 || dt > kLongestTick)
  {
    const FramePose pose = fromMessage(state.pose);
    const Eigen::Isometry3d X_EW = end_->X_WE.inverse();
    const Eigen::Quaterniond q_EW(X_EW.linear());
    hand_.take({X_EW * pose.p, q_EW * pose.q, q_EW * fromMessage(state.twist.linear),
                q_EW * fromMessage(state.twist.angular)});
    taken_ = true;
    ahead_ = 0.0;
    return;
  }
  if (dt == 0.0) return;
  tick_ = dt;
  const double left = dt - ahead_;
  ahead_ = 0.0;
  if (left > 1e-9) move(left);
}

// The one that is soonest at this end.
void PaddlePlay::onBalls(const BallStates& balls)
{
  ball_.reset();
  if (!end_) return;
  const Eigen::Isometry3d X_EW = end_->X_WE.inverse();
  double soonest = std::numeric_limits<double>::infinity();
  for (const BallState& ball : balls.balls)
  {
    ping_pong::BallSight sight{X_EW * fromMessage(ball.pose.position), X_EW.linear() * fromMessage(ball.twist.linear),
                               X_EW.linear() * fromMessage(ball.twist.angular)};
    if (sight.v.x() > kThrown || sight.p.x() > kFarSide || std::abs(sight.p.y()) > kAside) continue;
    const double in = (sight.p.x() - hand_.params().depth) / std::max(-sight.v.x(), kThrown);
    if (in <= 0.0 || in > soonest) continue;
    soonest = in;
    ball_ = sight;
  }
}

void PaddlePlay::move(double dt)
{
  send(hand_.move(dt, ball_));
}

void PaddlePlay::send(const ping_pong::Followed& blade_E)
{
  const Eigen::Isometry3d& X_WE = end_->X_WE;
  PaddleCommand command;
  command.mode = PaddleCommand::POSE;
  command.pose = toMessage(FramePose{X_WE * blade_E.p, Eigen::Quaterniond(X_WE.linear()) * blade_E.q});
  command.twist.linear = toVectorMessage(X_WE.linear() * blade_E.v);
  command.twist.angular = toVectorMessage(X_WE.linear() * blade_E.w);
  command_.publish(command);
}
}  // namespace ping_pong_sim
