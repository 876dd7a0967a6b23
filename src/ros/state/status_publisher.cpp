#include "status_publisher.h"

#include <algorithm>

#include "ping_pong_sim/state_hash.h"
#include "state_messages.h"

namespace ping_pong_sim
{
namespace
{
void fillNames(const Simulation& simulation, SimStatus& message)
{
  const ping_pong::World& world = simulation.world();
  message.paddles.clear();
  message.furniture.clear();
  message.props.clear();
  for (std::size_t i = 0; i < world.bodyCount(); ++i)
  {
    if (world.body(i).urdf_path.empty()) continue;  // the floor
    const bool is_paddle = world.body(i).kind == ping_pong::BodyKind::Kinematic;
    (is_paddle ? message.paddles : message.furniture).push_back(world.body(i).name);
  }
  for (const auto& prop : simulation.props())
  {
    if (isShown(world, prop.first)) message.props.push_back(prop.first);
  }
  message.ball_ids.resize(std::min(world.ballCount(), kNamedBalls));
  for (std::size_t i = 0; i < message.ball_ids.size(); ++i) message.ball_ids[i] = world.ballId(i);
}
}  // namespace

StatusPublisher::StatusPublisher(ros::NodeHandle& nh, const NodeParams& params, const Simulation& simulation,
                                 const Rejections& rejections, const StatePublisher& states, const bool& paused)
    : params_(params),
      simulation_(simulation),
      rejections_(rejections),
      states_(states),
      paused_(paused),
      publisher_(nh.advertise<SimStatus>("status", 10, true))
{
  diagnostics_.setHardwareID("none");
  diagnostics_.add("simulation", this, &StatusPublisher::diagnose);
}

void StatusPublisher::update(WallClock::time_point now)
{
  // The queue of refusals is filled by other threads; each shows within a tick.
  const bool refused = rejections_.count() != rejected_seen_;
  if (status_gate_.open(now) || refused) publish(now);
  // By wall time: the updater's own timer counts ROS time, which this node makes.
  if (diagnostics_gate_.open(now)) diagnostics_.force_update();
}

void StatusPublisher::publish(WallClock::time_point now)
{
  if (paused_)
    meter_.clear();
  else
    meter_.add(now, simulation_.elapsed(), simulation_.counters().contacts);
  fill();
  publisher_.publish(message_);
}

void StatusPublisher::fill()
{
  const ping_pong::World& world = simulation_.world();
  const ping_pong::Totals totals = world.totals();
  const Counters& counters = simulation_.counters();
  rejected_seen_ = rejections_.count();
  message_.header.stamp = simulation_.clock().now();
  message_.header.frame_id = "world";
  message_.scene = world.scene().name;
  message_.method = ping_pong::name(world.method());
  message_.paused = paused_;
  message_.time = world.time();
  message_.tick = simulation_.clock().tick();
  message_.real_time_factor_wanted = params_.real_time_factor;
  message_.real_time_factor = meter_.realTimeFactor();
  message_.balls = static_cast<std::uint32_t>(world.ballCount());
  message_.contacts = counters.contacts;
  message_.contacts_left_out = states_.contactsLeftOut();
  message_.contact_rate = meter_.contactRate();
  message_.kinetic_energy = totals.kinetic;
  message_.rotational_energy = totals.rotational;
  message_.potential_energy = totals.potential;
  message_.state_hash = ping_pong::stateHash(world);
  message_.squeezed = static_cast<std::uint32_t>(counters.last.squeezed);
  message_.blocked_paddles = static_cast<std::uint32_t>(counters.last.blocked_paddles);
  message_.rejected = rejected_seen_;
  message_.rejected_reason = rejections_.last();
  message_.step_warnings = counters.step_warnings;
  message_.step_warning = counters.step_warning;
  const Rally& rally = simulation_.rally();
  message_.has_contact = rally.lastContact().has_value();
  message_.last_contact = message_.has_contact ? toContact(simulation_, *rally.lastContact()) : Contact();
  message_.rally = rally.hits();
  message_.best_rally = rally.best();
  fillNames(simulation_, message_);
}

void StatusPublisher::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status)
{
  using diagnostic_msgs::DiagnosticStatus;
  const bool late = !paused_ && params_.real_time_factor > 0.0 && meter_.wall() > 0.5 &&
                    message_.real_time_factor < 0.95 * params_.real_time_factor;
  if (!simulation_.counters().last.ok())
    status.summary(DiagnosticStatus::WARN, message_.step_warning);
  else if (late)
    status.summary(DiagnosticStatus::WARN, "slower than the wanted real-time factor");
  else
    status.summary(DiagnosticStatus::OK, paused_ ? "paused" : "running");
  status.add("scene", message_.scene);
  status.add("method", message_.method);
  status.add("time [s]", message_.time);
  status.add("real-time factor", message_.real_time_factor);
  status.add("balls", message_.balls);
  status.add("contacts per second", message_.contact_rate);
  status.add("refused commands and calls", message_.rejected);
  status.add("step warnings", message_.step_warnings);
}
}  // namespace ping_pong_sim
