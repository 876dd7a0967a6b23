// How deep balls are in other things: distances written out again, apart from the library.
#pragma once

#include "chart_scene.h"
#include "engine.h"

namespace ping_pong::bench
{
/// States of all balls.
std::vector<BallState> statesOf(const Engine& engine, std::size_t balls);

/// Deepest overlap of a ball with a body or another ball at this time [m]; 0 if there is none.
double worstOverlap(const Start& start, const std::vector<BallState>& balls, double time);

/// Deepest that a ball is in a body, as parts of its radius: above 1 its middle is inside.
double worstDepthInBody(const Start& start, const std::vector<BallState>& balls, double time);
}  // namespace ping_pong::bench
