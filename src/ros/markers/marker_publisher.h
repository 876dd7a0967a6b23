// `markers` (balls, stripes, trails, contacts) and `body_markers` (the furniture and the paddles).
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "contact_flashes.h"
#include "ros/base/job_queue.h"
#include "ros/base/pacer.h"
#include "ros/base/state_topic.h"
#include "ros/simulation/simulation.h"
#include "trails.h"

namespace ping_pong_sim
{
class MarkerPublisher
{
public:
  /// @param rate  of `markers`, per wall second, at most [1/s]
  /// @param blobs  light that throws a dark disc under every ball; empty: no discs
  MarkerPublisher(ros::NodeHandle& nh, double rate, const std::string& blobs, const Simulation& simulation,
                  JobQueue& jobs);

  /// After every tick: what trails and contacts must not miss.
  void observeTick();
  /// Publishes `markers` if it is due.
  void update(WallClock::time_point now);
  /// At once; does nothing if this stamp was shown already.
  void publish();
  /// After the scene changed: `body_markers`, and the URDF texts as parameters NAME_description.
  void publishBodies();
  /// Says `body_markers` again now and then: RViz forgets them when time jumps back, as after a restart of this node.
  void repeatBodies(WallClock::time_point now);
  /// Somebody looks at `markers`.
  bool watched() const { return markers_.watched(); }
  /// After a jump of everything.
  void forgetPast();
  /// After a jump of one ball.
  void forgetPast(ping_pong::BallId ball) { trails_.clear(ball); }

private:
  void fill(visualization_msgs::MarkerArray& message, bool newcomer);
  void setDescriptions();

  ros::NodeHandle nh_;
  const Simulation& simulation_;
  RateGate gate_;
  RateGate bodies_gate_;
  std::string blobs_;
  Trails trails_;
  ContactFlashes flashes_;
  std::vector<ping_pong::BallId> shown_;  ///< balls that subscribers know; another set makes them begin anew
  ros::Time last_stamp_;
  std::vector<std::string> descriptions_;
  visualization_msgs::MarkerArray body_pictures_;
  ros::Publisher bodies_;
  StateTopic<visualization_msgs::MarkerArray> markers_;
};
}  // namespace ping_pong_sim
