#include "ball_throws.h"

#include <algorithm>
#include <set>

#include "handle_markers.h"
#include "refusal_log.h"

namespace ping_pong_sim
{
namespace
{
using Feedback = visualization_msgs::InteractiveMarkerFeedback;

constexpr double kThrowTime = 0.1;     ///< the bead is where the ball would be after so long [s]
constexpr double kBeadAbove = 0.08;    ///< above that, so that it can be grasped at rest [m]
constexpr double kStillWithin = 0.01;  ///< of the bead: what is less is no throw [m]

const Eigen::Vector3d kHome(0.0, 0.0, kBeadAbove);

std::string throwName(std::uint32_t id)
{
  return "throw_" + std::to_string(id);
}

std::string arrowName(std::uint32_t id)
{
  return "arrow_" + std::to_string(id);
}
}  // namespace

BallThrows::BallThrows(const ros::NodeHandle& nh, SimLink& link, interactive_markers::InteractiveMarkerServer& server)
    : nh_(nh), link_(link), server_(server)
{
}

void BallThrows::offer(bool paused)
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
  for (const auto& ball : balls_)
  {
    server_.erase(throwName(ball.first));
    server_.erase(arrowName(ball.first));
  }
  balls_.clear();
}

void BallThrows::onBalls(const BallStates& balls)
{
  std::set<std::uint32_t> present;
  for (std::size_t i = 0; i < std::min<std::size_t>(balls.balls.size(), kMostHandledBalls); ++i)
  {
    const BallState& ball = balls.balls[i];
    present.insert(ball.id);
    const bool known = balls_.count(ball.id) > 0;
    balls_[ball.id] = ball;
    const Eigen::Vector3d p = fromMessage(ball.pose.position);
    const Eigen::Vector3d tip = p + kThrowTime * fromMessage(ball.twist.linear);
    server_.insert(arrow(arrowName(ball.id), p, tip));
    const std::string name = throwName(ball.id);
    if (!known)
      server_.insert(throwHandle(name, tip + kHome),
                     [this, id = ball.id](const Feedback::ConstPtr& feedback)
                     {
                       if (feedback->event_type == Feedback::POSE_UPDATE) throwBall(id, fromMessage(feedback->pose).p);
                     });
    else
      server_.setPose(name, toMessage(FramePose{tip + kHome, Eigen::Quaterniond::Identity()}));
  }
  for (auto ball = balls_.begin(); ball != balls_.end();)
  {
    if (present.count(ball->first) > 0)
    {
      ++ball;
      continue;
    }
    server_.erase(throwName(ball->first));
    server_.erase(arrowName(ball->first));
    ball = balls_.erase(ball);
  }
}

void BallThrows::throwBall(std::uint32_t id, const Eigen::Vector3d& bead_W)
{
  const auto found = balls_.find(id);
  if (found == balls_.end()) return;
  const FramePose ball = fromMessage(found->second.pose);
  const Eigen::Vector3d way = bead_W - kHome - ball.p;
  const Eigen::Vector3d v = way.norm() < kStillWithin ? Eigen::Vector3d::Zero() : Eigen::Vector3d(way / kThrowTime);
  warn(link_.place(id, ball, v, fromMessage(found->second.twist.angular)));
}
}  // namespace ping_pong_sim
