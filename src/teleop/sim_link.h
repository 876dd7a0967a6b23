// A client of the simulator that outlives it: its last status, its services, and where things are.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "call_deadline.h"
#include "messages.h"
#include "ping_pong_sim/SimStatus.h"
#include "ping_pong_sim/SpawnBall.h"

namespace ping_pong_sim
{
/// Monotonic wall time [s].
double wallSeconds();

/// Belongs to one thread, which serves the queue of its node handle.
class SimLink
{
public:
  /// @param simulator  name of the node, for its private services
  SimLink(const ros::NodeHandle& nh, const std::string& simulator, std::shared_ptr<tf2_ros::Buffer> frames);

  ros::NodeHandle& nh() { return nh_; }
  /// The last status; nothing before the first one, and once it has been silent for two seconds.
  const SimStatus* status() const;
  /// Why there is no status, for people; empty: there is one.
  std::string trouble() const;

  /// What went wrong, for people; empty: done. Never waits for a simulator that is not there, and a second at most for
  /// one that does not answer.
  /// @param name  of the simulator's own service
  template <class Service>
  std::string call(const std::string& name, Service& exchange);
  /// Of another node, by its whole name: Toss and NewMatch.
  template <class Service>
  std::string callAt(const std::string& name, Service& exchange);

  std::string setPaused(bool paused);
  std::string step(double duration);
  std::string reset();
  std::string launch(const std::string& shot);
  std::string spawn(SpawnBall& exchange);  ///< the answer has its id
  std::string deleteBall(std::uint32_t id);
  std::string place(const std::string& body, const FramePose& pose);
  std::string place(std::uint32_t ball, const FramePose& pose, const Eigen::Vector3d& velocity,
                    const Eigen::Vector3d& spin);

  /// Newest pose in the world.
  std::optional<FramePose> pose(const std::string& frame) const;

private:
  ros::NodeHandle nh_;
  std::string simulator_;
  std::shared_ptr<tf2_ros::Buffer> frames_;
  std::map<std::string, ros::ServiceClient> clients_;
  CallDeadline deadline_;
  std::optional<SimStatus> status_;
  double status_at_ = 0.0;  ///< wallSeconds()
  bool answers_ = true;     ///< false: the last call was in vain, and no status came since
  ros::Subscriber status_topic_;
};

/// The id of a ball's frame; nothing for other names.
std::optional<std::uint32_t> ballOfFrame(const std::string& frame);
}  // namespace ping_pong_sim
