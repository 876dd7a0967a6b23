// Parameters of the node. Physics belongs to the scene file; config/node.yaml documents what is left.
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "ping_pong_sim/scene_loader.h"
#include "props.h"
#include "ros/commands/ball_feed.h"

namespace ping_pong_sim
{
constexpr char kMethodOfScene[] = "scene";  ///< value of ~method that leaves the choice to the scene

struct NodeParams
{
  std::string scene;              ///< path, or name in scene_directory
  std::string scene_directory;    ///< where scenes are looked up by name
  double real_time_factor = 1.0;  ///< simulated per wall second, >= 0; 0: as fast as possible
  double publish_rate = 100.0;    ///< ticks per simulated second [1/s]
  double clock_rate = 100.0;      ///< of /clock, per wall second, at most [1/s]
  double marker_rate = 30.0;      ///< of `markers`, per wall second, at most [1/s]
  double command_timeout = 0.5;   ///< in simulated time [s]
  bool paused = false;            ///< at the start
  double wait_for_view =
      0.0;              ///< before the first tick, for somebody who looks at `markers`, at most [s]; 0: not at all
  double repeat = 0.0;  ///< a scene that has ended begins again after this simulated time [s]; 0: never
  bool rewind_clock = false;        ///< ~reset also sets the clock back
  std::size_t compact_above = 200;  ///< more balls than this are a crowd
  double contact_rate = 10000.0;    ///< of `contacts`, per wall second, at most [1/s]
  ping_pong::LoadOptions load;      ///< of the scene that the node starts with: number and seed of balls
  std::string method = kMethodOfScene;
  double dt = 0.0;          ///< [s]; 0: the scene's
  double tolerance = 0.0;   ///< [m]; 0: the scene's
  std::size_t threads = 0;  ///< 0: the scene's
  FeedParams feed;
  Props props = defaultProps();  ///< at the start
  std::string blob_shadows;      ///< name of the light that throws them; empty: none

  double tick() const { return 1.0 / publish_rate; }  ///< [s]
};

/// Throws ParamError; warns about private parameters that nobody reads.
NodeParams readParams(const ros::NodeHandle& private_nh);

/// Loads a scene with a number and a seed of balls, applies ~method, ~dt, ~tolerance and ~threads, and checks that its names can be ROS names. Throws
/// std::runtime_error.
ping_pong::Scene loadSceneFor(const NodeParams& params, const std::string& scene,
                              const ping_pong::LoadOptions& options = {});
}  // namespace ping_pong_sim
