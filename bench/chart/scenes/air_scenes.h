// What scenes with air share.
#pragma once

#include "air_truth.h"

namespace ping_pong::bench
{
/// Two seconds; steps, tolerances, reference.
ChartScene airChart(const std::string& name, const std::string& title);

AirTask airTask(const ChartScene& chart, const Scene& scene, int refinement);
}  // namespace ping_pong::bench
