// The world with what belongs to running it under ROS: clock, paddle commands, counters. Owned by the simulation loop.
#pragma once

#include <ros/node_handle.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "node_params.h"
#include "ping_pong_sim/world.h"
#include "props.h"
#include "rally.h"
#include "repeat.h"
#include "ros/base/rejections.h"
#include "ros/base/sim_clock.h"
#include "ros/commands/ball_feed.h"
#include "ros/commands/paddle_control.h"

namespace ping_pong_sim
{
/// Since start or last reset, if not said otherwise.
struct Counters
{
  std::uint64_t contacts = 0;
  std::uint64_t step_warnings = 0;  ///< ticks that did not go well
  std::string step_warning;         ///< the last of them
  ping_pong::StepStatus last;       ///< of the last tick
};

constexpr std::size_t kNamedBalls =
    50;  ///< of a crowd: those that have a frame. More balls than this are drawn as a list

class Simulation
{
public:
  /// @param command_nh  its callback queue is served by the thread of commands
  Simulation(const NodeParams& params, ping_pong::Scene scene, ros::NodeHandle& command_nh, Rejections& rejections,
             const ros::Time& start);

  /// Replaces the world; if that throws, nothing was changed.
  void load(ping_pong::Scene scene);
  /// After a tick: the scene has ended, and is to begin again (~repeat).
  bool isOver() { return repeat_.due(*world_); }
  /// Back to the start of the scene. Commands are forgotten.
  void reset();
  /// One full tick.
  void tick();
  /// A shorter one [s].
  void partialTick(double duration);

  ping_pong::World& world() { return *world_; }
  const ping_pong::World& world() const { return *world_; }
  SimClock& clock() { return clock_; }
  const SimClock& clock() const { return clock_; }
  const std::vector<std::unique_ptr<PaddleControl>>& paddles() const { return paddles_; }
  const Counters& counters() const { return counters_; }
  const Rally& rally() const { return rally_; }
  /// More balls than are told one by one.
  bool isCrowd() const { return world_->ballCount() > params_.compact_above; }
  /// More balls than are drawn one by one: RViz draws ten thousand spheres of a list, but hardly a thousand single ones.
  bool isDrawnAsList() const { return world_->ballCount() > std::min(params_.compact_above, kNamedBalls); }
  /// Balls that have a frame and can be selected: all, or the first few of a crowd.
  std::size_t ballsByName() const
  {
    return isCrowd() ? std::min(world_->ballCount(), kNamedBalls) : world_->ballCount();
  }
  Props& props() { return props_; }
  const Props& props() const { return props_; }
  /// Simulated time since the node started; never goes back [s].
  double elapsed() const { return elapsed_; }
  /// The paddle's command is forgotten, if the body is a paddle.
  void releasePaddle(std::size_t body);
  /// The instant of a contact since start or last reset.
  ros::Time stampOf(const ping_pong::Contact& contact) const;

private:
  void advance(double duration);
  bool isPlayed(std::size_t body) const;

  NodeParams params_;
  ros::NodeHandle& command_nh_;
  Rejections& rejections_;
  SimClock clock_;
  std::unique_ptr<ping_pong::World> world_;
  std::vector<std::unique_ptr<PaddleControl>> paddles_;
  BallFeed feed_;
  Counters counters_;
  Rally rally_;
  Repeat repeat_;
  Props props_;
  double elapsed_ = 0.0;
};
}  // namespace ping_pong_sim
