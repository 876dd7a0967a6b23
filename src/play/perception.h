// How a player sees the ball: late, now and then, and with errors, as its level says.
#pragma once

#include <vector>

#include "base/random.h"
#include "level.h"
#include "prediction.h"

namespace ping_pong::play
{
class Perception
{
public:
  Perception(const LevelTraits& level, std::uint64_t seed);

  /// The ball as it is now. Nobody but this class knows it before the reaction time is over.
  void see(double time, const BallState& state);
  /// The newest look there is by now; false if none has been added since the last one.
  bool look(double now, PathSample& seen);
  /// One's own toss is felt, not seen: no delay, no errors from now on, or again both.
  void feel(bool feel) { feels_ = feel; }
  bool exact() const { return feels_ || (level_.see_place == 0.0 && level_.see_velocity == 0.0); }
  /// The opponent has struck: the spin is misread anew.
  void readSpinAnew();
  /// Another ball.
  void forget();

private:
  LevelTraits level_;
  Random random_;
  std::vector<PathSample> ring_;  // what there was to see
  std::size_t first_ = 0, count_ = 0;
  double looked_ = -1e9;  // time of the last look's state [s]
  double misreading_ = 0.0;
  bool feels_ = false;
};
}  // namespace ping_pong::play
