// Everything but a paddle in motion: it moves at a steady rate while a key is held, place by place.
#pragma once

#include <string>

#include "glide.h"
#include "held_keys.h"
#include "sim_link.h"

namespace ping_pong_sim
{
class SteadyMove
{
public:
  /// Moves on if it is time to.
  /// @param axes  of the wish, in the world
  /// @param now   wallSeconds()
  /// @return what went wrong, for people; empty: nothing
  std::string go(SimLink& link, const std::string& name, const ping_pong::Wish& wish, const Eigen::Matrix3d& axes,
                 const ping_pong::GlideParams& params, double now);
  /// The next move begins where the thing then is.
  void stop() { moved_at_ = 0.0; }

private:
  double moved_at_ = 0.0;  ///< wallSeconds(); 0: no move goes on
  FramePose moved_to_;
};
}  // namespace ping_pong_sim
