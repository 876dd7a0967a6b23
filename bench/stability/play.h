// A world with a random scene and the commands that its bodies get.
#pragma once

#include "ping_pong_sim/world.h"
#include "random_scene.h"

namespace ping_pong::stability
{
class Play
{
public:
  Play(const RandomScene& drawn, Method method, double dt);

  /// One tick.
  StepStatus advance(double duration);
  const World& world() const { return world_; }

private:
  const std::vector<TimedCommand> commands_;
  std::size_t next_ = 0;
  World world_;
};

/// The scene with this method.
Scene withMethod(Scene scene, Method method, double dt);

/// Normal speed before an impact [m/s].
double closingOf(const Contact& contact);
}  // namespace ping_pong::stability
