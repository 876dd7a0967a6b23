#include "operator.h"

#include <ros/this_node.h>

#include <algorithm>

#include "selection.h"

namespace ping_pong_sim
{
namespace
{
using ping_pong::Action;
using ping_pong::Group;

constexpr double kHeartbeat = 1.0;  ///< of `hands` [s]
constexpr double kNoteLife = 4.0;   ///< [s]

class Post : public ros::CallbackInterface
{
public:
  explicit Post(std::function<void()> job) : job_(std::move(job)) {}
  CallResult call() override
  {
    job_();
    return Success;
  }

private:
  std::function<void()> job_;
};

ros::NodeHandle onQueue(ros::CallbackQueue& queue)
{
  ros::NodeHandle nh;
  nh.setCallbackQueue(&queue);
  return nh;
}

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
  return a.selected == b.selected && a.moving == b.moving && a.help == b.help && a.note == b.note;
}
}  // namespace

Operator::Operator(const std::string& simulator, std::shared_ptr<tf2_ros::Buffer> frames,
                   const ping_pong::HoldLimits& limits, Listener listener)
    : nh_(onQueue(queue_)),
      link_(nh_, simulator, std::move(frames)),
      paddle_(nh_),
      held_(limits),
      listener_(std::move(listener))
{
  state_.operator_name = ros::this_node::getName();
  hands_ = nh_.advertise<HandsState>("hands", 10);
  others_ = nh_.subscribe("hands", 10, &Operator::onOther, this);
  paddles_ = nh_.subscribe("paddles", 10, &Operator::onPaddles, this, ros::TransportHints().tcpNoDelay());
  thread_ = std::thread([this] { run(); });
}

Operator::~Operator()
{
  running_ = false;
  thread_.join();
  paddle_.take("");
}

void Operator::setParams(const OperatorParams& params)
{
  post([=] { params_ = params; });
}

void Operator::setView(const Eigen::Vector3d& right_W, const Eigen::Vector3d& up_W)
{
  post([=] { axes_ = ping_pong::viewAxes(right_W, up_W); });
}

void Operator::press(ping_pong::Key key)
{
  post(
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
  post(
      [=]
      {
        held_.release(key);
        wishChanged();
      });
}

void Operator::releaseAll()
{
  post(
      [=]
      {
        held_.releaseAll();
        wishChanged();
      });
}

void Operator::post(std::function<void()> job)
{
  queue_.addCallback(boost::make_shared<Post>(std::move(job)));
}

void Operator::run()
{
  while (running_ && ros::ok())
  {
    queue_.callAvailable(ros::WallDuration(0.02));
    tick();
  }
}

void Operator::tick()
{
  const double now = wallSeconds();
  const bool any = held_.any();
  held_.expire(now);
  if (any) wishChanged();
  if (state_.selected.empty()) select(Group::Paddles);
  moveSteadily(now);
  const std::string trouble = link_.trouble();
  note(trouble);
  if (trouble.empty() && (troubled_ || now > note_until_)) state_.note.clear();
  troubled_ = !trouble.empty();
  state_.moving = held_.any() || paddle_.moving();
  publish(now - told_at_ > kHeartbeat);
}

void Operator::obey(const ping_pong::KeyEntry& entry)
{
  const SimStatus* status = link_.status();
  switch (entry.action)
  {
    case Action::Select:
      select(entry.group);
      break;
    case Action::Move:
    case Action::Turn:
      held_.press(entry.key, wallSeconds());
      wishChanged();
      break;
    case Action::Pause:
      note(link_.setPaused(status == nullptr || !status->paused));
      break;
    case Action::Step:
      if (status != nullptr && !status->paused) note(link_.setPaused(true));
      note(link_.step(params_.step));
      break;
    case Action::Reset:
      note(link_.reset());
      break;
    case Action::Launch:
      note(link_.launch(params_.shot));
      break;
    case Action::Help:
      state_.help = !state_.help;
      break;
    case Action::View:
      break;  // the window's own
  }
}

void Operator::select(Group group)
{
  const SimStatus* status = link_.status();
  if (status == nullptr) return;
  const std::vector<std::string> names = members(*status, group);
  if (names.empty())
  {
    if (!state_.selected.empty()) note("this scene has none of these");
    return;
  }
  state_.selected = nextOf(names, state_.selected);
  steady_.stop();
  paddle_.take(isPaddle(*status, state_.selected) ? state_.selected : "");
  wishChanged();
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
  paddle_.follow(*states);
  if (!awaits_paddle_ || !movesIn(*states, state_.selected)) return;
  awaits_paddle_ = false;
  if (listener_.paddle_obeys) listener_.paddle_obeys();
}

void Operator::wishChanged()
{
  const ping_pong::Wish wish = gliding() ? held_.wish() : ping_pong::Wish();
  if (paddle_.wish(wish, axes(), params_.glide)) awaits_paddle_ = true;
}

void Operator::moveSteadily(double now)
{
  const ping_pong::Wish wish = held_.wish();
  if (wish.isZero() || state_.selected.empty() || gliding())
    steady_.stop();
  else
    note(steady_.go(link_, state_.selected, wish, axes(), params_.glide, now));
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
