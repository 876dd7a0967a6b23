// One point: an engine, a scene, a number of balls; in a process of its own, so that its memory is its own.
#pragma once

#include <cstdint>
#include <vector>

#include "crowd_scene.h"
#include "engines/engine.h"

namespace ping_pong::bench
{
struct CrowdPoint
{
  const EngineKind* engine = nullptr;
  std::string variant;
  double step = 0.0;        ///< [s]; not looked at by `exact`
  std::size_t threads = 1;  ///< of our own engine
  bool companion = false;   ///< another world moves on beside it, see companion.h
};

struct CrowdResult
{
  bool done = false;       ///< else nothing below counts
  double start = 0.0;      ///< wall time from scene to engine [s]
  double simulated = 0.0;  ///< measured part [s]
  double wall = 0.0;       ///< all of the process [s]
  double bytes = 0.0;      ///< peak memory of engine and run
  double contacts = 0.0;   ///< per simulated second; of our own engine
  double events = 0.0;
  double energy_change = 0.0;  ///< at the end, relative
  double overlap = 0.0;        ///< deepest seen: at 10 looks, or all ticks if fewer [m]
  double escaped = 0.0;        ///< balls at the end
  double rest_after = -1.0;    ///< from then on no ball is faster than 10 mm/s at any look; < 0: never [s]
  std::uint64_t hash = 0;      ///< of the end; of our own engine
};

/// A point is a process.
struct CrowdRun
{
  CrowdResult result;
  std::vector<double> ticks;  ///< wall time of each [s]
};

struct CrowdEffort
{
  double steady = 1.0;  ///< wall time to measure where any part will do [s]
  double most = 60.0;   ///< wall time that a run may take in all [s]
};

constexpr double kTick = 0.01;  ///< [s]: a picture or a message a hundred times a second

/// @param ticks  to measure, exactly; 0: as many as the effort allows
CrowdRun measureCrowd(const CrowdPoint& point, const CrowdScene& crowd, std::size_t balls, const CrowdEffort& effort,
                      std::size_t ticks = 0);
}  // namespace ping_pong::bench
