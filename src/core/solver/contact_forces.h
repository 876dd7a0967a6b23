// Contacts of the pile that carry load: which links are in touch, and the impulses in them.
#pragma once

#include "solver/slabs.h"

namespace ping_pong
{
/// Lists the links that touch by the end of the step, at the velocities that balls have now, and starts them.
void gatherTouches(WorldWithSolver& world);

/// Part of an overlap that is taken out of the places now, by numbers or lanes [m].
template <class Number>
Number pushOut(Number overlap)
{
  constexpr float kSlop = 2e-6f;    // overlap that stays [m]
  constexpr float kPushOut = 0.2f;  // part of the rest that is taken out in a step
  const Number rest = overlap - kSlop;
  return kPushOut * (rest > 0.0f ? rest : Number{});
}

/// Makes touches of the pairs that have been found; all begin with the impulses of the last step.
void startTouches(WorldWithSolver& world, PileShare& share);

/// Solves touches one after the other, again and again, until nothing changes.
void iterate(WorldWithSolver& world);

/// No contact of this step has acted on the ball yet.
void clearChange(Pile& pile, std::uint32_t ball);

/// A sleeping ball wakes up when the force of an awake one on it changes, comes or goes.
/// @param l       their link
/// @param normal  impulse in this step [N s]
void watch(const Pile& pile, PileShare& share, std::uint32_t l, float normal);
}  // namespace ping_pong
