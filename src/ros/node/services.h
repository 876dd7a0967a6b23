// The private services: from request to an action in the simulation loop, and every refusal told, counted and warned
// about.
#pragma once

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <functional>
#include <string>
#include <vector>

#include "ping_pong_sim/DeleteBall.h"
#include "ping_pong_sim/Launch.h"
#include "ping_pong_sim/LoadScene.h"
#include "ping_pong_sim/SetBallState.h"
#include "ping_pong_sim/SetBodyPose.h"
#include "ping_pong_sim/SpawnBall.h"
#include "ping_pong_sim/Step.h"
#include "sim_node.h"

namespace ping_pong_sim
{
class Services
{
public:
  Services(ros::NodeHandle& private_nh, SimNode& node);

private:
  /// @param action  runs in the simulation loop; what it throws is the reason of a refusal
  template <class Service>
  void offer(ros::NodeHandle& nh, const std::string& name,
             std::function<void(typename Service::Request&, typename Service::Response&)> action);

  void spawnBall(const SpawnBall::Request& request, SpawnBall::Response& response);
  void launch(const Launch::Request& request, Launch::Response& response);
  void deleteBall(const DeleteBall::Request& request);
  void setBallState(const SetBallState::Request& request);
  void setBodyPose(const SetBodyPose::Request& request);
  void offerLoadScene(ros::NodeHandle& nh);

  SimNode& node_;
  std::vector<ros::ServiceServer> servers_;
};
}  // namespace ping_pong_sim
