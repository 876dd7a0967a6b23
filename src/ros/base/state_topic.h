// A topic that says how things are now, also to those who come while nothing happens.
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/single_subscriber_publisher.h>

#include <functional>
#include <string>

#include "job_queue.h"

namespace ping_pong_sim
{
/// Messages are made only while somebody listens. A new subscriber gets the present state at once, and alone: while the
/// simulation is paused, an RViz that is started later still sees everything. (A latched topic would cost as much
/// with nobody listening.)
template <class Message>
class StateTopic
{
public:
  /// Fills the message in the simulation loop; false: nothing to send.
  using Fill = std::function<bool(Message& message, bool newcomer)>;

  StateTopic(ros::NodeHandle& nh, const std::string& topic, std::uint32_t queue, JobQueue& jobs, Fill fill)
      : jobs_(jobs), fill_(std::move(fill))
  {
    publisher_ = nh.advertise<Message>(topic, queue,
                                       [this](const ros::SingleSubscriberPublisher& newcomer) { welcome(newcomer); });
  }

  void publish()
  {
    if (publisher_.getNumSubscribers() > 0 && fill_(message_, false)) publisher_.publish(message_);
  }

  bool watched() const { return publisher_.getNumSubscribers() > 0; }

private:
  void welcome(const ros::SingleSubscriberPublisher& newcomer)
  {
    jobs_.run(
        [&]
        {
          Message message;
          if (fill_(message, true)) newcomer.publish(message);
        });
  }

  JobQueue& jobs_;
  Fill fill_;
  Message message_;  ///< kept, so that its memory is
  ros::Publisher publisher_;
};
}  // namespace ping_pong_sim
