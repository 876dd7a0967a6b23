// Balls that meet others without end in contacts that lose speed.
#pragma once

#include "state/world_state.h"

namespace ping_pong
{
inline constexpr int kCrowded = 150;       // contacts of a ball with others,
inline constexpr double kCrowdTime = 0.2;  // within this time, make it join [s]

/// After a contact of a ball with another one at time t that loses speed: whether they follow each other too fast.
inline bool countCrowding(BallRecord& ball, double t)
{
  if (t - static_cast<double>(ball.crowded_since) > kCrowdTime)
  {
    ball.crowded_since = static_cast<float>(t);
    ball.crowding = 0;
  }
  if (ball.crowding <= kCrowded) ++ball.crowding;
  return ball.crowding > kCrowded;
}
}  // namespace ping_pong
