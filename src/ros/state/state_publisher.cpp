#include "state_publisher.h"

#include "crowd_message.h"

namespace ping_pong_sim
{
namespace
{
constexpr double kBallsRate = 10.0;           // of `balls` in a crowd, per wall second [1/s]
constexpr double kBallsPerSecond = 300000.0;  // on `crowd`, per wall second
}  // namespace

StatePublisher::StatePublisher(ros::NodeHandle& nh, const NodeParams& params, const Simulation& simulation,
                               const bool& paused, JobQueue& jobs)
    : simulation_(simulation),
      balls_gate_(kBallsRate),
      crowd_gate_(params.marker_rate),
      contact_tokens_(params.contact_rate),
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
      crowd_(nh, "crowd", 10, jobs,
             [this](Crowd& message, bool)
             {
               fillCrowd(simulation_, message);
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

void StatePublisher::publish(WallClock::time_point now)
{
  publishFrames();
  if (!simulation_.isCrowd() || balls_gate_.open(now)) publishBalls();
  if (crowd_gate_.open(now, static_cast<double>(simulation_.world().ballCount()) / kBallsPerSecond)) publishCrowd();
}

void StatePublisher::publishAll()
{
  publishFrames();
  publishBalls();
  publishCrowd();
}

void StatePublisher::publishFrames()
{
  const ros::Time stamp = simulation_.clock().now();
  if (stamp == last_stamp_) return;
  last_stamp_ = stamp;
  frames_.publish();
  paddles_.publish();
}

void StatePublisher::publishBalls()
{
  const ros::Time stamp = simulation_.clock().now();
  if (stamp == balls_stamp_) return;
  balls_stamp_ = stamp;
  balls_.publish();
}

void StatePublisher::publishCrowd()
{
  const ros::Time stamp = simulation_.clock().now();
  if (stamp == crowd_stamp_) return;
  crowd_stamp_ = stamp;
  crowd_.publish();
}

void StatePublisher::publishContacts(WallClock::time_point now)
{
  if (contacts_.getNumSubscribers() == 0) return;
  const std::vector<ping_pong::Contact>& contacts = simulation_.world().contacts();
  const std::size_t told = contact_tokens_.take(contacts.size(), now);
  for (std::size_t i = 0; i < told; ++i) contacts_.publish(toContact(simulation_, contacts[i]));
  contacts_left_out_ += contacts.size() - told;
}

void StatePublisher::publishStaticFrames()
{
  tf2_msgs::TFMessage message;
  fillStaticFrames(simulation_, message);
  static_frames_.publish(message);
}
}  // namespace ping_pong_sim
