// The truth about flights through air with bounces on level ground: long double, extrapolation, located bounces.
#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "chart_scene.h"

namespace ping_pong::bench
{
/// Level ground with |x| and |y| at most these, at rest.
struct Ground
{
  Real height = 0.0L;                                   ///< [m]
  Real half_x = std::numeric_limits<Real>::infinity();  ///< [m]
  Real half_y = std::numeric_limits<Real>::infinity();  ///< [m]
};

struct AirTask
{
  const Scene* scene = nullptr;  ///< forces and contact law; ball 0
  std::vector<Ground> grounds;
  double duration = 0.0, sample_period = 0.0;      ///< [s]
  int refinement = 1;                              ///< divides the step
  std::function<bool(const Vector3r&)> forbidden;  ///< places where this truth does not hold; may be empty
};

/// Nothing if the ball comes to a forbidden place.
std::optional<TruePath> airTruth(const AirTask& task);
}  // namespace ping_pong::bench
