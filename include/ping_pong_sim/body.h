// Bodies: static furniture (which a person may still move) and kinematic paddles (infinitely heavy, they follow commands).
#pragma once

#include <string>
#include <vector>

#include "ping_pong_sim/motion.h"
#include "ping_pong_sim/shape.h"

namespace ping_pong
{
enum class BodyKind
{
  Static,
  Kinematic
};

/// What a paddle's drive can do. All > 0; infinity is allowed.
struct DriveLimits
{
  double speed = 30.0;                   ///< [m/s]
  double acceleration = 500.0;           ///< [m/s^2]
  double angular_speed = 60.0;           ///< [rad/s]
  double angular_acceleration = 5000.0;  ///< [rad/s^2]
};

struct Body
{
  std::string name;
  BodyKind kind = BodyKind::Static;
  std::vector<Shape> shapes;  ///< in the body frame
  Pose pose;                  ///< X_WB at the start of the scene
  Twist twist;  ///< (v_WB, w_WB) at the start, kept until the first command; kinematic bodies only, within limits
  DriveLimits limits;     ///< kinematic bodies only
  std::string urdf_path;  ///< file that the shapes came from; empty for the floor
};

/// What a paddle is asked to do, expressed in W. It holds until the next command.
struct PaddleCommand
{
  enum class Mode
  {
    Hold,          ///< come to rest within the limits and stay
    Acceleration,  ///< swing: a_W, alpha_W (the paper's way)
    Velocity,      ///< reach this twist within the limits
    Pose           ///< reach this pose, moving with this twist, within the limits
  };
  Mode mode = Mode::Hold;
  Pose pose;                            ///< Mode::Pose: wanted X_WP when the command is given
  Twist twist;                          ///< Mode::Velocity, Mode::Pose (the target moves on with it)
  Vector3d a_W = Vector3d::Zero();      ///< Mode::Acceleration [m/s^2]
  Vector3d alpha_W = Vector3d::Zero();  ///< Mode::Acceleration [rad/s^2]
};
}  // namespace ping_pong
