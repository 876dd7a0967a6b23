// The paddle of a player: its two faces with their contact laws, and where it is clear of table and ball.
#pragma once

#include "court.h"

namespace ping_pong::play
{
enum class Face
{
  Forehand,  ///< x out of it
  Backhand   ///< -x out of it
};

class Blade
{
public:
  /// Throws std::invalid_argument if the scene has no kinematic body of that name, or it has no round blade (cylinders along its x).
  Blade(const Scene& scene, const std::string& paddle, const BallParams& ball);

  const Surface& law(Face face) const { return face == Face::Forehand ? forehand_ : backhand_; }
  const DriveLimits& limits() const { return limits_; }
  /// From the blade's centre to the centre of a ball that touches the face [m].
  double reach(Face face) const { return (face == Face::Forehand ? front_ : back_) + ball_radius_; }
  double radius() const { return radius_; }  ///< of the blade [m]

  /// Attitude with this normal out of the striking face, and the handle level: towards the middle of the body, forehand strokes on the right
  /// (y < 0) with the tip to the right, backhand strokes with the tip to the left.
  Quaterniond attitude(const Vector3d& n, Face face) const;

  /// Surely clear of table and net by `margin`: above the playing surface, or before the end line, or beside the table; never over the net.
  bool clearOfTable(const Pose& pose, const Court& court, double margin) const;
  /// It stays clear of the table if it now brakes with this acceleration [m/s^2].
  bool stopsBeforeTable(const Pose& pose, const Vector3d& v, double acceleration, const Court& court,
                        double margin) const;
  /// The ball's surface is farther than `margin` from blade and handle, roughly.
  bool clearOfBall(const Pose& pose, const Vector3d& ball, double margin) const;

private:
  double extent(const Pose& pose, const Vector3d& n) const;

  std::vector<Shape> shapes_;
  Surface forehand_, backhand_;
  DriveLimits limits_;
  double front_ = 0.0, back_ = 0.0, radius_ = 0.0, ball_radius_;
};
}  // namespace ping_pong::play
