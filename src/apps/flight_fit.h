// Fits where a measured flight began, how fast and with which spin, so that a model of the forces can be judged by the rest.
#pragma once

#include "measured_data.h"
#include "validation_models.h"

namespace ping_pong
{
struct FlightFit
{
  BallState start;
  double misfit = 0.0;              ///< rms per coordinate [m]
  std::vector<Vector3d> residuals;  ///< measured - model [m]
};

/// Levenberg and Marquardt's method on position, velocity and, if asked, spin at the first sample (Nocedal and Wright,
/// "Numerical Optimization", 2006, 10.3); the forward model is World. No constant of the model is touched.
/// @param samples  of the flight to use, from the first
FlightFit fitFlight(const Flight& flight, std::size_t samples, const FlightChoice& model, bool spin);
}  // namespace ping_pong
