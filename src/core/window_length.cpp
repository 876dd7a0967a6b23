#include "window_length.h"

#include <algorithm>
#include <cmath>

#include "world_state.h"

namespace ping_pong
{
namespace
{
// Searches of pairs, by ball and window:
constexpr double kMany = 2.0;        // halve the window
constexpr double kFew = 0.7;         // double it
constexpr double kNobodyNear = 64.0; // times longer, if no two boxes overlapped

constexpr double kLongestFirst = 1.0;  // [s]
constexpr double kLeastRoom = 0.05;    // between neighbours at first, in diameters

// Until a ball has come so far, at this speed and acceleration.
double timeFor(double way, double v, double a)
{
  return 2.0 * way / (v + std::sqrt(v * v + 2.0 * a * way) + 1e-9);
}
}  // namespace

void WindowLength::estimate(const WorldState& world)
{
  const double n = std::max(static_cast<double>(world.balls.size()), 1.0);
  Box centres;
  double diameters = 0.0, squared_speeds = 0.0;
  for (const BallRecord& ball : world.balls)
  {
    const BallState state = ball.stateAt(world.time);
    centres.add({state.p_WB, state.p_WB});
    diameters += 2.0 * ball.params.radius;
    squared_speeds += state.v_WB.squaredNorm();
  }
  const double diameter = diameters / n;
  const double spacing = std::cbrt((centres.high - centres.low).array().max(diameter).prod() / n);
  const double room = std::max(spacing - diameter, kLeastRoom * diameter);
  const double time = timeFor(room, std::sqrt(squared_speeds / n), world.scene.forces.gravity.norm());
  length_ = lasted_ = std::clamp(time, kShortest, kLongestFirst);
}

// In the middle, in ratios, between what lasted and what did not; half of it at most.
void WindowLength::tooLong(double tried)
{
  length_ = std::max(std::min(0.5 * tried, std::sqrt(tried * lasted_)), kShortest);
}

void WindowLength::done(double length, double searches, bool as_wished)
{
  lasted_ = length;
  if (searches > kMany)
    length_ = std::max(0.5 * std::min(length_, length), kShortest);
  else if (searches < kFew && (as_wished || length >= length_))
    length_ *= searches == 0.0 ? kNobodyNear : 2.0;
}
}  // namespace ping_pong
