// The one ball of a world at an instant, with all that it touches.
#pragma once

#include <vector>

#include "ping_pong_sim/forces.h"
#include "ping_pong_sim/world.h"
#include "touch.h"

namespace ping_pong::stability
{
constexpr double kTouchGap = 1e-9;  ///< nearer than this a ball touches [m]

struct Moment
{
  double time = 0.0;
  BallState ball;
  std::vector<Touch> around;    ///< every shape
  std::vector<Touch> touching;  ///< of those, what it touches
  double energy = 0.0;          ///< per mass: kinetic, rotational, potential with buoyancy [J/kg]
  bool held = false;            ///< lies, rolls or slides, by the world's own account
  double radius = 0.0;          ///< [m]

  double depth() const;  ///< in the solid that it is deepest in [m]
  double scale() const;  ///< speed of the ball and its rim, and 1 m/s [m/s]
};

/// @param g  what gravity and buoyancy do [m/s^2]
Moment momentOf(const World& world, const Vector3d& g);

/// What gravity and buoyancy do to the ball of this scene [m/s^2].
Vector3d pullOf(const Scene& scene);

/// The same shapes in the same order.
bool sameTouches(const Moment& a, const Moment& b);
}  // namespace ping_pong::stability
