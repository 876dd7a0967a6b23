// Loads and friction of a ball on all of its supports at one instant, as one problem.
//
// Each support separates or carries a load N >= 0; a loaded one sticks or slides with Coulomb's cone |f| <= mu N, and holds or
// lets go of the ball's rolling and of its spin in the same way. Which of these modes hold together is found by a projected
// block Gauss-Seidel method (Jean 1999, "The non-smooth contact dynamics method"; the law is that of Stewart and Trinkle 1996);
// for known modes the rest is linear.
#pragma once

#include <array>
#include <cstdint>

#include "resting/support_point.h"
#include "state/supports.h"

namespace ping_pong
{
inline constexpr std::size_t kMaxSupports = Supports::kMax;

/// What a dry resistance does: friction, rolling resistance, spin friction.
enum class Resistance : std::uint8_t
{
  None,   ///< the law does not name it, or there is no load
  Holds,  ///< whatever it takes, up to its limit: no motion
  Slips   ///< its limit, against the motion
};

/// Modes of a support.
struct SupportMode
{
  bool loaded = false;
  Resistance slip = Resistance::None;
  Resistance roll = Resistance::None;
  Resistance spin = Resistance::None;
  Vector3d slip_direction =
      Vector3d::Zero();  ///< unit: of the slip, or where it begins, against the friction that could not hold it
  Vector3d roll_direction = Vector3d::Zero();
  double spin_direction = 0.0;

  bool sameAs(const SupportMode& other) const
  {
    return loaded == other.loaded && slip == other.slip && roll == other.roll && spin == other.spin;
  }
};

/// A ball on its supports at one instant.
struct ContactProblem
{
  std::size_t count = 0;
  std::array<const Surface*, kMaxSupports> law{};
  std::array<SupportPoint, kMaxSupports> at;
  std::array<SupportMode, kMaxSupports> mode;
  BallAcceleration free;  ///< without supports [m/s^2]
  double k = 0.0;         ///< inertia of the ball, I / (m r^2)
};

/// Forces per mass of one support on the ball [m/s^2].
struct SupportForce
{
  double load = 0.0;                     ///< N / m, along n
  Vector3d friction = Vector3d::Zero();  ///< f / m, tangential
  Vector3d roll = Vector3d::Zero();      ///< torque / (k m r), tangential: what it adds to b
  double spin = 0.0;                     ///< the same about n
};
using SupportForces = std::array<SupportForce, kMaxSupports>;

/// Limit of each resistance of a loaded contact [m/s^2]; none without load, however rough.
double frictionLimit(const Surface& law, double load);
double rollLimit(const Surface& law, double k, double load);
double spinLimit(const Surface& law, double k, double load);

/// Finds the acceleration and the forces. In: modes; a resistance that `Slips` keeps its direction, one that `Holds` may also
/// have to let go: its motion is to change at the rate -bias.
/// @return  false if there is no answer, as where friction itself jams the ball (Painleve)
bool findForces(const ContactProblem& problem, BallAcceleration& motion, SupportForces& forces);

/// Which modes those forces stand for; a resistance at its limit begins to slip against its force.
std::array<SupportMode, kMaxSupports> modesOf(const ContactProblem& problem, const BallAcceleration& motion,
                                              const SupportForces& forces);

/// The acceleration under the modes of the problem: linear. Where several contacts stick they may press on each other through
/// the ball, as much as they like by Coulomb's law: of all such forces the nearest to those given.
BallAcceleration accelerationInModes(const ContactProblem& problem, const SupportForces& near);

/// The size of accelerations, of which rounding is a part [m/s^2].
double scaleOf(const ContactProblem& problem);
}  // namespace ping_pong
