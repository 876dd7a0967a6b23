// Command line of `stability`.
#pragma once

#include <optional>
#include <string>

#include "random_main.h"

namespace ping_pong::stability
{
struct Options
{
  std::string directory;  ///< of the CSV files; empty: random scenes instead
  RandomOptions random;
  std::optional<std::string> help;  ///< asked for: nothing else counts
};

/// Throws UsageError.
Options optionsFrom(int argc, char** argv);
}  // namespace ping_pong::stability
