// One point of the chart: an engine in one of its variants at one step, in one scene.
#pragma once

#include "engines/engine.h"

namespace ping_pong::bench
{
struct Point
{
  const EngineKind* engine = nullptr;
  std::string variant;
  double step = 0.0;  ///< [s], or a tolerance [m]
};

/// Sums over all starts, balls and samples.
struct Errors
{
  int starts = 0;
  double position_rms = 0.0, position_max = 0.0;  ///< [m], at samples away from bounces
  double spin_rms = 0.0;                          ///< [rad/s]
  double energy_rms = 0.0, energy_growth = 0.0;   ///< relative to the energy that the scene has
  double momentum = 0.0;                          ///< sideways, largest, relative to what that energy could give
  double penetration = 0.0;                       ///< deepest overlap seen [m]
  double overlap_rms = 0.0;                       ///< of all overlaps at once: root of the mean sum of squares [m]
  double wrong_bounces = 0.0;                     ///< part of the paths; not counted at steps above 20 ms
  int missed = 0, tunnelled = 0, not_finite = 0;  ///< starts
  int unsettled = 0;                              ///< starts that leave balls where they cannot stay
  double seconds = 0.0;                           ///< that the run took

  bool gainsEnergy() const { return energy_growth > 0.01; }
  bool failed() const { return missed > 0 || tunnelled > 0 || not_finite > 0 || unsettled > 0 || gainsEnergy(); }
};

/// How much to measure.
struct Effort
{
  int most_starts = 64;
  bool decades_only = false;  ///< of the steps, take 1, 0.1, 0.01 ... only
  double error_budget = 8.0;  ///< points whose error run would take longer are not measured [s]
  double repeat_time = 0.2;   ///< least time of one repeat [s]
  int repeats = 5;
};
}  // namespace ping_pong::bench
