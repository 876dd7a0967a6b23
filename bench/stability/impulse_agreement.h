// Where two ways to compute a contact must come to the same: `exact`, and the solver of `impulse` with steps that get
// shorter.
#pragma once

#include "random_scene.h"
#include "verdict.h"

namespace ping_pong::stability
{
constexpr double kCoarseStep = 1e-3, kFineStep = 2.5e-4;  // [s]
constexpr double kCloseEnough = 2e-4;                     // [m]: a step of 0.25 ms at 1 m/s
constexpr double kFalls = 2.0;  // at least so much from one step to the other; order 1 falls by 4

/// Whether the two mean the same by what the scene lists: resistance beside sliding and the air's hold on the spin of a
/// ball that lies are not settled, and a ball that stands on top of something falls to any side.
bool comparable(const RandomScene& drawn);

/// Runs the scene with both until the second real bounce of `exact`, 0.4 s at most. `coarse` and `fine` of the verdict
/// are the greatest distances between the balls at ends of ticks with either step.
Verdict compareWithImpulse(const RandomScene& drawn);

/// The error is small, or falls with the step.
bool agrees(const Verdict& verdict);
}  // namespace ping_pong::stability
