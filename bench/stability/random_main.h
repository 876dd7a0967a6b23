// The program's way with random scenes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ping_pong_sim/scene.h"
#include "random_report.h"

namespace ping_pong::stability
{
struct RandomOptions
{
  std::uint64_t count = 1000, seed = 1, first = 0;
  Method method = Method::Exact;
  double dt = 1e-3;        ///< longest step of methods with steps [s]
  double patience = 10.0;  ///< with one scene [s]
  unsigned processes = 1;
  std::string dump;  ///< folder for the first scene as files; empty: none
};

/// "--random N" and what follows. Throws std::invalid_argument.
RandomOptions randomOptions(const std::vector<std::string>& arguments);

/// Runs and judges them; failing scenes in order on stdout if wanted, progress on a terminal.
RandomReport runRandom(const RandomOptions& options, bool print_failures);

/// The whole command: 0 if all is right, 1 if not, 2 for wrong arguments.
int randomMain(const std::vector<std::string>& arguments);

/// random.csv: few scenes with every method.
void writeRandom(std::ostream& out);
}  // namespace ping_pong::stability
