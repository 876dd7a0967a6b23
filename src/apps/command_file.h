// Paddle commands from a CSV file. config/commands/README.md describes it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ping_pong_sim/body.h"

namespace ping_pong
{
struct TimedCommand
{
  double time = 0.0;     ///< since the start of the scene [s]
  std::size_t body = 0;  ///< index in the scene
  PaddleCommand command;
};

/// Reads and checks the whole file: what it returns is in order of time, and the world refuses none of it. Throws LoadError
/// "FILE:LINE: COLUMN: VALUE: expected ...".
std::vector<TimedCommand> readCommands(const std::string& path, const std::vector<Body>& bodies);
}  // namespace ping_pong
