// What was measured, as CSV.
#pragma once

#include <string>
#include <vector>

#include "chart/scenes/chart_scene.h"
#include "point.h"
#include "time_run.h"

namespace ping_pong::bench
{
struct Row
{
  Point point;
  std::string refusal;  ///< why it was not measured; empty if it was
  Errors errors;
  Cost cost;
};

struct Provenance
{
  std::string commit, machine, compiler;
};

/// This machine and compiler.
Provenance provenance(const std::string& commit);

/// Writes DIRECTORY/SCENE.csv; throws std::runtime_error if it cannot.
void writeResults(const std::string& directory, const ChartScene& chart, double reference_error,
                  const Provenance& provenance, const std::vector<Row>& rows);
}  // namespace ping_pong::bench
