// Contacts that carry load: which neighbours are in contact, and the impulses between them.
#pragma once

#include "solver/slabs.h"

namespace ping_pong
{
/// Lists the neighbours that touch by the end of the step, at the velocities that balls have now, and starts them.
void findContacts(WorldWithSolver& world);

/// Part of an overlap that is taken out of the places now, by numbers or lanes [m].
template <class Number>
Number overlapCorrection(Number overlap)
{
  constexpr float kSlop = 2e-6f;          // overlap that stays [m]
  constexpr float kCorrectedPart = 0.2f;  // part of the rest that is taken out in a step
  const Number rest = overlap - kSlop;
  return kCorrectedPart * (rest > 0.0f ? rest : Number{});
}

/// Makes constraints of the pairs that have been found; all begin with the impulses of the last step.
void startConstraints(WorldWithSolver& world, SolverSlab& slab);

/// Solves constraints one after the other, again and again, until nothing changes.
void iterate(WorldWithSolver& world);

/// No contact of this step has acted on the ball yet.
void clearChange(ContactSolver& solver, std::uint32_t ball);

/// A sleeping ball wakes up when the force of an awake one on it changes, comes or goes.
/// @param l       their index in `pairs`
/// @param normal  impulse in this step [N s]
void wakeIfForceChanged(const ContactSolver& solver, SolverSlab& slab, std::uint32_t l, float normal);
}  // namespace ping_pong
