// Runs random scenes and judges them.
#pragma once

#include "random_scene.h"
#include "verdict.h"

namespace ping_pong::stability
{
// Bounds, with their reasons.

/// After the last real bounce a ball flies, slides, rolls, rests: some pieces of path, some changes between them.
constexpr double kEventsPerSecond = 200.0;
/// And the bounces of less than 1 mm/s of up to three surfaces: ln(1e-3 / 4e-6) / ln(1 / 0.9) = 52 until they lift it
/// by 1e-12 m; and a dozen pieces for each slip that turns its direction before it ends.
constexpr double kLastBounces = 200.0;
constexpr double kRealBounce = 1e-3;  // [m/s]
/// Bounces with e = 0.9 and speeds down to 1 mm/s, paddles in windows of 5 ms: far below; a storm has 1e6 in a tick.
constexpr double kStorm = 2e4;
constexpr double kMostDepth =
    1e-9;  // [m]: coordinates of metres round at 1e-16, bodies' poses and projections add some

/// Runs it to its end with this method, or until it cannot go on.
/// @param dt  longest step of methods with steps [s]
Verdict judge(const RandomScene& drawn, Method method = Method::Exact, double dt = 1e-3);
}  // namespace ping_pong::stability
