// A smooth path of the racket through waypoints, as the accelerations of ticks.
#pragma once

#include <array>

#include "ping_pong_sim/body.h"

namespace ping_pong::play
{
/// Where to be at a time, and how fast.
struct Waypoint
{
  double time = 0.0;              ///< [s]
  Vector3d p = Vector3d::Zero();  ///< [m]
  Vector3d v = Vector3d::Zero();  ///< [m/s]
};

/// Acceleration of the next tick on the way to (p, v) in time_left: of all accelerations that are constant in each tick and meet both,
/// the one with the least integral of its square (it falls linearly from tick to tick, as on a cubic). Asked anew in every tick it
/// gives the same path, and leads back to the goal what has been put off it. In the last tick only the velocity is met.
/// @param way   still to go [m] or [rad]
/// @param v, v_goal  velocities now and then
/// @param tick  length of the ticks [s]; the last one is cut at the goal
Vector3d nextAcceleration(const Vector3d& way, const Vector3d& v, const Vector3d& v_goal, double time_left,
                          double tick);

/// Whether the cubic from (p, v) at `time` to the waypoint keeps within both.
bool withinLimits(const Vector3d& p, const Vector3d& v, double time, const Waypoint& goal, double speed,
                  double acceleration);
struct PathPoint
{
  Vector3d p, v;  ///< [m], [m/s]
};

/// A point of that cubic.
PathPoint onCubic(const Vector3d& p, const Vector3d& v, double time, const Waypoint& goal, double at);

/// Least time for a cubic from rest to rest over this way.
double restToRest(double way, double speed, double acceleration);

/// Stroke: to `start` at rest, from there on a straight line with constant acceleration through `hit`, to rest in `end`.
struct RacketPath
{
  Waypoint start, hit, end;
  Quaterniond attitude = Quaterniond::Identity();  ///< X_OP from start to end
  bool direct = false;                             ///< no time for a start: at once to the hit

  const Waypoint& next(double time, double tick) const;
  double over() const { return end.time; }
};

/// Moves a paddle for one tick, within limits whatever is asked.
class RacketDrive
{
public:
  explicit RacketDrive(const DriveLimits& limits) : limits_(limits) {}

  /// Linear and angular acceleration of the next tick.
  /// @param turned_at  time at which the attitude shall be there [s]
  PaddleCommand command(const Pose& pose, const Twist& twist, double time, double tick, const Waypoint& goal,
                        const Quaterniond& attitude, double turned_at) const;
  const DriveLimits& limits() const { return limits_; }

private:
  DriveLimits limits_;
};

/// Rotation that takes `from` to `to`, the short way [rad].
Vector3d rotationBetween(const Quaterniond& from, const Quaterniond& to);
}  // namespace ping_pong::play
