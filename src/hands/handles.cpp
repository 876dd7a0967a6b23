#include "handles.h"

#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "handle_markers.h"
#include "ping_pong_sim/shots.h"

namespace ping_pong_sim
{
namespace
{
constexpr char kTopic[] = "handles";
constexpr std::size_t kMostBalls = 20;     ///< with a handle: more would hide the scene
constexpr double kBallRadius = 0.020;      ///< of the shell's inside [m]
constexpr double kThrowTime = 0.1;         ///< the throwing bead is where the ball would be after so long [s]
constexpr double kBeadAbove = 0.08;        ///< above that, so that it can be grasped at rest [m]
constexpr double kStillWithin = 0.01;      ///< of the bead: what is less is no throw [m]
constexpr double kSpin = 2.0 * M_PI * 50;  ///< of the menu [rad/s]

const Eigen::Vector3d kHome(0.0, 0.0, kBeadAbove);

std::string throwName(std::uint32_t id)
{
  return "throw_" + std::to_string(id);
}

std::string arrowName(std::uint32_t id)
{
  return "arrow_" + std::to_string(id);
}

bool moved(const FramePose& a, const FramePose& b)
{
  return (a.p - b.p).norm() > 1e-3 || a.q.angularDistance(b.q) > 5e-3;
}

// x along the flight, z up; on a ball at rest as if it came from the launcher.
Eigen::Matrix3d flightAxes(const Eigen::Vector3d& v)
{
  Eigen::Vector3d x(v.x(), v.y(), 0.0);
  x = x.norm() > 0.1 ? Eigen::Vector3d(x.normalized()) : Eigen::Vector3d(-1.0, 0.0, 0.0);
  Eigen::Matrix3d axes;
  axes << x, Eigen::Vector3d::UnitZ().cross(x), Eigen::Vector3d::UnitZ();
  return axes;
}

std::set<std::string> wantedNames(const SimStatus& status)
{
  std::set<std::string> names(status.paddles.begin(), status.paddles.end());
  names.insert(status.furniture.begin(), status.furniture.end());
  for (const std::string& prop : status.props)
  {
    // A camera's handle would be where the viewer is.
    if (prop.compare(0, 6, "camera") != 0) names.insert(prop);
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(status.ball_ids.size(), kMostBalls); ++i)
  {
    names.insert("ball_" + std::to_string(status.ball_ids[i]));
  }
  return names;
}
}  // namespace

Handles::Handles(const std::string& simulator, std::shared_ptr<tf2_ros::Buffer> frames)
    : link_(nh_, simulator, std::move(frames)), server_(kTopic)
{
  listeners_ = nh_.advertise<visualization_msgs::InteractiveMarkerUpdate>(std::string(kTopic) + "/update", 100);
  const boost::function<void(const PaddleStates::ConstPtr&)> follow = [this](const PaddleStates::ConstPtr& states)
  {
    for (const PaddleState& state : states->paddles)
    {
      const auto paddle = paddles_.find(state.name);
      if (paddle != paddles_.end()) paddle->second->follow(state, states->time);
    }
  };
  paddles_topic_ =
      nh_.subscribe<PaddleStates>("paddles", 10, follow, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  buildMenus();
}

void Handles::buildMenus()
{
  for (interactive_markers::MenuHandler* menu : {&body_menu_, &ball_menu_})
  {
    menu->insert("Pause, go on",
                 [this](const auto&) { warn(link_.setPaused(link_.status() == nullptr || !link_.status()->paused)); });
    menu->insert("Reset", [this](const auto&) { warn(link_.reset()); });
    const auto launch = menu->insert("Launch");
    for (const ping_pong::Shot& shot : ping_pong::shots())
    {
      menu->insert(launch, shot.name, [this, name = shot.name](const auto&) { warn(link_.launch(name)); });
    }
  }
  ball_menu_.insert("Delete",
                    [this](const Feedback::ConstPtr& feedback)
                    {
                      if (const auto ball = ballOfFrame(feedback->marker_name)) warn(link_.deleteBall(*ball));
                    });
  const auto spin = ball_menu_.insert("Spin, 50 turns per second");
  // About the axes of flight: topspin turns the ball forwards, about the axis to its left.
  const std::pair<const char*, Eigen::Vector3d> spins[] = {{"topspin", {0, kSpin, 0}},
                                                           {"backspin", {0, -kSpin, 0}},
                                                           {"sidespin left", {0, 0, kSpin}},
                                                           {"sidespin right", {0, 0, -kSpin}},
                                                           {"none", {0, 0, 0}}};
  for (const auto& choice : spins)
  {
    ball_menu_.insert(spin, choice.first,
                      [this, w = choice.second](const Feedback::ConstPtr& feedback)
                      { spinBall(feedback->marker_name, w); });
  }
}

void Handles::update()
{
  const SimStatus* status = link_.status();
  if (status == nullptr || listeners_.getNumSubscribers() == 0) return;
  sync(*status);
  holdDraggedBalls();
  showWhereThingsAre();
  offerThrows(status->paused);
  server_.applyChanges();
}

void Handles::sync(const SimStatus& status)
{
  const std::set<std::string> wanted = wantedNames(status);
  for (auto handle = handles_.begin(); handle != handles_.end();)
  {
    if (wanted.count(handle->first) > 0)
    {
      ++handle;
      continue;
    }
    server_.erase(handle->first);
    paddles_.erase(handle->first);
    handle = handles_.erase(handle);
  }
  for (const std::string& name : wanted)
  {
    if (handles_.count(name) > 0) continue;
    if (const auto pose = link_.pose(name)) insert(name, *pose, status);
  }
}

void Handles::insert(const std::string& name, const FramePose& pose, const SimStatus& status)
{
  const bool ball = ballOfFrame(name).has_value();
  const bool paddle = std::count(status.paddles.begin(), status.paddles.end(), name) > 0;
  const bool furniture = std::count(status.furniture.begin(), status.furniture.end(), name) > 0;
  if (paddle) paddles_[name] = std::make_unique<PaddleDrag>(nh_, name);
  const double size = furniture ? 0.5 : 0.25;
  server_.insert(ball ? ballHandle(name, pose, kBallRadius) : bodyHandle(name, pose, size),
                 [this](const Feedback::ConstPtr& feedback) { onFeedback(feedback); });
  (ball ? ball_menu_ : body_menu_).apply(server_, name);
  handles_[name].shown = pose;
}

void Handles::showWhereThingsAre()
{
  for (auto& entry : handles_)
  {
    if (entry.second.dragged) continue;  // RViz moves it itself
    const std::optional<FramePose> pose = link_.pose(entry.first);
    if (!pose) continue;
    FramePose wanted = *pose;
    if (ballOfFrame(entry.first)) wanted.q = Eigen::Quaterniond::Identity();
    if (!moved(wanted, entry.second.shown)) continue;
    entry.second.shown = wanted;
    server_.setPose(entry.first, toMessage(wanted));
  }
}

// A hand holds the ball against gravity.
void Handles::holdDraggedBalls()
{
  const Eigen::Vector3d still = Eigen::Vector3d::Zero();
  for (const auto& entry : handles_)
  {
    const std::optional<std::uint32_t> ball = ballOfFrame(entry.first);
    if (ball && entry.second.dragged) warn(link_.place(*ball, entry.second.shown, still, still));
  }
}

void Handles::offerThrows(bool paused)
{
  if (paused == static_cast<bool>(balls_topic_)) return;
  if (paused)
  {
    // A newcomer to a paused world is told the state at once, and again after each change.
    const boost::function<void(const BallStates::ConstPtr&)> keep = [this](const BallStates::ConstPtr& balls)
    { onBalls(*balls); };
    balls_topic_ = nh_.subscribe<BallStates>("balls", 1, keep);
    return;
  }
  balls_topic_.shutdown();
  balls_topic_ = ros::Subscriber();
  for (const auto& ball : paused_balls_)
  {
    server_.erase(throwName(ball.first));
    server_.erase(arrowName(ball.first));
  }
  paused_balls_.clear();
}

void Handles::onBalls(const BallStates& balls)
{
  std::set<std::uint32_t> present;
  for (std::size_t i = 0; i < std::min<std::size_t>(balls.balls.size(), kMostBalls); ++i)
  {
    const BallState& ball = balls.balls[i];
    present.insert(ball.id);
    const bool known = paused_balls_.count(ball.id) > 0;
    paused_balls_[ball.id] = ball;
    const Eigen::Vector3d p = fromMessage(ball.pose.position);
    const Eigen::Vector3d tip = p + kThrowTime * fromMessage(ball.twist.linear);
    server_.insert(arrow(arrowName(ball.id), p, tip));
    const std::string name = throwName(ball.id);
    if (!known)
      server_.insert(throwHandle(name, tip + kHome), [this](const Feedback::ConstPtr& f) { onFeedback(f); });
    else
      server_.setPose(name, toMessage(FramePose{tip + kHome, Eigen::Quaterniond::Identity()}));
  }
  for (auto ball = paused_balls_.begin(); ball != paused_balls_.end();)
  {
    if (present.count(ball->first) > 0)
    {
      ++ball;
      continue;
    }
    server_.erase(throwName(ball->first));
    server_.erase(arrowName(ball->first));
    ball = paused_balls_.erase(ball);
  }
}

// With the ball's state as it is now; the topic is listened to for as long as that takes.
void Handles::withBall(std::uint32_t id, BallJob job)
{
  const auto once = std::make_shared<ros::Subscriber>();
  const boost::function<void(const BallStates::ConstPtr&)> act = [=](const BallStates::ConstPtr& balls)
  {
    for (const BallState& ball : balls->balls)
    {
      if (ball.id == id && *once) job(ball);
    }
    once->shutdown();
    *once = ros::Subscriber();
  };
  *once = nh_.subscribe<BallStates>("balls", 1, act);
}

void Handles::onFeedback(const Feedback::ConstPtr& feedback)
{
  const std::string& name = feedback->marker_name;
  const FramePose pose = fromMessage(feedback->pose);
  if (name.compare(0, 6, "throw_") == 0)
  {
    if (feedback->event_type == Feedback::POSE_UPDATE) throwBall(*ballOfFrame("ball_" + name.substr(6)), pose);
  }
  else if (feedback->event_type == Feedback::MOUSE_DOWN)
  {
    const auto handle = handles_.find(name);
    if (handle != handles_.end()) handle->second.grasped = true;
  }
  else if (feedback->event_type == Feedback::POSE_UPDATE)
  {
    drag(name, pose);
  }
  else if (feedback->event_type == Feedback::MOUSE_UP)
  {
    release(name);
  }
}

void Handles::drag(const std::string& name, const FramePose& pose)
{
  const auto handle = handles_.find(name);
  if (handle == handles_.end()) return;
  handle->second.dragged = handle->second.grasped;  // a last pose may come after the release
  handle->second.shown = pose;
  const auto paddle = paddles_.find(name);
  const bool paused = link_.status() != nullptr && link_.status()->paused;
  if (paddle != paddles_.end() && !paused)
    paddle->second->pull(pose);
  else if (!ballOfFrame(name))
    warn(link_.place(name, pose));
}

void Handles::release(const std::string& name)
{
  const auto handle = handles_.find(name);
  if (handle == handles_.end()) return;
  handle->second.grasped = false;
  if (!handle->second.dragged) return;
  const Eigen::Vector3d still = Eigen::Vector3d::Zero();
  if (const auto ball = ballOfFrame(name)) warn(link_.place(*ball, handle->second.shown, still, still));
  handle->second.dragged = false;
}

void Handles::throwBall(std::uint32_t id, const FramePose& tip)
{
  const auto found = paused_balls_.find(id);
  if (found == paused_balls_.end()) return;
  const FramePose ball = fromMessage(found->second.pose);
  const Eigen::Vector3d way = tip.p - kHome - ball.p;
  const Eigen::Vector3d v = way.norm() < kStillWithin ? Eigen::Vector3d::Zero() : Eigen::Vector3d(way / kThrowTime);
  warn(link_.place(id, ball, v, fromMessage(found->second.twist.angular)));
}

void Handles::spinBall(const std::string& name, const Eigen::Vector3d& spin_along_flight)
{
  const std::optional<std::uint32_t> id = ballOfFrame(name);
  if (!id) return;
  withBall(*id,
           [=](const BallState& ball)
           {
             const Eigen::Vector3d v = fromMessage(ball.twist.linear);
             warn(link_.place(*id, fromMessage(ball.pose), v, flightAxes(v) * spin_along_flight));
           });
}

void Handles::warn(const std::string& refusal)
{
  if (!refusal.empty()) ROS_WARN_STREAM_THROTTLE(1.0, "handles: " << refusal);
}
}  // namespace ping_pong_sim
