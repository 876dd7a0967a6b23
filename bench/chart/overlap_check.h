// How deep balls are in other things: distances written out again, apart from the library.
#pragma once

#include "chart/scenes/chart_scene.h"
#include "engines/engine.h"

namespace ping_pong::bench
{
/// States of all balls.
std::vector<BallState> statesOf(const Engine& engine, std::size_t balls);

struct Overlap
{
  double deepest = 0.0;         ///< [m]
  double sum_of_squares = 0.0;  ///< [m^2]
};

/// Overlaps of balls with bodies and with each other at this time.
Overlap overlapOf(const Start& start, const std::vector<BallState>& balls, double time);

/// Deepest that a ball is in a body, as parts of its radius: above 1 its middle is inside.
double worstDepthInBody(const Start& start, const std::vector<BallState>& balls, double time);
}  // namespace ping_pong::bench
