// One flight of a ball from the racket down to a height, by the flight of the core.
#pragma once

#include <optional>

#include "ping_pong_sim/forces.h"

namespace ping_pong::play
{
/// A flight as the planner asks of it, in frame O of the player.
struct Arc
{
  double duration = 0.0;  ///< [s]
  BallState landing;      ///< when the centre has come down to the height
  double
      over_edge;  ///< height of the centre where x passes the own end of the table [m]; infinite if it starts beyond it
  double over_net;  ///< the same above the net; infinite if it does not pass it on the way to +x
};

/// What an arc is flown with.
struct Flyer
{
  const FlightModel* model = nullptr;
  double tolerance = 1e-7;  ///< position error after a second [m]
  double edge_x = 0.0;      ///< own end of the table [m]
  double longest = 2.5;     ///< longer flights are none [s]
  int* left =
      nullptr;  ///< flights that may still be flown: it bounds the work of whoever searches; nullptr: any number
};

/// From `state` to where the centre comes down through `height`; nothing if it does not in time, or no flight is left.
std::optional<Arc> flyDownTo(const Flyer& flyer, const BallState& state, double height);
}  // namespace ping_pong::play
