#include "state_publisher.h"

namespace ping_pong_sim
{
StatePublisher::StatePublisher(ros::NodeHandle& nh, const Simulation& simulation, const bool& paused, JobQueue& jobs)
    : simulation_(simulation),
      static_frames_(nh.advertise<tf2_msgs::TFMessage>("/tf_static", 10, true)),
      contacts_(nh.advertise<Contact>("contacts", 10000)),
      // A newcomer to a running simulation waits for the next tick: the same stamp twice makes tf2 complain.
      frames_(nh, "/tf", 100, jobs,
              [this, &paused](tf2_msgs::TFMessage& message, bool newcomer)
              {
                fillMovingFrames(simulation_, message);
                return !message.transforms.empty() && (!newcomer || paused);
              }),
      balls_(nh, "balls", 100, jobs,
             [this](BallStates& message, bool)
             {
               fillBalls(simulation_, message);
               return true;
             }),
      paddles_(nh, "paddles", 100, jobs,
               [this](PaddleStates& message, bool)
               {
                 fillPaddles(simulation_, message);
                 return true;
               })
{
  publishStaticFrames();
}

void StatePublisher::publish()
{
  const ros::Time stamp = simulation_.clock().now();
  if (stamp == last_stamp_) return;
  last_stamp_ = stamp;
  frames_.publish();
  balls_.publish();
  paddles_.publish();
}

void StatePublisher::publishContacts()
{
  if (contacts_.getNumSubscribers() == 0) return;
  for (const ping_pong::Contact& contact : simulation_.world().contacts())
  {
    contacts_.publish(toContact(simulation_, contact));
  }
}

void StatePublisher::publishStaticFrames()
{
  tf2_msgs::TFMessage message;
  fillStaticFrames(simulation_, message);
  static_frames_.publish(message);
}
}  // namespace ping_pong_sim
