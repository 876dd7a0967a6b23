// Measures errors of one point over all starts. Nothing is timed for the chart here.
#pragma once

#include <optional>

#include "chart/scenes/chart_scene.h"
#include "point.h"

namespace ping_pong::bench
{
/// Nothing if it takes longer than `most` [s].
std::optional<Errors> measureErrors(const ChartScene& chart, const std::vector<Start>& starts, const Point& point,
                                    double most);

/// Largest distance between the truth and the truth by half the step, over some starts [m].
double referenceError(const ChartScene& chart, const std::vector<Start>& starts);
}  // namespace ping_pong::bench
