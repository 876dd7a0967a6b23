// How long the windows and lookaheads of islands.h are: long ones have many balls near each other and make large islands, in which
// each looks at each; short ones cost a grid each. The work is counted, not timed, so that a scene goes the same way every time:
// lengths go up while that makes the work of a second less, else down.
#pragma once

#include <cstddef>

namespace ping_pong
{
struct WorldState;

/// What has been done in a window, by ball; what was done in vain counts, too.
struct WindowWork
{
  double near_pairs;     ///< of balls whose boxes overlapped
  double pair_searches;  ///< in islands
  double events;
};

class WindowLength
{
public:
  static constexpr double kShortest = 1e-4;  // [s]

  /// Until balls come to their neighbours, if they were evenly spread, roughly.
  void estimate(const WorldState& world);
  /// Of the next window [s].
  double next() const { return length_; }
  /// Of windows that share so long a time [s]: more if too much happens for one.
  double countIn(double time) const;

  /// A window of this length was not worth its work; nothing of it was done [s].
  void tooLong(double tried);
  /// A window of this length was done [s].
  void done(double length, const WindowWork& work);
  /// As many balls had an event in a window of this length [s].
  void busy(double length, std::size_t balls) { busy_ = static_cast<double>(balls) / length; }
  /// It had to end after this time, whatever its length should have been [s].
  void cutTo(double length);

private:
  double length_ = 1.0;
  double lasted_ = 1.0;  // length of the last window that was done
  double busy_ = 0.0;    // balls with an event in it, by second
  double rate_ = 0.0;    // of its work
  bool longer_ = true;   // where the search goes
};
}  // namespace ping_pong
