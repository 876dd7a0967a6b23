// The program's way with random scenes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>

#include "apps/progress.h"
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
  unsigned processes = std::max(1u, std::thread::hardware_concurrency());
  std::string dump;  ///< folder for the first scene as files; empty: none
};

/// Whom a run tells.
struct RandomListener
{
  std::function<void(const std::string& line)> fails;         ///< a scene, in the order of their numbers
  std::function<void(double part, std::size_t failed)> done;  ///< so much of the run, so many of its scenes
};

/// Runs and judges them.
RandomReport runRandom(const RandomOptions& options, const RandomListener& listener);

/// The whole command, with failing scenes on standard output: 0 if all is right, 1 if not, 2 if nothing can be dumped.
int randomMain(const RandomOptions& options);

/// random.csv: few scenes with every method.
void writeRandom(std::ostream& out, const PartDone& done);
}  // namespace ping_pong::stability
