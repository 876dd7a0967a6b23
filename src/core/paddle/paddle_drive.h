// A paddle's drive: from a command and limits to one smooth motion, and how static bodies stop it.
#pragma once

#include <vector>

#include "ping_pong_sim/body.h"

namespace ping_pong
{
/// Motion over [0, h] that follows the command as far as the limits allow: constant linear acceleration, rotation vector
/// quadratic in time. `from` is where the paddle is and how it moves.
/// Mode::Pose is a discrete stopping curve: at the end of each h the largest speed from which it can still stop at the target.
/// @param command  in Mode::Pose the target at s = 0; it moves on with command.twist
BodyMotion followCommand(const PaddleCommand& command, const DriveLimits& limits, const BodyMotion& from, double start,
                         double h);

/// A static body, ready for tests against paddles.
struct Obstacle
{
  const std::vector<Shape>* shapes = nullptr;
  Pose pose;
};

struct BlockedMotion
{
  BodyMotion motion;
  double duration = 0.0;  ///< the motion is free of the obstacles for so long [s], at most h
  bool blocked = false;   ///< an obstacle changed it
};

/// A shape of the body and one of an obstacle.
struct ShapePair
{
  const Shape* mine;
  const Shape* other;
  Pose X_WO;  ///< of the obstacle
};

/// Cuts and bends a motion so that the body does not enter the obstacles: it stops at their surface and slides along it.
/// @param near  room for the pairs within reach; keeps its memory from call to call, one place for each pair is enough
BlockedMotion stopAtObstacles(const std::vector<Shape>& shapes, const BodyMotion& motion, double h,
                              const std::vector<Obstacle>& obstacles, std::vector<ShapePair>& near);
}  // namespace ping_pong
