#include "operator.h"

#include <ros/this_node.h>

#include <algorithm>

#include "selection.h"

namespace ping_pong_sim
{
namespace
{
constexpr double kHeartbeat = 1.0;  ///< of `hands` [s]
constexpr double kNoteLife = 4.0;   ///< [s]

bool movesIn(const PaddleStates& states, const std::string& paddle)
{
  const auto moves = [&](const PaddleState& state)
  {
    return state.name == paddle &&
           !(fromMessage(state.twist.linear).isZero(0.0) && fromMessage(state.twist.angular).isZero(0.0));
  };
  return std::any_of(states.paddles.begin(), states.paddles.end(), moves);
}

bool same(const HandsState& a, const HandsState& b)
{
  return a.selected == b.selected && a.moving == b.moving && a.mouse == b.mouse && a.player == b.player &&
         a.level == b.level && a.help == b.help && a.note == b.note;
}
}  // namespace

Operator::Operator(const NodeNames& names, int player, std::shared_ptr<tf2_ros::Buffer> frames,
                   const ping_pong::HoldLimits& limits, Listener listener)
    : nh_(worker_.nodeHandle()),
      link_(nh_, names.simulator, std::move(frames)),
      match_(nh_, link_, names.umpire, player),
      paddle_(nh_),
      play_(nh_),
      held_(limits),
      listener_(std::move(listener))
{
  state_.operator_name = ros::this_node::getName();
  hands_ = nh_.advertise<HandsState>("hands", 10);
  others_ = nh_.subscribe("hands", 10, &Operator::onOther, this);
  paddles_ = nh_.subscribe("paddles", 10, &Operator::onPaddles, this, ros::TransportHints().tcpNoDelay());
  worker_.start([this] { tick(); });
}

Operator::~Operator()
{
  worker_.stop();
  paddle_.take("");
}

void Operator::setParams(const OperatorParams& params)
{
  worker_.post(
      [=]
      {
        params_ = params;
        play_.hand().setParams(params.play);
        state_.mouse = params.mouse;
        if (!params.mouse) play_.release();
      });
}

void Operator::setView(const Eigen::Vector3d& right_W, const Eigen::Vector3d& up_W)
{
  worker_.post([=] { axes_ = ping_pong::viewAxes(right_W, up_W); });
}

void Operator::press(ping_pong::Key key)
{
  worker_.post(
      [=]
      {
        if (const ping_pong::KeyEntry* entry = ping_pong::findKey(key))
          obey(*entry);
        else
          note("this key does nothing; H shows the keys");
      });
}

void Operator::release(ping_pong::Key key)
{
  worker_.post(
      [=]
      {
        held_.release(key);
        wishChanged();
      });
}

void Operator::releaseAll()
{
  worker_.post(
      [=]
      {
        held_.releaseAll();
        wishChanged();
      });
}

void Operator::point(const EyeRay& ray)
{
  worker_.post(
      [=]
      {
        const SimStatus* status = link_.status();
        if (!params_.mouse || status == nullptr || status->paused || paddle_.moving()) return;
        play_.point(ray, params_.reach);
      });
}

void Operator::tilt(double angle)
{
  worker_.post([=] { play_.hand().tilt(angle); });
}

void Operator::stroke(bool up)
{
  worker_.post([=] { play_.hand().stroke(up); });
}

void Operator::tick()
{
  const double now = wallSeconds();
  const bool any = held_.any();
  held_.expire(now);
  if (any) wishChanged();
  findEnds();
  if (state_.selected.empty()) select(ping_pong::Group::Paddles);
  moveSteadily(now);
  const std::string trouble = link_.trouble();
  note(trouble);
  if (trouble.empty() && (troubled_ || now > note_until_)) state_.note.clear();
  troubled_ = !trouble.empty();
  state_.player = static_cast<std::int8_t>(match_.player());
  state_.level = static_cast<std::uint8_t>(match_.score() != nullptr ? match_.level() : 0);
  state_.moving = held_.any() || paddle_.moving() || play_.active();
  publish(now - told_at_ > kHeartbeat);
}

// While the world stands still a paddle cannot be swung, but put elsewhere like everything else.
bool Operator::gliding() const
{
  const SimStatus* status = link_.status();
  return status != nullptr && !status->paused && isPaddle(*status, state_.selected);
}

Eigen::Matrix3d Operator::axes() const
{
  return params_.world_axes ? Eigen::Matrix3d::Identity() : axes_;
}

void Operator::onPaddles(const PaddleStates::ConstPtr& states)
{
  paddle_states_ = *states;
  paddle_.follow(*states);
  for (const PaddleState& state : states->paddles)
  {
    if (state.name == play_.paddle()) play_.follow(state, states->time);
  }
  if (!awaits_paddle_ || !movesIn(*states, state_.selected)) return;
  awaits_paddle_ = false;
  if (listener_.paddle_obeys) listener_.paddle_obeys();
}

std::string Operator::ownPaddle() const
{
  return match_.score() != nullptr ? match_.ownPaddle() : paddleAtMinusX(paddle_states_);
}

// Tables and paddles may be moved, and players change ends.
void Operator::findEnds()
{
  const std::optional<FramePose> table = link_.pose("table");
  const auto end_of = [&](const std::string& paddle) -> std::optional<ping_pong::TableEnd>
  {
    for (const PaddleState& state : paddle_states_.paddles)
    {
      if (state.name != paddle || !table) continue;
      return ping_pong::nearerEnd(Eigen::Translation3d(table->p) * table->q, fromMessage(state.pose.position));
    }
    return std::nullopt;
  };
  paddle_.setReach(end_of(state_.selected), params_.reach);
  const std::string own = ownPaddle();
  const std::optional<ping_pong::TableEnd> end = end_of(own);
  play_.take(own, end);
  if (end) own_end_ = end->sign;
}

void Operator::note(const std::string& text)
{
  if (text.empty()) return;
  state_.note = text;
  note_until_ = wallSeconds() + kNoteLife;
}

void Operator::onOther(const HandsState::ConstPtr& other)
{
  if (other->operator_name == state_.operator_name || !other->moving || !state_.moving) return;
  if (other->selected == state_.selected) note(state_.selected + " is also moved by " + other->operator_name);
}

void Operator::publish(bool always)
{
  const bool changed = !same(state_, told_);
  if (!changed && !always) return;
  state_.header.stamp = ros::Time::now();
  state_.header.frame_id = state_.selected;
  told_ = state_;
  told_at_ = wallSeconds();
  hands_.publish(state_);
  if (changed && listener_.changed) listener_.changed(state_);
}
}  // namespace ping_pong_sim
