// Which keys are held down, also where nobody says when one is let go.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <map>

#include "key_table.h"

namespace ping_pong
{
/// After how long without a repetition a key counts as released [s]. A terminal tells no release; and a window may lose
/// one, so there too nothing is held for ever.
struct HoldLimits
{
  double first = std::numeric_limits<double>::infinity();   ///< after the press
  double repeat = std::numeric_limits<double>::infinity();  ///< after a repetition
  bool together = false;  ///< a repetition counts for all keys held: only the last one repeats
};

/// For windows: releases are told, a limit is for lost ones only.
constexpr HoldLimits windowHold()
{
  return {3.0, 3.0, true};
}
/// For terminals. A keyboard repeats after about half a second and then every 30 ms: a short first limit makes a tap a
/// tap, at the price of a pause until the repetition sets in.
constexpr HoldLimits terminalHold()
{
  return {0.25, 0.15, false};
}

/// What the keys held together ask for, from -1 to 1 along and about each axis of the viewer: 0 away, 1 left, 2 up.
struct Wish
{
  Eigen::Vector3d move = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  bool isZero() const { return move.isZero(0.0) && turn.isZero(0.0); }
};

class HeldKeys
{
public:
  explicit HeldKeys(const HoldLimits& limits) : limits_(limits) {}

  /// Also for repetitions. @param now  any clock that runs forward [s]
  void press(Key key, double now);
  void release(Key key) { until_.erase(key); }
  void releaseAll() { until_.clear(); }
  /// Lets go of keys whose time is over.
  void expire(double now);

  bool any() const { return !until_.empty(); }
  Wish wish() const;

private:
  HoldLimits limits_;
  std::map<Key, double> until_;  ///< [s]
};
}  // namespace ping_pong
