// The racket's way to a stroke: swing, hit, follow-through, within its limits, clear of the table and not in the ball's way.
#pragma once

#include "blade.h"
#include "prediction.h"
#include "racket_path.h"
#include "stroke_inversion.h"

namespace ping_pong::play
{
/// Part of a racket's limits that is planned with; the rest is for ticks that straddle a waypoint.
constexpr double kSpare = 0.9;

/// What a hand does wrong in one stroke; all zero: nothing.
struct StrokeError
{
  Vector3d place = Vector3d::Zero();  ///< of the racket [m]
  double pitch = 0.0, yaw = 0.0;      ///< of the face [rad]
  double speed = 0.0;                 ///< part of the racket's speed
};

/// Where and when a racket is.
struct RacketNow
{
  double time = 0.0;
  Pose pose;    ///< frame O
  Twist twist;  ///< frame O
};

/// Where the blade's centre may be, frame O: what a quick player reaches.
class Reach
{
public:
  explicit Reach(const Court& court);
  bool holds(const Vector3d& p) const;

private:
  Vector3d low_, high_;
};

/// What the racket shall do at the hit.
struct StrokeTarget
{
  double time = 0.0;                 ///< [s]
  Vector3d ball = Vector3d::Zero();  ///< centre, then [m]
  Face face = Face::Forehand;
  RacketImpact impact;
};

class StrokePaths
{
public:
  StrokePaths(const Court& court, const Blade& blade, const DriveLimits& limits);

  /// The path with the longest swing that can be had.
  /// @param work  goes down by kWorkOfAPath for each path that is looked at, in flights (see Flyer)
  bool lay(const StrokeTarget& target, const StrokeError& error, const Prediction& prediction, const RacketNow& now,
           int& work, RacketPath& path) const;

private:
  bool layFor(double swing, double follow, const Prediction& prediction, const RacketNow& now, RacketPath& path) const;
  bool clear(const RacketPath& path, const Prediction& prediction, const RacketNow& now) const;
  bool clearApproach(const RacketPath& path, const Prediction& prediction, const RacketNow& now) const;

  const Court& court_;
  const Blade& blade_;
  DriveLimits limits_;
  Reach reach_;
};
}  // namespace ping_pong::play
