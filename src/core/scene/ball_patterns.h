// Turns what a scene file says about balls into balls: single ones, grids, random crowds. Same seed, same bits.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ping_pong_sim/scene.h"
#include "ping_pong_sim/scene_loader.h"
#include "scene/load_colors.h"
#include "scene/yaml_reader.h"

namespace ping_pong
{
/// One entry of `balls`. A single ball is a grid of one.
struct BallGroup
{
  explicit BallGroup(Field field) : where(std::move(field)) {}
  std::size_t count() const { return grid[0] * grid[1] * grid[2]; }

  Field where;  ///< what a message about overlap names
  BallParams params;
  std::vector<Color> palette = {defaultColor()};
  std::array<std::size_t, 3> grid = {1, 1, 1};
  Vector3d origin = Vector3d::Zero();  ///< first centre of a grid; lowest corner of a random box [m]
  std::uint64_t seed = 1;

  Vector3d spacing = Vector3d::Zero();   ///< grid: between centres [m]
  double jitter = 0.0;                   ///< grid: largest random shift along each axis [m]
  Vector3d velocity = Vector3d::Zero();  ///< grid: of each ball [m/s]
  Vector3d spin = Vector3d::Zero();      ///< grid: of each ball [rad/s]

  bool random = false;
  Vector3d max = Vector3d::Zero();  ///< random: highest corner of the box of centres [m]
  std::optional<Field> room;        ///< random: name of the body whose inside is the box, instead of its corners
  double random_speed = 0.0;        ///< random: speed in a random direction [m/s]
  double thermal_speed = 0.0;       ///< random: besides, each component normally distributed with this deviation [m/s]
  double random_spin = 0.0;         ///< random: spin about a random axis [rad/s]
};

/// Appends the balls to the scene. Throws LoadError if one overlaps a body or an earlier ball by more than a touch.
void placeBalls(const std::vector<BallGroup>& groups, const LoadOptions& options, Scene& scene);
}  // namespace ping_pong
