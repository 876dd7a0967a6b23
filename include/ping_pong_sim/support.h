// Contact mode: a ball that has stopped bouncing on a surface stays on it, exactly, until the surface lets it go.
#pragma once

#include <array>

#include "ping_pong_sim/body.h"
#include "ping_pong_sim/detect.h"
#include "ping_pong_sim/evolve.h"
#include "ping_pong_sim/pooled.h"

namespace ping_pong
{
/// n.a >= b: the surface forbids accelerations into itself.
struct AccelerationBound
{
  Vector3d n;      ///< unit normal, towards the ball
  double b = 0.0;  ///< [m/s^2]
};

/// Surfaces that a ball lies on.
class Supports
{
public:
  static constexpr std::size_t kMax = 8;
  struct Surface
  {
    std::uint16_t body = 0;
    std::uint16_t shape = 0;
  };

  std::size_t count() const { return list_ ? list_->count : 0; }
  bool none() const { return count() == 0; }
  const Surface& operator[](std::size_t index) const { return list_->surfaces[index]; }
  bool has(std::size_t body, std::size_t shape) const { return list_ && list_->has(body, shape); }
  void add(std::size_t body, std::size_t shape);  ///< ignores what it has already, and more than kMax
  void remove(std::size_t index);

  double since() const { return list_ ? list_->since : 0.0; }  ///< world time at which its bounces ended [s]
  void setSince(double time) { list_.make().since = time; }

  /// A shape whose contacts are not looked for until then, on this path: it continues a face that the ball slides over.
  void pass(std::size_t body, std::size_t shape, double until);
  void passNone();
  /// When contacts with this shape begin to count, no earlier than `from` [s].
  double passesUntil(std::size_t body, std::size_t shape, double from) const;

  /// Memory for those of so many balls, see Pooled::reserve().
  static void reserve(std::size_t balls, std::size_t threads) { Pooled<List>::reserve(balls, threads); }

private:
  struct List
  {
    double since = 0.0;
    double passing_until = -kNever;  ///< of `passing`
    std::array<Surface, kMax> surfaces;
    Surface passing;
    std::uint32_t count = 0;

    bool has(std::size_t body, std::size_t shape) const;
  };

  Pooled<List> list_;  ///< few balls of a crowd lie
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
