// Levels of a player: how soon it sees, how fast it moves, how well it aims and reads spin.
#pragma once

#include "ping_pong_sim/body.h"

namespace ping_pong::play
{
constexpr int kLowestLevel = 1, kHighestLevel = 5;

/// Errors are normally distributed; these are their deviations. At level 5 all are zero: what is left is the drive.
struct LevelTraits
{
  double reaction = 0.0;      ///< the ball is seen so late [s]
  double look_every = 0.0;    ///< time between two looks at the ball; 0: every tick [s]
  double see_place = 0.0;     ///< of each look, each coordinate [m]
  double see_velocity = 0.0;  ///< the same [m/s]
  double spin_reading = 0.0;  ///< part of the spin that is misread, once for each stroke of the opponent
  double place = 0.0;         ///< of the racket at the hit, each coordinate [m]
  double angle = 0.0;         ///< of the racket at the hit, about each axis across the normal [rad]
  double stroke_speed = 0.0;  ///< part of the racket's speed
  double speed = 1e9;         ///< the racket's own limits, besides those of the scene [m/s]
  double acceleration = 1e9;  ///< [m/s^2]
  double turning = 1.0;       ///< part of the scene's angular limits
};

/// Throws std::invalid_argument "level: N: expected 1 to 5".
const LevelTraits& levelTraits(int level);

/// The scene's limits with those of the level.
DriveLimits limitsOf(const DriveLimits& scene, const LevelTraits& level);
}  // namespace ping_pong::play
