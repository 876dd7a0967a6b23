#include "time_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace ping_pong::bench
{
namespace
{
using Clock = std::chrono::steady_clock;

// Time of one run from the start to the end of the scene [s]. Making the engine is not part of it.
double runTime(const ChartScene& chart, const Start& start, const Point& point)
{
  const std::unique_ptr<Engine> engine = point.engine->make(start.scene, point.variant, point.step);
  for (const Drive& drive : start.drives) engine->drive(drive.body, drive.twist);
  const Clock::time_point begin = Clock::now();
  engine->advance(chart.duration);
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

double median(std::vector<double>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Every repeat does the same runs. Of each start counts the median: now and then the machine has something else to do.
double repeat(const ChartScene& chart, const std::vector<Start>& starts, const Point& point, long runs)
{
  std::vector<std::vector<double>> times(std::min(starts.size(), static_cast<std::size_t>(runs)));
  for (std::size_t i = 0; i < static_cast<std::size_t>(runs); ++i)
    times[i % times.size()].push_back(runTime(chart, starts[i % times.size()], point));
  double sum = 0.0;
  for (std::vector<double>& of_start : times) sum += median(of_start);
  return sum / static_cast<double>(times.size());
}

// Runs that fill a repeat: after one to warm up, as many as it takes.
long runsPerRepeat(const ChartScene& chart, const std::vector<Start>& starts, const Point& point, double time)
{
  const double first = runTime(chart, starts[0], point);
  if (first > time) return 1;
  const double warm = repeat(chart, starts, point, std::min(10L, std::lround(time / first) + 1));
  return std::max(1L, std::lround(std::ceil(time / warm)));
}
}  // namespace

std::vector<Cost> measureCosts(const ChartScene& chart, const std::vector<Start>& starts,
                               const std::vector<Point>& points, const Effort& effort, const PartDone& done)
{
  std::vector<long> runs;
  for (const Point& point : points) runs.push_back(runsPerRepeat(chart, starts, point, effort.repeat_time));
  std::vector<std::vector<double>> times(points.size());
  for (int k = 0; k < effort.repeats; ++k)
  {
    for (std::size_t i = 0; i < points.size(); ++i) times[i].push_back(repeat(chart, starts, points[i], runs[i]));
    done((k + 1.0) / effort.repeats);
  }
  std::vector<Cost> costs;
  const double unit = chart.duration * static_cast<double>(starts[0].scene.balls.size());
  for (std::vector<double>& of_point : times)
  {
    const double least = *std::min_element(of_point.begin(), of_point.end());
    costs.push_back({least / unit, median(of_point) / unit});
  }
  return costs;
}
}  // namespace ping_pong::bench
