// Contact mode: a ball that has stopped bouncing on a surface stays on it, exactly, until the surface lets it go.
#pragma once

#include <array>

#include "ping_pong_sim/body.h"
#include "ping_pong_sim/evolve.h"
#include "ping_pong_sim/segment.h"

namespace ping_pong
{
/// n.a >= b: the surface forbids accelerations into itself.
struct AccelerationBound
{
  Vector3d n;      ///< unit normal, towards the ball
  double b = 0.0;  ///< [m/s^2]
};

/// Surfaces that a ball lies on.
struct Supports
{
  static constexpr std::size_t kMax = 8;
  struct Surface
  {
    std::uint32_t body = 0;
    std::uint32_t shape = 0;
  };
  std::array<Surface, kMax> list;
  std::uint32_t count = 0;
  double since = 0.0;  ///< world time at which its bounces ended [s]

  bool has(std::size_t body, std::size_t shape) const;
  void add(std::size_t body, std::size_t shape);  ///< ignores what it has already, and more than kMax
  void remove(std::size_t index);
  bool none() const { return count == 0; }
};

/// Bounds of all surfaces that a ball lies on, at one instant.
struct AccelerationBounds
{
  std::array<AccelerationBound, Supports::kMax> list;
  std::array<bool, Supports::kMax> loaded{};  ///< answer: the ball cannot leave this surface
  std::array<double, Supports::kMax> load{};  ///< answer: force per mass along n [m/s^2]
  std::size_t count = 0;
};

/// The acceleration nearest to `free` that respects all bounds: what smooth surfaces leave of it (Gauss's principle of least
/// constraint). Looks through the active sets of up to three bounds; marks those that carry load.
Vector3d constrainedAcceleration(const Vector3d& free, AccelerationBounds& bounds);
}  // namespace ping_pong
