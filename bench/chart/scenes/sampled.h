// What scenes of the chart share.
#pragma once

#include <cmath>

#include "chart_scene.h"

namespace ping_pong::bench
{
/// The states that at(t) gives at the chart's sample times.
template <class StateAt>
std::vector<TrueState> sampled(const ChartScene& chart, const StateAt& at)
{
  std::vector<TrueState> samples;
  for (long i = 1; i <= std::lround(chart.duration / chart.sample_period); ++i)
    samples.push_back(at(static_cast<Real>(i) * chart.sample_period));
  return samples;
}

/// The chart with this way to make starts: make(chart, n, refinement).
template <class MakeStart>
ChartScene withStarts(ChartScene chart, const MakeStart& make)
{
  const ChartScene copy = chart;
  chart.start = [copy, make](int n, int refinement) { return make(copy, n, refinement); };
  return chart;
}
}  // namespace ping_pong::bench
