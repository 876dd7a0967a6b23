#include "core_distance.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <thread>

#include "processors.h"

namespace ping_pong::bench
{
namespace
{
constexpr int kTimes = 200;  // there and back, in one measurement
constexpr int kRepeats = 100;

/// A thread that plays a line of the cache back, until this ends.
class Partner
{
public:
  Partner() : thread_([this] { live(); }) {}
  ~Partner()
  {
    stopping_ = true;
    thread_.join();
  }
  /// How long the line is on its way [ns].
  double once()
  {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    for (int k = 0; k < kTimes; ++k)
    {
      ball_ = 1;
      while (ball_ != 0)
      {
      }
    }
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / (2 * kTimes);
  }

private:
  void live()
  {
    while (!stopping_)
      if (ball_ == 1) ball_ = 0;
  }

  alignas(128) std::atomic<int> ball_{0};
  alignas(128) std::atomic<bool> stopping_{false};
  std::thread thread_;
};
}  // namespace

double coreDistance()
{
  if (processors() < 2) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  {
    Partner partner;
    giveProcessors();
    for (int repeat = 0; repeat < kRepeats; ++repeat) least = std::min(least, partner.once());
  }
  takeProcessorsBack();
  return least;
}
}  // namespace ping_pong::bench
