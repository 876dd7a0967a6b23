#include "simulation.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ping_pong_sim
{
namespace
{
std::string warningOf(const ping_pong::StepStatus& status)
{
  if (status.not_finite) return "a ball's motion became infinite; it keeps its last finite state";
  if (status.event_limit) return "too many events in one tick; the rest of it was flown without contacts";
  if (status.squeezed > 0) return std::to_string(status.squeezed) + " ball(s) squeezed with no room left";
  return "";
}
}  // namespace

Simulation::Simulation(const NodeParams& params, ping_pong::Scene scene, ros::NodeHandle& command_nh,
                       Rejections& rejections, const ros::Time& start)
    : params_(params),
      command_nh_(command_nh),
      rejections_(rejections),
      clock_(start, params.tick()),
      feed_(params.feed),
      repeat_(params.repeat),
      props_(params.props)
{
  load(std::move(scene));
}

void Simulation::reset()
{
  world_->reset();
  feed_.restart();
  counters_ = {};
  rally_.restart();
  for (const auto& paddle : paddles_) paddle->forget();
  if (params_.rewind_clock) clock_.rewind();
}

void Simulation::tick()
{
  advance(params_.tick());
  clock_.addTick();
}

void Simulation::partialTick(double duration)
{
  advance(duration);
  clock_.add(duration);
}

void Simulation::releasePaddle(std::size_t body)
{
  for (const auto& paddle : paddles_)
  {
    if (paddle->body() == body) paddle->forget();
  }
}

ros::Time Simulation::stampOf(const ping_pong::Contact& contact) const
{
  const double before_now = std::max(world_->time() - contact.time, 0.0);
  return clock_.now() - ros::Duration(before_now);
}

void Simulation::load(ping_pong::Scene scene)
{
  world_ = std::make_unique<ping_pong::World>(std::move(scene));  // throws before anything else is changed
  counters_ = {};
  rally_.restart();
  feed_.restart();
  paddles_.clear();
  const auto frames = std::make_shared<std::set<std::string>>();
  for (std::size_t i = 0; i < world_->bodyCount(); ++i) frames->insert(world_->body(i).name);
  for (std::size_t i = 0; i < world_->bodyCount(); ++i)
  {
    if (world_->body(i).kind != ping_pong::BodyKind::Kinematic) continue;
    paddles_.push_back(
        std::make_unique<PaddleControl>(command_nh_, *world_, i, frames, params_.command_timeout, rejections_));
  }
}

bool Simulation::isPlayed(std::size_t body) const
{
  const auto commanded = [&](const auto& paddle)
  { return paddle->body() == body && paddle->commandAge(elapsed_) >= 0.0; };
  return std::any_of(paddles_.begin(), paddles_.end(), commanded);
}

void Simulation::advance(double duration)
{
  for (const auto& paddle : paddles_) paddle->update(*world_, elapsed_);
  counters_.last = world_->advance(duration);
  elapsed_ += duration;
  feed_.update(*world_, rejections_);
  counters_.contacts += world_->contacts().size();
  rally_.observe(*world_, [this](std::size_t body) { return isPlayed(body); });
  if (counters_.last.ok()) return;
  ++counters_.step_warnings;
  counters_.step_warning = warningOf(counters_.last);
}
}  // namespace ping_pong_sim
