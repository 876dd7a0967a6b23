// A scene that begins again once nothing is left to see.
#pragma once

#include "ping_pong_sim/world.h"

namespace ping_pong_sim
{
class Repeat
{
public:
  /// @param pause  simulated time after the end [s]; 0: the scene does not repeat
  explicit Repeat(double pause) : pause_(pause) {}

  /// After each tick: whether it is time to begin again. A scene has ended when each of its balls lies still, is down on the floor, or is
  /// out of sight. One without balls never ends.
  bool due(const ping_pong::World& world);

private:
  double pause_;
  double ended_at_ = -1.0;  ///< time of the world [s]; below 0: it goes on
};
}  // namespace ping_pong_sim
