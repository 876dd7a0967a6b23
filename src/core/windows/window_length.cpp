#include "windows/window_length.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "state/world_state.h"

namespace ping_pong
{
namespace
{
// Work, in parts of what sorting a ball into the grid and looking into cells costs:
constexpr double kNearWork = 0.4;  // two balls whose boxes overlap
constexpr double kSearchWork = 1.0;
constexpr double kEventWork = 7.0;

constexpr double kStep = 1.12;  // between lengths that are compared: smaller finds the best more closely, larger sooner
constexpr double kCut = 0.5;    // as much shorter than it should have been tells nothing of a length
constexpr double kNobodyNear = 64.0;  // times longer, if no two boxes overlapped: one that is too long costs one window

constexpr double kShare = 0.8;        // of the windows that would fit into a time: rather a bit longer than one more
constexpr double kMostBusy = 4096.0;  // balls with an event in a window: more are a long way through memory

constexpr double kLongestFirst = 1.0;  // [s]: more than a ball flies over a table
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
    diameters += 2.0 * ball.params().radius;
    squared_speeds += state.v_WB.squaredNorm();
  }
  const double diameter = diameters / n;
  const double spacing = std::cbrt((centres.high - centres.low).array().max(diameter).prod() / n);
  const double room = std::max(spacing - diameter, kLeastRoom * diameter);
  const double time = timeFor(room, std::sqrt(squared_speeds / n), world.scene.forces.gravity.norm());
  length_ = lasted_ = std::clamp(time, kShortest, kLongestFirst);
  busy_ = 0.0;
  rate_ = std::numeric_limits<double>::infinity();
  longer_ = true;
}

double WindowLength::countIn(double time) const
{
  return std::ceil(std::max(kShare * time / length_, busy_ * time / kMostBusy));
}

// In the middle, in ratios, between what lasted and what did not; half of it at most.
void WindowLength::tooLong(double tried)
{
  length_ = std::max(std::min(0.5 * tried, std::sqrt(tried * lasted_)), kShortest);
  longer_ = false;
  rate_ = std::numeric_limits<double>::infinity();
}

void WindowLength::done(double length, const WindowWork& work)
{
  lasted_ = length;
  if (length < kCut * length_) return;
  if (work.near_pairs == 0.0)
  {
    length_ *= kNobodyNear;
    return;
  }
  const double rate =
      (1.0 + kNearWork * work.near_pairs + kSearchWork * work.pair_searches + kEventWork * work.events) / length;
  if (rate > rate_) longer_ = !longer_;
  rate_ = rate;
  length_ = std::max(longer_ ? length_ * kStep : length_ / kStep, kShortest);
}

void WindowLength::cutTo(double length)
{
  lasted_ = length_ = length;
}
}  // namespace ping_pong
