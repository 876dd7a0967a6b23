// Scenes from YAML and bodies from URDF. The only rooms that read files.
#pragma once

#include <stdexcept>
#include <string>

#include "ping_pong_sim/scene.h"

namespace ping_pong
{
/// Bad input: what() is one line "FILE:LINE: KEY: VALUE: expected ...".
class LoadError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Of Scene::tolerance [m]. Below, rounding is larger; above, it would not mean much.
constexpr double kMinTolerance = 1e-12, kMaxTolerance = 0.1;

constexpr std::size_t kMaxBalls = 100000;  ///< that a scene file may hold

constexpr std::size_t kMaxThreads = 64;  ///< that may share a scene

struct LoadOptions
{
  std::uint64_t seed = 0;  ///< of the scene's random patterns
  bool has_seed = false;   ///< false: the scene's own
  std::size_t balls = 0;   ///< of the scene's one random pattern, up to kMaxBalls; 0: the scene's own
};

/// Reads and checks a scene. URDF paths are relative to the scene file. Throws LoadError.
Scene loadScene(const std::string& path, const LoadOptions& options = {});

/// Shapes of a one-link URDF file in its link frame. The material of a shape is the name of its <collision>,
/// or the name of the link if it has none; names not yet in `materials` are appended. Throws LoadError.
std::vector<Shape> loadShapes(const std::string& urdf_path, std::vector<std::string>& materials);
}  // namespace ping_pong
