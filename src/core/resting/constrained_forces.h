// Forces of supports whose modes are known: linear equations, and the forces with which supports press on each other.
#pragma once

#include "resting/contact_problem.h"

namespace ping_pong
{
inline constexpr double kContactRounding = 1e-11;   ///< accelerations below this part of the scale are none
inline constexpr double kInsideLimit = 1.0 - 1e-9;  ///< of a limit: what takes less holds

/// If the supports that are marked as loaded are, and all that may hold there holds: whether the forces that this takes exist.
/// @param near      where several forces will do, the search for those within all limits begins at the nearest to these
/// @param squeezed  even where supports carry loads only because they press on each other through the ball
bool allHold(const ContactProblem& problem, const SupportForces& near, bool squeezed, BallAcceleration& motion,
             SupportForces& forces);
}  // namespace ping_pong
