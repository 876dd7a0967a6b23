// Paths that have a formula, in long double: elastic bouncing, bouncing to rest, back and forth between walls.
#pragma once

#include <cmath>

#include "chart_scene.h"

namespace ping_pong::bench
{
/// Height above the lowest point, and speed upwards.
struct Vertical
{
  Real z = 0.0L;  ///< [m]
  Real v = 0.0L;  ///< [m/s]
};

/// Elastic bouncing: one arc, again and again.
class ElasticBouncing
{
public:
  ElasticBouncing(const Vertical& start, Real g)
      : g_(g), speed_(std::sqrt(start.v * start.v + 2.0L * g * start.z)), begun_((speed_ - start.v) / g)
  {
  }

  Vertical at(Real t) const
  {
    const Real s = std::fmod(begun_ + t, period());
    return {speed_ * s - 0.5L * g_ * s * s, speed_ - g_ * s};
  }
  Real period() const { return 2.0L * speed_ / g_; }
  Real firstBounce() const { return period() - begun_; }

private:
  Real g_, speed_;  // at the ground [m/s]
  Real begun_;      // time since the last bounce, had there been one
};

/// Dropped at rest with restitution e < 1: arcs that shrink by e each, and rest after a finite time.
class BouncingToRest
{
public:
  BouncingToRest(Real height, Real e, Real g) : height_(height), e_(e), g_(g), fall_(std::sqrt(2.0L * height / g)) {}

  Vertical at(Real t) const
  {
    if (t < fall_) return {height_ - 0.5L * g_ * t * t, -g_ * t};
    if (t >= rest()) return {};
    t -= fall_;
    for (Real speed = e_ * g_ * fall_;; speed *= e_)
    {
      const Real arc = 2.0L * speed / g_;
      if (t < arc) return {speed * t - 0.5L * g_ * t * t, speed - g_ * t};
      if (arc < 1e-18L) return {};
      t -= arc;
    }
  }
  Real rest() const { return fall_ * (1.0L + e_) / (1.0L - e_); }
  /// Bounces with arcs longer than `shortest` after them.
  std::vector<Real> bounces(Real shortest) const
  {
    std::vector<Real> times;
    Real t = fall_;
    for (Real arc = 2.0L * e_ * fall_; arc > shortest; arc *= e_)
    {
      times.push_back(t);
      t += arc;
    }
    return times;
  }

private:
  Real height_, e_, g_, fall_;
};

/// Constant speed between elastic walls at `low` and `high`.
class BackAndForth
{
public:
  BackAndForth(Real low, Real high, Real x, Real v) : low_(low), width_(high - low), x_(x - low), v_(v) {}

  Real position(Real t) const
  {
    const Real along = unfolded(t);
    return low_ + (along < width_ ? along : 2.0L * width_ - along);
  }
  Real velocity(Real t) const { return unfolded(t) < width_ ? v_ : -v_; }
  std::vector<Real> bounces(Real duration) const
  {
    std::vector<Real> times;
    if (v_ == 0.0L) return times;
    const Real first = (v_ > 0.0L ? width_ - x_ : x_) / std::abs(v_);
    for (Real t = first; t < duration; t += width_ / std::abs(v_)) times.push_back(t);
    return times;
  }

private:
  // Mirror images of the room side by side: the way is straight, with period 2 width.
  Real unfolded(Real t) const
  {
    const Real s = std::fmod(x_ + v_ * t, 2.0L * width_);
    return s < 0.0L ? s + 2.0L * width_ : s;
  }

  Real low_, width_, x_, v_;
};
}  // namespace ping_pong::bench
