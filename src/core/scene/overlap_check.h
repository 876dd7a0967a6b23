// Does a ball at some place overlap a body or another ball?
#pragma once

#include <array>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry/tolerances.h"
#include "ping_pong_sim/body.h"

namespace ping_pong
{
struct Overlap
{
  std::string with;    ///< name of the body, or ball_N
  double depth = 0.0;  ///< [m]
};

/// Bodies at their start poses, and balls sorted into cubes of the largest diameter, so that 27 cubes hold all
/// neighbours.
class OverlapFinder
{
public:
  OverlapFinder(const std::vector<Body>& bodies, double largest_radius);

  /// Deepest overlap of a ball with anything.
  std::optional<Overlap> find(const Vector3d& p_WB, double radius) const;
  /// Whether find() has nothing to tell; quicker.
  bool free(const Vector3d& p_WB, double radius) const;
  /// Ball N is the one added N-th, from 0.
  void addBall(const Vector3d& p_WB, double radius);

private:
  struct Ball
  {
    Vector3d p_WB;
    double radius;
  };
  using Cube = std::array<double, 3>;
  struct CubeHash
  {
    std::size_t operator()(const Cube& cube) const;
  };

  Cube cubeOf(const Vector3d& p_WB) const;
  template <class Action>
  bool anyNear(const Vector3d& p_WB, const Action& action) const;
  void findBodies(const Vector3d& p_WB, double radius, std::optional<Overlap>& deepest) const;
  void findBalls(const Vector3d& p_WB, double radius, std::optional<Overlap>& deepest) const;

  const std::vector<Body>& bodies_;
  double cube_size_;  ///< [m]
  std::vector<Ball> balls_;
  std::unordered_map<Cube, std::vector<std::size_t>, CubeHash> cubes_;
};
}  // namespace ping_pong
