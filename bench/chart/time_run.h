// Times points of one scene: only Engine::advance, one call for the whole duration, no output.
#pragma once

#include "apps/progress.h"
#include "chart/scenes/chart_scene.h"
#include "point.h"

namespace ping_pong::bench
{
struct Cost
{
  double least = 0.0;  ///< of all repeats, per ball and simulated second [s]
  double median = 0.0;
};

/// The points take turns, so that a busy moment of the machine does not fall on one of them alone.
std::vector<Cost> measureCosts(const ChartScene& chart, const std::vector<Start>& starts,
                               const std::vector<Point>& points, const Effort& effort, const PartDone& done);
}  // namespace ping_pong::bench
