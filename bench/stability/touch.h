// Which surfaces a ball touches, and how it moves over them; apart from what the library has for that.
#pragma once

#include <vector>

#include "ping_pong_sim/ball.h"
#include "stage.h"

namespace ping_pong::stability
{
struct Touch
{
  ShapeName of;
  double gap = 0.0;                  ///< between ball and surface, negative in overlap [m]
  Vector3d n_W = Vector3d::UnitZ();  ///< unit, from the surface to the ball
  Vector3d u_WC = Vector3d::Zero();  ///< velocity of the touched point of the surface [m/s]
  bool turns = false;                ///< its body
};

/// @param twist  of the body
Touch touchOf(const Body& body, ShapeName of, const Pose& X_WB, const Twist& twist, const BallState& ball,
              double radius);

/// Slip of the ball over the surface, tangential [m/s].
Vector3d slipOf(const Touch& touch, const BallState& ball, double radius);

/// The deepest overlap with any of these bodies, where they are at the start [m]; below zero: room.
double deepest(const std::vector<Body>& bodies, const Vector3d& p_WB, double radius);
}  // namespace ping_pong::stability
