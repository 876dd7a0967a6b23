// What random scenes came to, for people and for files.
#pragma once

#include <array>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "random_checks.h"

namespace ping_pong::stability
{
/// The scenes of one category.
struct Tally
{
  std::size_t scenes = 0, failed = 0;
  std::array<std::size_t, kChecks> broken{};  ///< scenes, by check
  std::vector<double> quiet_events;           ///< per second, of those that stopped bouncing
  double deepest = 0.0;                       ///< [m]
  double gain = 0.0;

  void add(const Verdict& verdict);
};

class RandomReport
{
public:
  void add(const std::string& category, const Verdict& verdict);
  std::size_t scenes() const { return all_.scenes; }
  std::size_t failed() const { return all_.failed; }
  void print(std::ostream& out) const;
  /// Rows "method,category,scenes,check,says,broken".
  void write(std::ostream& out, const char* method) const;

private:
  std::map<std::string, Tally> of_;
  Tally all_;
};

/// One line: which scene, what it did wrong, how to see it again.
std::string failureLine(std::uint64_t seed, std::uint64_t index, const Verdict& verdict);

/// Of the scene with that number.
std::string categoryOf(std::uint64_t index);
}  // namespace ping_pong::stability
