// Command line of `simulate`.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "ping_pong_sim/scene.h"

namespace ping_pong
{
/// Bad command line; what() is one line.
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

struct SimulateOptions
{
  std::string scene_path;
  std::optional<double> duration;      ///< required [s]
  double rate = 100.0;                 ///< rows per simulated second and ball [Hz]
  std::optional<Method> method;        ///< instead of the scene's
  std::optional<double> dt;            ///< instead of the scene's [s]
  std::optional<double> tolerance;     ///< instead of the scene's [m]
  std::optional<std::uint64_t> seed;   ///< instead of the scene's
  std::optional<std::size_t> balls;    ///< of the random pattern, instead of the scene's
  std::optional<std::size_t> threads;  ///< instead of the scene's
  std::string contacts_path;           ///< empty: contacts are not written
  std::string commands_path;           ///< empty: paddles have no commands
  bool help = false;
};

extern const std::string kSimulateHelp;

/// Throws UsageError.
SimulateOptions parseSimulateOptions(int argc, char** argv);
}  // namespace ping_pong
