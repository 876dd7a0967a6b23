// TF, balls, paddles and contacts.
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "ping_pong_sim/Crowd.h"
#include "ros/base/job_queue.h"
#include "ros/base/pacer.h"
#include "ros/base/state_topic.h"
#include "ros/base/token_bucket.h"
#include "ros/simulation/node_params.h"
#include "ros/simulation/simulation.h"
#include "state_messages.h"

namespace ping_pong_sim
{
class StatePublisher
{
public:
  /// @param paused  read in the simulation loop
  StatePublisher(ros::NodeHandle& nh, const NodeParams& params, const Simulation& simulation, const bool& paused,
                 JobQueue& jobs);

  /// Where everything is. Does nothing if that was said for this stamp already. Of a crowd some messages are due now and
  /// then only, by wall time.
  void publish(WallClock::time_point now);
  /// The same, and what was not due: nothing more comes for now.
  void publishAll();
  /// The impacts of the last tick, as many as `~contact_rate` allows. After every tick, so that none is lost.
  void publishContacts(WallClock::time_point now);
  /// Impacts that were not told though somebody listened, since start or last reset.
  std::uint64_t contactsLeftOut() const { return contacts_left_out_; }
  /// The world began anew.
  void forgetPast() { contacts_left_out_ = 0; }
  /// After a static body was moved or the scene changed.
  void publishStaticFrames();

private:
  void publishFrames();
  void publishBalls();
  void publishCrowd();

  const Simulation& simulation_;
  ros::Time last_stamp_, balls_stamp_, crowd_stamp_;  ///< of what was told last
  RateGate balls_gate_;
  RateGate crowd_gate_;
  TokenBucket contact_tokens_;
  std::uint64_t contacts_left_out_ = 0;
  ros::Publisher static_frames_;
  ros::Publisher contacts_;
  StateTopic<tf2_msgs::TFMessage> frames_;
  StateTopic<BallStates> balls_;
  StateTopic<Crowd> crowd_;
  StateTopic<PaddleStates> paddles_;
};
}  // namespace ping_pong_sim
