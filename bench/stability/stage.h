// A stage: bodies around a place where a ball may come into trouble, in a frame of its own with z up.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "dice.h"
#include "ping_pong_sim/body.h"

namespace ping_pong::stability
{
struct ShapeName
{
  std::size_t body = 0;
  std::size_t shape = 0;
};

struct TimedCommand
{
  double time = 0.0;  ///< it is given at the first tick from then on [s]
  std::size_t body = 0;
  PaddleCommand command;
};

struct Stage
{
  std::vector<Body> bodies;            ///< materials are drawn later
  std::vector<Body> whole;             ///< the same without seams, if there are any: a ball must not notice
  std::vector<ShapeName> feature;      ///< what touches a ball that is in the middle of the trouble
  Vector3d target = Vector3d::Zero();  ///< there, for the centre of a ball [m]
  Vector3d low = Vector3d::Zero();     ///< a ball starts over a place between
  Vector3d high = Vector3d::Zero();    ///< these two [m]
  double tilt = 0.3;                   ///< the most that it leans [rad]
  double most_friction = kNoLimit;     ///< beyond that a ball may jam between bodies that move against each other
  std::vector<TimedCommand> commands;

  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();

  std::size_t addBody(const std::string& name, BodyKind kind, const Pose& pose = Pose());
  /// A shape with this pose in the frame of the stage.
  ShapeName add(std::size_t body, Shape shape, const Pose& pose);
  /// From corner to corner, before it is moved by `then`.
  ShapeName addBox(std::size_t body, const Vector3d& from, const Vector3d& to, const Pose& then = Pose());
  ShapeName addFloor(double height);
};

/// Turned by an angle about a line through this point; exactly nothing for an angle of zero.
Pose turnedAbout(const Vector3d& point, const Vector3d& axis, double angle);

struct StageKind
{
  const char* name;
  Stage (*make)(Dice&);
};

/// The categories. None is ever taken out or moved: a scene is known by its number.
const std::vector<StageKind>& stageKinds();
}  // namespace ping_pong::stability
