// The node: the loop that owns the world, and what can be done to it between ticks.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <memory>
#include <string>
#include <vector>

#include "ping_pong_sim/Step.h"
#include "ros/base/job_queue.h"
#include "ros/base/pacer.h"
#include "ros/base/rejections.h"
#include "ros/markers/marker_publisher.h"
#include "ros/simulation/node_params.h"
#include "ros/simulation/simulation.h"
#include "ros/state/state_publisher.h"
#include "ros/state/status_publisher.h"

namespace ping_pong_sim
{
class Services;

class SimNode
{
public:
  /// Throws std::runtime_error on bad parameters or a bad scene.
  SimNode();
  ~SimNode();

  /// Until ROS shuts down.
  void run();

  // --- Any thread ---
  JobQueue& jobs() { return jobs_; }
  Rejections& rejections() { return rejections_; }
  const NodeParams& params() const { return params_; }

  // --- Only in the simulation loop, so from other threads through jobs(). They throw InputError for a reason to refuse
  // ---
  Simulation& simulation() { return simulation_; }
  void setPaused(bool paused);
  void reset();
  void step(const Step::Request& request, Step::Response& response);
  void load(ping_pong::Scene scene);
  /// The trail of a ball that was put elsewhere.
  void forgetTrail(ping_pong::BallId ball) { markers_.forgetPast(ball); }
  /// To be called after any change from outside: shows it, also while paused.
  /// @param bodies_too  static bodies may have moved
  void showJump(bool bodies_too = false);

private:
  void waitForView();
  void waitForCommands(const Step::Request& request, Step::Response& response);
  void runPaused();
  void runTick();
  void waitUntil(WallClock::time_point deadline);
  void afterTick(bool publish_state);
  void publishClock();

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_{"~"};
  ros::NodeHandle command_nh_;
  ros::CallbackQueue command_queue_;

  NodeParams params_;
  bool use_sim_time_;
  bool paused_;
  JobQueue jobs_;
  Rejections rejections_;
  Simulation simulation_;
  StatePublisher states_;
  MarkerPublisher markers_;
  StatusPublisher status_;
  ros::Publisher clock_;
  Pacer pacer_;
  RateGate state_gate_;
  RateGate clock_gate_;
  std::unique_ptr<Services> services_;
  ros::AsyncSpinner service_spinner_{2};
  ros::AsyncSpinner command_spinner_{1, &command_queue_};
};
}  // namespace ping_pong_sim
