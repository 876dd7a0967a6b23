// How long the windows of islands.h are: long ones make large islands, in which each looks at each; short ones cost a search
// for neighbours each. The rule counts and does not measure, so that a scene goes the same way every time.
#pragma once

#include <cstddef>

namespace ping_pong
{
struct WorldState;

class WindowLength
{
public:
  static constexpr double kShortest = 1e-4;  // [s]

  /// Until balls come to their neighbours, if they were evenly spread, roughly.
  void estimate(const WorldState& world);
  /// Of the next window [s].
  double next() const { return length_; }

  /// A window of this length was not worth its work; nothing of it was done [s].
  void tooLong(double tried);
  /// A window of this length was done [s].
  /// @param searches  of pairs, by ball
  /// @param as_wished  the window was not cut short
  void done(double length, double searches, bool as_wished);

private:
  double length_ = 1.0;
  double lasted_ = 1.0;  // of the last window that was done
};
}  // namespace ping_pong
