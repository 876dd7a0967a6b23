#include "core_distance.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "processors.h"

namespace ping_pong::bench
{
namespace
{
constexpr int kTimes = 200;   // there and back, in one measurement
constexpr int kRepeats = 100;

double once(std::atomic<int>& ball)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  for (int k = 0; k < kTimes; ++k)
  {
    ball = 1;
    while (ball != 0)
    {
    }
  }
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / (2 * kTimes);
}
}  // namespace

double coreDistance()
{
  if (processors() < 2) return 0.0;
  struct alignas(128) Line
  {
    std::atomic<int> ball{0};
  } line;
  std::atomic<bool> stopping{false};
  std::thread other(
      [&]
      {
        while (!stopping)
          if (line.ball == 1) line.ball = 0;
      });
  giveProcessors();
  double least = once(line.ball);
  for (int repeat = 1; repeat < kRepeats; ++repeat) least = std::min(least, once(line.ball));
  stopping = true;
  other.join();
  takeProcessorsBack();
  return least;
}
}  // namespace ping_pong::bench
