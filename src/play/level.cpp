#include "level.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace ping_pong::play
{
// Chosen so that each level wins about two rallies of three or more against the one below, and so misses more than it.
const LevelTraits& levelTraits(int level)
{
  static const LevelTraits traits[] = {
      //reaction look  place  velocity spin  racket: place angle speed   limits
      {0.22, 0.030, 0.010, 0.20, 0.40, 0.012, 0.070, 0.080, 6.0, 70.0, 0.4},
      {0.16, 0.025, 0.007, 0.14, 0.28, 0.009, 0.045, 0.055, 8.0, 100.0, 0.5},
      {0.11, 0.020, 0.005, 0.10, 0.18, 0.007, 0.028, 0.035, 10.0, 150.0, 0.6},
      {0.06, 0.020, 0.003, 0.06, 0.09, 0.004, 0.015, 0.018, 14.0, 250.0, 0.8},
      {},
  };
  if (level < kLowestLevel || level > kHighestLevel)
    throw std::invalid_argument("level: " + std::to_string(level) + ": expected 1 to 5");
  return traits[level - kLowestLevel];
}

DriveLimits limitsOf(const DriveLimits& scene, const LevelTraits& level)
{
  return {std::min(scene.speed, level.speed), std::min(scene.acceleration, level.acceleration),
          level.turning * scene.angular_speed, level.turning * scene.angular_acceleration};
}
}  // namespace ping_pong::play
