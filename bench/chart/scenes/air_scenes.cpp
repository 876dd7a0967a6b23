#include "air_scenes.h"

namespace ping_pong::bench
{
ChartScene airChart(const std::string& name, const std::string& title)
{
  ChartScene chart;
  chart.name = name;
  chart.title = title;
  chart.duration = 2.0;
  chart.sample_period = 0.1;
  chart.steps = oneTwoFive(1e-1, 1e-5);
  chart.tolerances = decades(1e-1, 1e-12);
  chart.reference = "long double, extrapolated midpoint rule of order 16, located bounces";
  return chart;
}

AirTask airTask(const ChartScene& chart, const Scene& scene, int refinement)
{
  AirTask task;
  task.scene = &scene;
  task.duration = chart.duration;
  task.sample_period = chart.sample_period;
  task.refinement = refinement;
  return task;
}
}  // namespace ping_pong::bench
