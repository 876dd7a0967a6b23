// Detect: the earliest contact inside a motion.
//
// The gap between a ball and a convex shape is a convex function of the ball's position in the shape's frame: along a path
// y(s) it stays above f + f' d + c d^2 / 2, where f, f' and the normal n belong to one instant and c is a lower bound of n.y''
// from then on. So no contact can happen before the root of that parabola: step there and look again. The steps never jump
// over a contact, converge quadratically on it, and are exact at once for a parabola above a face of a still body.
#pragma once

#include <vector>

#include "evolve/segment.h"
#include "ping_pong_sim/body.h"

namespace ping_pong
{
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Away so slowly a touching ball that is pressed on the surface does not separate: 1e-19 m under gravity. Such a contact is
/// found, and has to be the end of bouncing, by the same bound: else it would be found again and again [m/s].
constexpr double kNoSeparationSpeed = 1e-9;

/// A ball and a shape at one instant.
struct Gap
{
  double gap = 0.0;   ///< distance of the surfaces, negative in overlap [m]
  double rate = 0.0;  ///< d(gap)/dt [m/s]
  Vector3d n_W;       ///< unit, from the shape to the ball
};

Gap gapTo(const Shape& shape, const BodyFrame& frame, const Vector3d& p_WB, const Vector3d& v_WB, double radius);

/// The same for a shape that does not move and is given in W.
Gap gapTo(const Shape& placed, const Vector3d& p_WB, const Vector3d& v_WB, double radius);

/// Second derivative of the gap of a ball that moves with acceleration a_WB, curvature of the surface included [m/s^2].
double gapAcceleration(const Shape& shape, const BodyFrame& frame, const Vector3d& p_WB, const Vector3d& v_WB,
                       const Vector3d& a_WB);

/// Below this gap a ball touches [m]: a few units in the last place of its coordinates.
inline double touchTolerance(const Vector3d& p_WB, double radius)
{
  return 4e-16 * (p_WB.cwiseAbs().maxCoeff() + radius);
}

/// Answer of firstContact.
struct Detection
{
  double time = kNever;    ///< of the contact; or up to which there is none, if undecided
  bool undecided = false;  ///< the search was cut short at `time`: look again from there

  bool found() const { return time < kNever && !undecided; }
};

/// First world time in [from, until] at which the ball touches the shape and closes in (or presses on it); kNever if none.
/// Touching and closing in at `from` is a contact at `from`; touching and receding is none. `until` must be finite if the body turns.
Detection firstContact(const Segment& path, double radius, const Shape& shape, const BodyMotion& motion, double from,
                       double until);

/// The same for a shape that does not move and is given in W.
Detection firstContact(const Segment& path, double radius, const Shape& placed, double from, double until);

/// A shape of a body that does not move, given in W.
Shape placed(Shape shape, const Pose& X_WB);

/// The same for two balls. Free flights under the same acceleration: a quadratic, solved without cancellation.
Detection firstContact(const Segment& path1, double radius1, const Segment& path2, double radius2, double from,
                       double until);

/// First world time in [from, until] at which the point of a flat face below the ball leaves that face; the body must not
/// turn. The face is the one that the ball touches at `from`.
double leavesFace(const Segment& path, const Shape& shape, const BodyMotion& motion, double from, double until);
}  // namespace ping_pong
