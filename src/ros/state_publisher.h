// TF, balls, paddles and contacts.
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "job_queue.h"
#include "simulation.h"
#include "state_messages.h"
#include "state_topic.h"

namespace ping_pong_sim
{
class StatePublisher
{
public:
  /// @param paused  read in the simulation loop
  StatePublisher(ros::NodeHandle& nh, const Simulation& simulation, const bool& paused, JobQueue& jobs);

  /// Where everything is. Does nothing if that was said for this stamp already.
  void publish();
  /// The impacts of the last tick. After every tick, so that none is lost.
  void publishContacts();
  /// After a static body was moved or the scene changed.
  void publishStaticFrames();

private:
  const Simulation& simulation_;
  ros::Time last_stamp_;
  ros::Publisher static_frames_;
  ros::Publisher contacts_;
  StateTopic<tf2_msgs::TFMessage> frames_;
  StateTopic<BallStates> balls_;
  StateTopic<PaddleStates> paddles_;
};
}  // namespace ping_pong_sim
