#include "handle_menus.h"

#include <cmath>
#include <memory>
#include <utility>

#include "ping_pong_sim/shots.h"
#include "refusal_log.h"

namespace ping_pong_sim
{
namespace
{
using Feedback = visualization_msgs::InteractiveMarkerFeedback;

constexpr double kSpin = 2.0 * M_PI * 50;  ///< [rad/s]

// x along the flight, z up; on a ball at rest as if it came from the launcher.
Eigen::Matrix3d flightAxes(const Eigen::Vector3d& v)
{
  Eigen::Vector3d x(v.x(), v.y(), 0.0);
  x = x.norm() > 0.1 ? Eigen::Vector3d(x.normalized()) : Eigen::Vector3d(-1.0, 0.0, 0.0);
  Eigen::Matrix3d axes;
  axes << x, Eigen::Vector3d::UnitZ().cross(x), Eigen::Vector3d::UnitZ();
  return axes;
}
}  // namespace

HandleMenus::HandleMenus(const ros::NodeHandle& nh, SimLink& link) : nh_(nh), link_(link)
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
  fillBallMenu();
}

void HandleMenus::fillBallMenu()
{
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

void HandleMenus::apply(interactive_markers::InteractiveMarkerServer& server, const std::string& name)
{
  (ballOfFrame(name) ? ball_menu_ : body_menu_).apply(server, name);
}

// With the ball's state as it is now; the topic is listened to for as long as that takes.
void HandleMenus::withBall(std::uint32_t id, std::function<void(const BallState&)> job)
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

void HandleMenus::spinBall(const std::string& name, const Eigen::Vector3d& spin_along_flight)
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
}  // namespace ping_pong_sim
