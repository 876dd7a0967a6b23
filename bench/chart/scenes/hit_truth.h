// The truth about one hit by a box that moves and turns steadily, in long double. It shares no code with the library.
#pragma once

#include <optional>

#include "chart_scene.h"

namespace ping_pong::bench
{
struct HitTask
{
  BallParams ball;
  TrueState start;
  Real g = 0.0L;  ///< downwards [m/s^2]
  Real restitution = 1.0L, friction = 0.0L;
  Vector3r half_size = Vector3r::Zero();  ///< of the box [m]
  Vector3r p = Vector3r::Zero();          ///< of its middle at the start [m]
  Eigen::Quaternion<Real> q = Eigen::Quaternion<Real>::Identity();
  Vector3r v = Vector3r::Zero(), w = Vector3r::Zero();  ///< its twist [m/s], [rad/s]
  double duration = 0.0, sample_period = 0.0;           ///< [s]
};

/// Nothing unless the ball is hit exactly once.
std::optional<TruePath> hitTruth(const HitTask& task);
}  // namespace ping_pong::bench
