// How deep balls of radius kR overlap, each pair looked at: apart from what the library has for that.
#pragma once

#include <algorithm>
#include <cmath>

#include "scene_builder.h"

namespace ping_pong
{
/// Of two balls [m]; 0 if none do.
inline double deepestPair(const World& world)
{
  double deepest = 0.0;
  for (std::size_t a = 0; a < world.ballCount(); ++a)
    for (std::size_t b = a + 1; b < world.ballCount(); ++b)
      deepest = std::max(deepest, 2.0 * kR - (positionOf(world, a) - positionOf(world, b)).norm());
  return deepest;
}

/// Of two balls, or of a ball with the inside of a tray that stands on the origin [m].
/// @param half  of its inner width [m]
inline double deepestInTray(const World& world, double half)
{
  double deepest = deepestPair(world);
  for (std::size_t i = 0; i < world.ballCount(); ++i)
  {
    const Vector3d p = positionOf(world, i);
    deepest = std::max({deepest, kR - p.z(), std::abs(p.x()) + kR - half, std::abs(p.y()) + kR - half});
  }
  return deepest;
}
}  // namespace ping_pong
