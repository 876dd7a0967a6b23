// What the event loop tells of the balls that it moves.
#pragma once

#include <cstddef>

#include "geometry/aabb.h"

namespace ping_pong
{
class FlightLog
{
public:
  /// Ball i is about to leave its path at time t [s].
  virtual void leavesPath(std::size_t i, double t) = 0;
  /// It has flown several paths at once until time t, of which no more is known than that they were in this box. One path has been
  /// told before.
  virtual void flewInBox(std::size_t i, const Box& box, double t) = 0;
  /// Balls i and k have hit each other.
  virtual void met(std::size_t i, std::size_t k) = 0;

protected:
  ~FlightLog() = default;
};
}  // namespace ping_pong
