// Command line of `simulate`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "command_line.h"
#include "ping_pong_sim/scene.h"

namespace ping_pong
{
struct SimulateOptions
{
  std::string scene_path;
  double duration = 0.0;               ///< required [s]
  double rate = 100.0;                 ///< rows per simulated second and ball [Hz]
  std::optional<Method> method;        ///< instead of the scene's
  std::optional<double> dt;            ///< instead of the scene's [s]
  std::optional<double> tolerance;     ///< instead of the scene's [m]
  std::optional<std::uint64_t> seed;   ///< instead of the scene's
  std::optional<std::size_t> balls;    ///< of the random pattern, instead of the scene's
  std::optional<std::size_t> threads;  ///< instead of the scene's
  std::string contacts_path;           ///< empty: contacts are not written
  std::string commands_path;           ///< empty: paddles have no commands
  std::optional<std::string> help;     ///< asked for: nothing else counts
};

/// Throws UsageError.
SimulateOptions parseSimulateOptions(int argc, char** argv);
}  // namespace ping_pong
