// Where two ways to compute a contact must come to the same: `exact`, and the solver of `impulse` with steps that get shorter.
#pragma once

#include "random_scene.h"
#include "verdict.h"

namespace ping_pong::stability
{
constexpr double kCoarseStep = 1e-3, kFineStep = 2.5e-4;  // [s]

/// Runs the scene with both until the second real bounce of `exact`, 0.4 s at most. `coarse` and `fine` of the verdict are the
/// greatest distances between the balls at ends of ticks with either step.
Verdict compareWithImpulse(const RandomScene& drawn);
}  // namespace ping_pong::stability
