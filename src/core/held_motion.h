// The motion of a ball that lies on surfaces: what forces, surfaces and friction make of it.
#pragma once

#include "world_state.h"

namespace ping_pong
{
/// One surface that a ball lies on, at one instant.
struct Place
{
  const Shape& shape;
  const Surface& law;
  BodyFrame frame;
};

Place placeOf(const WorldState& world, const BallRecord& ball, std::size_t support, double t);

struct HeldMotion
{
  Vector3d a = Vector3d::Zero();      ///< of the centre [m/s^2]
  Vector3d alpha = Vector3d::Zero();  ///< of the spin [rad/s^2]
  double until_grip = kNever;         ///< time after which friction has used up the slip at this rate [s]
};

/// Slip of the touching point over surface `place`: v + w x (-r n) - u, tangential [m/s].
Vector3d slipOver(const Place& place, const BallParams& ball, const BallState& state);

/// Acceleration of a smooth ball on its supports. Marks the loaded ones in `bounds`.
Vector3d smoothAcceleration(const WorldState& world, const BallRecord& ball, const BallState& state, double t,
                            AccelerationBounds& bounds);

/// The same with friction, rolling resistance and spin friction where the surfaces have them. A sliding ball feels mu N
/// against its slip; where friction can stop the slip within `grip_time`, it grips and rolls:
/// a_t = (tangential acceleration without friction) / (1 + k).
HeldMotion heldMotion(const WorldState& world, const BallRecord& ball, const BallState& state, double t,
                      double grip_time, AccelerationBounds& bounds);
}  // namespace ping_pong
