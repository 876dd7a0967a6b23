#include "sim_link.h"

#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <chrono>

#include "ping_pong_sim/DeleteBall.h"
#include "ping_pong_sim/Launch.h"
#include "ping_pong_sim/NewMatch.h"
#include "ping_pong_sim/SetBallState.h"
#include "ping_pong_sim/SetBodyPose.h"
#include "ping_pong_sim/Step.h"
#include "ping_pong_sim/Toss.h"

namespace ping_pong_sim
{
namespace
{
constexpr double kSilence = 2.0;   ///< without status the simulator counts as gone [s]; it sends ten a second
constexpr double kPatience = 1.0;  ///< for the answer of a simulator that speaks [s]
}  // namespace

double wallSeconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::optional<std::uint32_t> ballOfFrame(const std::string& frame)
{
  const std::string prefix = "ball_";
  if (frame.compare(0, prefix.size(), prefix) != 0) return std::nullopt;
  const std::string digits = frame.substr(prefix.size());
  if (digits.empty() || digits.size() > 9 || digits.find_first_not_of("0123456789") != std::string::npos) return {};
  return static_cast<std::uint32_t>(std::stoul(digits));
}

SimLink::SimLink(const ros::NodeHandle& nh, const std::string& simulator, std::shared_ptr<tf2_ros::Buffer> frames)
    : nh_(nh), simulator_(simulator), frames_(std::move(frames))
{
  const boost::function<void(const SimStatus::ConstPtr&)> keep = [this](const SimStatus::ConstPtr& message)
  {
    status_ = *message;
    status_at_ = wallSeconds();
    answers_ = true;
  };
  status_topic_ = nh_.subscribe<SimStatus>("status", 1, keep);
}

const SimStatus* SimLink::status() const
{
  return status_ && wallSeconds() - status_at_ < kSilence ? &*status_ : nullptr;
}

std::string SimLink::trouble() const
{
  if (status() != nullptr) return "";
  return answers_ ? "no simulator" : "the simulator does not answer";
}

template <class Service>
std::string SimLink::call(const std::string& name, Service& exchange)
{
  return callAt(simulator_ + "/" + name, exchange);
}

template <class Service>
std::string SimLink::callAt(const std::string& name, Service& exchange)
{
  if (status() == nullptr) return trouble();
  ros::ServiceClient& client = clients_[name];
  if (!client.isValid()) client = nh_.serviceClient<Service>(name, true);
  bool late = false;
  const auto abort = [&late, client]() mutable
  {
    late = true;
    client.shutdown();
  };
  if (!deadline_.run(
          kPatience, [&] { return client.call(exchange); }, abort))
  {
    clients_.erase(name);
    const bool by_simulator = name.compare(0, simulator_.size() + 1, simulator_ + "/") == 0;
    if (!late || !by_simulator) return "no answer from " + name;
    // Until it speaks again nobody waits for it.
    answers_ = false;
    status_.reset();
    return trouble();
  }
  return exchange.response.success ? "" : exchange.response.message;
}

template std::string SimLink::callAt(const std::string& name, Toss& exchange);
template std::string SimLink::callAt(const std::string& name, NewMatch& exchange);

std::string SimLink::setPaused(bool paused)
{
  std_srvs::SetBool exchange;
  exchange.request.data = paused;
  return call("pause", exchange);
}

std::string SimLink::step(double duration)
{
  Step exchange;
  exchange.request.duration = duration;
  return call("step", exchange);
}

std::string SimLink::reset()
{
  std_srvs::Trigger exchange;
  return call("reset", exchange);
}

std::string SimLink::launch(const std::string& shot)
{
  Launch exchange;
  exchange.request.shot = shot;
  return call("launch", exchange);
}

std::string SimLink::spawn(SpawnBall& exchange)
{
  return call("spawn_ball", exchange);
}

std::string SimLink::deleteBall(std::uint32_t id)
{
  DeleteBall exchange;
  exchange.request.id = id;
  return call("delete_ball", exchange);
}

std::string SimLink::place(const std::string& body, const FramePose& pose)
{
  SetBodyPose exchange;
  exchange.request.body = body;
  exchange.request.pose = toMessage(pose);
  return call("set_body_pose", exchange);
}

std::string SimLink::place(std::uint32_t ball, const FramePose& pose, const Eigen::Vector3d& velocity,
                           const Eigen::Vector3d& spin)
{
  SetBallState exchange;
  exchange.request.id = ball;
  exchange.request.pose = toMessage(pose);
  exchange.request.twist.linear = toVectorMessage(velocity);
  exchange.request.twist.angular = toVectorMessage(spin);
  return call("set_ball_state", exchange);
}

std::optional<FramePose> SimLink::pose(const std::string& frame) const
{
  try
  {
    const geometry_msgs::Transform t = frames_->lookupTransform("world", frame, ros::Time(0)).transform;
    return FramePose{{t.translation.x, t.translation.y, t.translation.z},
                     {t.rotation.w, t.rotation.x, t.rotation.y, t.rotation.z}};
  }
  catch (const tf2::TransformException&)
  {
    return std::nullopt;
  }
}
}  // namespace ping_pong_sim
