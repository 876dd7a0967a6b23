// What random scenes draw: a little more than core/random.h has.
#pragma once

#include <cmath>

#include "base/random.h"

namespace ping_pong::stability
{
class Dice : public Random
{
public:
  using Random::Random;

  bool chance(double part) { return uniform(0.0, 1.0) < part; }
  /// 0 to count - 1.
  int pick(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
  /// As often in each decade; lo > 0.
  double log(double lo, double hi) { return lo * std::pow(hi / lo, uniform(0.0, 1.0)); }
  /// Either sign.
  double symmetric(double size) { return uniform(-size, size); }
};
}  // namespace ping_pong::stability
