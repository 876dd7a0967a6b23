// `status` and /diagnostics.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "ping_pong_sim/SimStatus.h"
#include "ros/base/pacer.h"
#include "ros/base/rate_meter.h"
#include "ros/base/rejections.h"
#include "ros/simulation/node_params.h"
#include "ros/simulation/simulation.h"
#include "state_publisher.h"

namespace ping_pong_sim
{
class StatusPublisher
{
public:
  /// @param paused  read in the simulation loop
  StatusPublisher(ros::NodeHandle& nh, const NodeParams& params, const Simulation& simulation,
                  const Rejections& rejections, const StatePublisher& states, const bool& paused);

  /// After every tick, and while paused now and then: publishes what is due by wall time.
  void update(WallClock::time_point now);
  /// At once, because something changed.
  void publish(WallClock::time_point now);

private:
  void fill();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  const NodeParams& params_;
  const Simulation& simulation_;
  const Rejections& rejections_;
  const StatePublisher& states_;
  const bool& paused_;
  std::uint64_t rejected_seen_ = 0;
  RateMeter meter_;
  RateGate status_gate_{10.0};
  RateGate diagnostics_gate_{1.0};
  SimStatus message_;
  ros::Publisher publisher_;
  diagnostic_updater::Updater diagnostics_;
};
}  // namespace ping_pong_sim
