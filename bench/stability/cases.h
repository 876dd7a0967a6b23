// The rows of the stability map: each situation with the number that it is judged by.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ping_pong_sim/scene.h"

namespace ping_pong::stability
{
struct Case
{
  std::string name;                                       ///< one word, for tests and files
  std::string title;                                      ///< for people
  std::string measures;                                   ///< what the number is, with its unit
  double bound;                                           ///< the largest number that passes
  std::string reason;                                     ///< why this bound
  std::function<double(Method method, double dt)> value;  ///< infinite: never, lost or not finite

  bool passes(double number) const { return number <= bound; }
};

const std::vector<Case>& cases();

/// Throws std::out_of_range.
const Case& caseNamed(const std::string& name);
}  // namespace ping_pong::stability
