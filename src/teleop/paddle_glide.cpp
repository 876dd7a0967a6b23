#include "paddle_glide.h"

#include "messages.h"
#include "ping_pong_sim/PaddleCommand.h"

namespace ping_pong_sim
{
namespace
{
constexpr double kLongestTick = 0.1;  ///< [s]; what is longer is a jump of time
}  // namespace

void PaddleGlide::take(const std::string& paddle)
{
  if (paddle == paddle_) return;
  if (sent_) send(true);
  paddle_ = paddle;
  wish_ = {};
  glide_ = {};
  p_W_.reset();
  command_ = paddle.empty() ? ros::Publisher() : nh_.advertise<PaddleCommand>(paddle + "/command", 1);
}

void PaddleGlide::setReach(const std::optional<ping_pong::TableEnd>& end, const ping_pong::Reach& reach)
{
  end_ = end;
  reach_ = reach;
}

bool PaddleGlide::wish(const ping_pong::Wish& wish, const Eigen::Matrix3d& axes, const ping_pong::GlideParams& params)
{
  const bool other = wish.move != wish_.move || wish.turn != wish_.turn;
  const bool started = !wish.isZero() && !sent_;
  wish_ = wish;
  axes_ = axes;
  params_ = params;
  if (!started || paddle_.empty() || tick_ <= 0.0) return other;
  drive(tick_);
  driven_to_ += tick_;
  return other;
}

void PaddleGlide::follow(const PaddleStates& states)
{
  if (paddle_.empty()) return;
  const double dt = states.time - driven_to_;
  const bool jumped = dt < -kLongestTick || dt > kLongestTick;
  for (const PaddleState& state : states.paddles)
  {
    if (state.name != paddle_) continue;
    const bool first = !p_W_ || jumped || !sent_;
    p_W_ = fromMessage(state.pose.position);
    if (first) in_reach_ = end_ && contains(reach_, end_->X_WE.inverse() * *p_W_);
  }
  // Back to the start, or a long time without states.
  if (jumped)
  {
    glide_ = {};
    driven_to_ = states.time;
    return;
  }
  if (dt <= 0.0) return;
  tick_ = dt;
  driven_to_ = states.time;
  if (sent_ || !wish_.isZero()) drive(dt);
}

void PaddleGlide::drive(double dt)
{
  const Eigen::Vector3d a_W = params_.acceleration * (axes_ * wish_.move);
  const Eigen::Vector3d alpha_W = params_.angular_acceleration * (axes_ * wish_.turn);
  glide_ = ping_pong::glide(glide_, a_W, alpha_W, params_.damping, dt);
  keepWithinReach();
  send(wish_.isZero() && glide_.v_W.isZero(0.0) && glide_.w_W.isZero(0.0));
}

void PaddleGlide::keepWithinReach()
{
  if (!in_reach_ || !end_ || !reach_.limited) return;
  const Eigen::Matrix3d& R_WE = end_->X_WE.linear();
  const Eigen::Vector3d p_E = end_->X_WE.inverse() * *p_W_;
  glide_.v_W = R_WE * ping_pong::slowedAtBorder(reach_, p_E, R_WE.transpose() * glide_.v_W, params_.damping);
}

void PaddleGlide::send(bool hold)
{
  PaddleCommand command;
  command.mode = hold ? PaddleCommand::HOLD : PaddleCommand::VELOCITY;
  command.pose.orientation.w = 1.0;
  command.twist.linear = toVectorMessage(glide_.v_W);
  command.twist.angular = toVectorMessage(glide_.w_W);
  command_.publish(command);
  sent_ = !hold;
}
}  // namespace ping_pong_sim
