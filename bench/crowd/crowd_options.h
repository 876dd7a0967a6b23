// Command line of `crowd`.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ping_pong::bench
{
struct CrowdOptions
{
  std::string out, commit = "unknown";
  std::vector<std::string> scenes;  // none: all
  std::string variant;              // of ours, only this one; empty: all, and others
  double balls = 0.0;               // only this number; 0: a row of them
  int rounds = 8;
  bool quick = false;
  bool companion = false;           // `exact` beside another world, too; runs with near and with far processors apart
  std::optional<std::string> help;  // asked for: nothing else counts
};

/// Throws UsageError.
CrowdOptions crowdOptions(int argc, char** argv);
}  // namespace ping_pong::bench
