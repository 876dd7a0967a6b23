#include "handles.h"

#include <algorithm>
#include <set>

#include "handle_markers.h"
#include "refusal_log.h"

namespace ping_pong_sim
{
namespace
{
constexpr char kTopic[] = "handles";
constexpr double kBallRadius = 0.020;  ///< of the shell's inside [m]

bool moved(const FramePose& a, const FramePose& b)
{
  return (a.p - b.p).norm() > 1e-3 || a.q.angularDistance(b.q) > 5e-3;
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
  for (std::size_t i = 0; i < std::min<std::size_t>(status.ball_ids.size(), kMostHandledBalls); ++i)
  {
    names.insert("ball_" + std::to_string(status.ball_ids[i]));
  }
  return names;
}
}  // namespace

Handles::Handles(const std::string& simulator, std::shared_ptr<tf2_ros::Buffer> frames)
    : link_(nh_, simulator, std::move(frames)), server_(kTopic), menus_(nh_, link_), throws_(nh_, link_, server_)
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
}

void Handles::update()
{
  const SimStatus* status = link_.status();
  if (status == nullptr || listeners_.getNumSubscribers() == 0) return;
  const bool paused = status->paused;
  sync(*status);
  holdDraggedBalls();  // may find out that there is no simulator
  showWhereThingsAre();
  throws_.offer(paused);
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
  menus_.apply(server_, name);
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

void Handles::onFeedback(const Feedback::ConstPtr& feedback)
{
  const std::string& name = feedback->marker_name;
  const FramePose pose = fromMessage(feedback->pose);
  if (feedback->event_type == Feedback::MOUSE_DOWN)
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
}  // namespace ping_pong_sim
