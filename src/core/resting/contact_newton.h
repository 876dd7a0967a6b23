// Newton's method on the contact problem: where iterations converge slowly, or stop short of it.
#pragma once

#include "resting/contact_problem.h"

namespace ping_pong
{
/// Goes on from forces near an answer. The law is written as x = projection(x - w(x)) on loads >= 0 and on the cones of
/// friction and resistances, which is solved piece by piece (Alart and Curnier 1991, "A mixed formulation for frictional
/// contact problems prone to Newton like solution methods").
/// @return  whether the answer was found; else forces and motion are left as they were
bool polishForces(const ContactProblem& problem, BallAcceleration& motion, SupportForces& forces);
}  // namespace ping_pong
