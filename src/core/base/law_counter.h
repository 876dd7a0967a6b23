// Counts how often each law is evaluated, for the test that a scene pays only for what it names. Nothing elsewhere: the
// calls vanish unless PING_PONG_SIM_COUNT is defined.
#pragma once

#include <array>
#include <cstddef>

#include "ping_pong_sim/shape.h"

namespace ping_pong
{
enum class Law
{
  FlightModel,           ///< set up
  ConstantAcceleration,  ///< gravity, or nothing
  Drag,
  DragTable,
  Lift,
  LiftTable,
  SpinRatio,
  SpinDecay,
  Collocation5,  ///< pieces tried, by degree
  Collocation7,
  Collocation9,
  Orientation,  ///< a turn worked out
  Restitution,
  Slip,  ///< speed of the touching point, spin included
  Friction,
  TangentialRestitution,
  RollingResistance,
  SpinFriction,
  MeetBox,  ///< contact searches of a ball and a shape; in the order of ShapeKind
  MeetCylinder,
  MeetSphere,
  MeetHalfSpace,
  MeetMoving,  ///< those of them with a body that moves
  BroadPhase,  ///< of balls
  PairSearch,  ///< two balls
  PaddleMotion,
  Count
};

inline Law meetingLaw(ShapeKind kind)
{
  return static_cast<Law>(static_cast<int>(Law::MeetBox) + static_cast<int>(kind));
}

#ifdef PING_PONG_SIM_COUNT
inline std::array<long, static_cast<std::size_t>(Law::Count)> evaluations{};

inline void count(Law law, long times = 1)
{
  evaluations[static_cast<std::size_t>(law)] += times;
}
#else
inline void count(Law, long = 1) {}
#endif
}  // namespace ping_pong
