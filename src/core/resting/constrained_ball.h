// A ball constrained by its supports: the contact problem at an instant, and the modes that hold from then on.
#pragma once

#include "resting/contact_problem.h"
#include "state/world_state.h"

namespace ping_pong
{
/// What stays the same while a path is laid.
struct ConstrainedBall
{
  const FlightModel& model;
  double radius;  ///< [m]
  double k;       ///< inertia, I / (m r^2)
  std::size_t count = 0;
  std::array<SupportSurface, kMaxSupports> surface;
};

/// The supports of a ball at world time t, each with the feature that the ball is on.
ConstrainedBall constrainedBall(const WorldState& world, const BallRecord& ball, const Vector3d& p_WB, double t);

BallMotion motionOf(const BallState& state, double radius);

/// The contact problem without modes.
ContactProblem problemAt(const ConstrainedBall& constrained, const BallMotion& ball, double t);

/// Motions of a support that are brought to rest.
struct Grip
{
  bool slip = false, roll = false, spin = false;
  bool contact = false;  ///< must not part meanwhile
};
using Grips = std::array<Grip, kMaxSupports>;

/// Modes at an instant, and what they make of the motion.
struct Decision
{
  ContactProblem problem;
  BallAcceleration motion;
  SupportForces forces;
  Grips stops;           ///< all that holds, if some of it can be stopped within the grip time but is not at rest yet
  bool answered = true;  ///< else nothing that Coulomb's law allows
};

/// Whether a slip, a roll or a spin is slow enough to be stopped within the grip time, but not at rest.
bool movesSlowly(const ContactProblem& problem, const BallMotion& ball, double grip_time);

/// @param grip_time  what can be brought to rest within this time counts as held, and is listed in `stops`; 0: nothing [s]
Decision decide(const ConstrainedBall& constrained, const BallMotion& ball, double t, double grip_time);

/// Whether modes that were decided before are still the ones, now: what slipped slips, and what held holds.
bool modesHold(const ConstrainedBall& constrained, const Decision& decided, const BallMotion& ball, double t);

/// After how long the first thing that slips comes to rest, at its present rate; kNever if none does [s].
double slipsFor(const Decision& decision);

/// Loaded contacts without a limit of friction that slip: they grip at once. None if there is no such slip.
Grips allThatAlwaysGrips(const Decision& decision, const BallMotion& ball);

/// Slower than this is at rest: rounding [m/s].
double noSpeed(const BallMotion& ball);
}  // namespace ping_pong
