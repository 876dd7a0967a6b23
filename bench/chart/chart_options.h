// Command line of `chart`.
#pragma once

#include <optional>
#include <string>

#include "point.h"

namespace ping_pong::bench
{
struct ChartOptions
{
  std::string out;                 ///< folder of the results
  std::string only, engine;        ///< only this scene, this engine; empty: all
  std::string commit = "unknown";  ///< what the results say they come from
  bool list = false;               ///< names of scenes and engines instead
  Effort effort;
  std::optional<std::string> help;  ///< asked for: nothing else counts
};

/// Throws UsageError.
ChartOptions chartOptions(int argc, char** argv);
}  // namespace ping_pong::bench
