// Crowds that grow: the same scene with any number of balls, and what must hold in it.
#pragma once

#include <string>
#include <vector>

#include "ping_pong_sim/scene.h"

namespace ping_pong::bench
{
struct CrowdScene
{
  std::string name;      ///< of a file in config/scenes with a room; or `tray`, see tray_scene.h
  double warm_up = 0.0;  ///< simulated before anything is timed [s]
  double longest = 0.0;  ///< simulated time to measure, less if that takes too long [s]
  bool steady = false;   ///< any part of it is like any other: a shorter run will do
  double enough = 0.0;   ///< a run of this length counts, too, if there is no time for more; 0: none does [s]
  double fewest = 1.0;   ///< balls
  std::vector<double> steps = {5e-3, 1e-3};  ///< of engines that step [s]
  bool rests =
      false;  ///< after every tick it is looked whether all are at rest: what was in the caches of cores is not any more
};

const std::vector<CrowdScene>& crowdScenes();

/// The scene with this many balls.
Scene crowdOf(const CrowdScene& crowd, std::size_t balls);

/// How well a state holds up; balls and walls looked at anew, apart from the library.
struct Soundness
{
  double energy = 0.0;      ///< kinetic and potential, zero at the floor of the room [J]
  double overlap = 0.0;     ///< deepest [m]
  std::size_t escaped = 0;  ///< balls with their centre outside the room or the tray, or nowhere
  double fastest = 0.0;     ///< ball [m/s]
};
Soundness soundnessOf(const Scene& scene, const std::vector<BallState>& balls);
}  // namespace ping_pong::bench
