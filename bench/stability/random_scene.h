// Scenes of one ball and the places where a ball comes into trouble: corners, grooves, seams, edges, curved, turning
// and pushing surfaces, with all kinds of contact laws and air.
#pragma once

#include <string>

#include "ping_pong_sim/scene.h"
#include "stage.h"

namespace ping_pong::stability
{
struct RandomScene
{
  std::uint64_t seed = 0, index = 0;
  std::string category;
  Scene scene;                         ///< method exact, until somebody wants another
  Scene whole;                         ///< the same without seams between faces; no bodies: there are none
  std::vector<TimedCommand> commands;  ///< in order of time
  std::string launch;                  ///< how the ball starts: rolled, slid, dropped, thrown, spun, rest
  double tick = 0.01;                  ///< [s]
  double duration = 2.0;               ///< [s]

  bool moves() const { return !commands.empty(); }
  bool hasWhole() const { return !whole.bodies.empty(); }
};

/// Number `index` of the endless series `seed`: the same numbers, the same scene.
RandomScene randomScene(std::uint64_t seed, std::uint64_t index);
}  // namespace ping_pong::stability
