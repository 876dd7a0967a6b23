// Measures the work-precision chart: every scene x engine x variant x step, errors and costs in separate runs.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <stdexcept>

#include "apps/command_line.h"
#include "apps/progress.h"
#include "chart_options.h"
#include "engines/our_engine.h"
#include "error_run.h"
#include "results_file.h"
#include "time_run.h"

namespace ping_pong::bench
{
namespace
{
constexpr char kTooLong[] = "takes too long";
constexpr double kPatience = 1.5;  // a point may take so many times what was expected at most

bool isDecade(double step)
{
  const double exponent = std::log10(step);
  return std::abs(exponent - std::round(exponent)) < 1e-6;
}

std::vector<Start> startsOf(const ChartScene& chart, const Effort& effort)
{
  std::vector<Start> starts;
  for (int n = 0; n < std::min(chart.starts, effort.most_starts); ++n) starts.push_back(chart.start(n, 1));
  return starts;
}

// An engine that gives up says so in the row. Methods that take a tolerance get all the time that they need: there is
// no step to blame.
std::optional<Errors> tryErrors(const ChartScene& chart, const std::vector<Start>& starts, Row& row,
                                const Effort& effort)
{
  const bool tolerance = takesTolerance(row.point.engine->name, row.point.variant);
  const double most = tolerance ? std::numeric_limits<double>::infinity() : kPatience * effort.error_budget;
  try
  {
    return measureErrors(chart, starts, row.point, most);
  }
  catch (const std::exception& error)
  {
    row.refusal = error.what();
    return std::nullopt;
  }
}

// Errors of one variant at all its steps, coarse to fine, until it takes too long. Time goes as 1 / step, about.
void measureVariant(const ChartScene& chart, const std::vector<Start>& starts, const EngineKind& engine,
                    const std::string& variant, const Effort& effort, std::vector<Row>& rows)
{
  const std::string refusal = engine.refuse(starts[0].scene, variant);
  const bool tolerance = takesTolerance(engine.name, variant);
  double expected = 0.0, last_step = 0.0;  // time of the last point [s], and its step
  for (const double step : tolerance ? chart.tolerances : chart.steps)
  {
    if (effort.decades_only && !isDecade(step)) continue;
    Row row{{&engine, variant, step}, refusal, {}, {}};
    if (!tolerance) expected *= last_step / step;
    last_step = step;
    std::optional<Errors> errors;
    if (refusal.empty() && (tolerance || expected <= effort.error_budget))
      errors = tryErrors(chart, starts, row, effort);
    if (errors) row.errors = *errors;
    if (row.refusal.empty() && !errors) row.refusal = kTooLong;
    expected = errors ? errors->seconds : std::max(expected, effort.error_budget * 1.001);
    rows.push_back(row);
    if (!row.refusal.empty() && row.refusal != kTooLong) return;
  }
}

void measureTimes(const ChartScene& chart, const std::vector<Start>& starts, const Effort& effort,
                  std::vector<Row>& rows, const PartDone& done)
{
  std::vector<Point> points;
  for (const Row& row : rows)
    if (row.refusal.empty()) points.push_back(row.point);
  const std::vector<Cost> costs = measureCosts(chart, starts, points, effort, done);
  std::size_t next = 0;
  for (Row& row : rows)
    if (row.refusal.empty()) row.cost = costs[next++];
}

std::vector<const EngineKind*> enginesOf(const ChartOptions& options)
{
  std::vector<const EngineKind*> engines;
  for (const EngineKind& engine : engineKinds())
    if (options.engine.empty() || options.engine == engine.name) engines.push_back(&engine);
  return engines;
}

std::vector<Row> measureAllErrors(const ChartScene& chart, const std::vector<Start>& starts,
                                  const ChartOptions& options, const PartDone& done)
{
  const std::vector<const EngineKind*> engines = enginesOf(options);
  double variants = 0.0, measured = 0.0;
  for (const EngineKind* engine : engines) variants += static_cast<double>(engine->variants.size());
  std::vector<Row> rows;
  for (const EngineKind* engine : engines)
    for (const std::string& variant : engine->variants)
    {
      measureVariant(chart, starts, *engine, variant, options.effort, rows);
      done(++measured / variants);
    }
  return rows;
}

/// Of one scene; how many points it has.
/// @param done  errors and costs take about as long
std::size_t measureScene(const ChartScene& chart, const ChartOptions& options, const PartDone& done)
{
  const std::vector<Start> starts = startsOf(chart, options.effort);
  std::vector<Row> rows = measureAllErrors(chart, starts, options, [&](double part) { done(0.5 * part); });
  measureTimes(chart, starts, options.effort, rows, [&](double part) { done(0.5 + 0.5 * part); });
  writeResults(options.out, chart, referenceError(chart, starts), provenance(options.commit), rows);
  return rows.size();
}

void list()
{
  for (const ChartScene& chart : chartScenes()) std::printf("%s: %s\n", chart.name.c_str(), chart.title.c_str());
  for (const EngineKind& engine : engineKinds())
    for (const std::string& variant : engine.variants) std::printf("%s %s\n", engine.name.c_str(), variant.c_str());
}

std::vector<ChartScene> scenesOf(const ChartOptions& options)
{
  std::vector<ChartScene> scenes;
  for (const ChartScene& chart : chartScenes())
    if (options.only.empty() || options.only == chart.name) scenes.push_back(chart);
  if (scenes.empty()) throw std::invalid_argument("--only: " + options.only + ": expected a scene that --list names");
  return scenes;
}

void measureAll(const ChartOptions& options)
{
  const std::vector<ChartScene> scenes = scenesOf(options);
  Progress progress("chart");
  for (std::size_t i = 0; i < scenes.size(); ++i)
  {
    const double of_all = 1.0 / static_cast<double>(scenes.size()), before = of_all * static_cast<double>(i);
    const std::size_t points =
        measureScene(scenes[i], options, progress.stretch(before, before + of_all, scenes[i].name));
    progress.clear();
    std::printf("%s: %zu points\n", scenes[i].name.c_str(), points);
    std::fflush(stdout);
  }
}

void run(const ChartOptions& options)
{
  if (options.help)
    writeHelp(*options.help);
  else if (options.list)
    list();
  else
    measureAll(options);
}
}  // namespace
}  // namespace ping_pong::bench

int main(int argc, char** argv)
{
  try
  {
    ping_pong::bench::run(ping_pong::bench::chartOptions(argc, argv));
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "chart: %s\n", error.what());
    return 1;
  }
}
