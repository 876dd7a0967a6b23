// Balls of the solver that moving bodies leave no room: they are not shot out but taken along, and squeezed in the end.
//
// All of this is asked only while a moving body is the neighbour of a ball of the solver. Rules and bounds: docs/crowds.md.
#pragma once

#include "solver/solver_state.h"

namespace ping_pong
{
/// The longest step, at most `longest`, in which no moving body goes far against the radius of a ball near it: a body that
/// is past the middle of a ball would push it out on its other side.
double shortEnough(const WorldWithSolver& world, double start, double end, double longest);

/// Before impacts: where the balls are.
void keepStartPositions(ContactSolver& solver);

/// Whether a moving body that hits a ball takes it along instead of throwing it. Notes the hit.
/// @param t  from the start of the step [s]
bool takesAlong(ContactSolver& solver, const BodyNeighbour& neighbour, double t);
/// Of an impulse by which a surface at `speed` takes a ball along: no more than gives it the energy of that speed, if it did
/// not have more before. Between surfaces that hardly leave room each hit would make it faster yet.
void limitImpulse(const BallParams& ball, const BallState& before, double speed, BallState& after, Vector3d& impulse);
/// The ball has hit something else.
void noteOther(ContactSolver& solver, std::uint32_t ball);

/// After the contacts have been solved: ContactSolver::pressing.
void findPressing(ContactSolver& solver);
/// After they have acted: a ball that they have made livelier than the bodies that press account for has no more than what they
/// have taken from others.
void limitEnergies(ContactSolver& solver);

/// At the end of a step: which balls are deeper in a body than contacts leave them.
void findSqueezed(WorldWithSolver& world);
/// They leave the solver, at rest where they were last whole.
void takeOutSqueezed(WorldWithSolver& world);
}  // namespace ping_pong
