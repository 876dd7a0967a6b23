// Measures the work-precision chart: every scene x engine x variant x step, errors and costs in separate runs.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <stdexcept>

#include "error_run.h"
#include "our_engine.h"
#include "results_file.h"
#include "time_run.h"

namespace ping_pong::bench
{
namespace
{
constexpr char kTooLong[] = "takes too long";
constexpr double kPatience = 1.5;  // a point may take so many times what was expected at most

constexpr char kUsage[] =
    "usage: chart --out DIRECTORY [--quick] [--only SCENE] [--engine NAME] [--budget SECONDS]\n"
    "             [--repeat SECONDS] [--commit TEXT] "
    "[--list]\n"
    "Measures the work-precision chart and writes one CSV file per scene into DIRECTORY, which must exist.\n"
    "  --quick   few starts, short repeats, every tenth step: does it work?\n"
    "  --budget  leaves out points whose error run takes longer; default 5\n"
    "  --repeat  least time of one repeat of the timing; default 0.2\n"
    "  --list    names of scenes and engines\n";

struct Options
{
  std::string out, only, engine, commit = "unknown";
  bool list = false;
  Effort effort;
};

Effort quickEffort()
{
  Effort effort;
  effort.most_starts = 4;
  effort.decades_only = true;
  effort.error_budget = 0.4;
  effort.repeat_time = 2e-3;
  effort.repeats = 3;
  return effort;
}

Options optionsFrom(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const auto value = [&]() -> std::string
    {
      if (i + 1 == argc) throw std::invalid_argument(argument + ": expected a value");
      return argv[++i];
    };
    if (argument == "--quick")
      options.effort = quickEffort();
    else if (argument == "--list")
      options.list = true;
    else if (argument == "--out")
      options.out = value();
    else if (argument == "--only")
      options.only = value();
    else if (argument == "--engine")
      options.engine = value();
    else if (argument == "--budget")
      options.effort.error_budget = std::stod(value());
    else if (argument == "--repeat")
      options.effort.repeat_time = std::stod(value());
    else if (argument == "--commit")
      options.commit = value();
    else
      throw std::invalid_argument(argument + ": unknown argument\n" + kUsage);
  }
  if (options.out.empty() && !options.list) throw std::invalid_argument(kUsage);
  return options;
}

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
                  std::vector<Row>& rows)
{
  std::vector<Point> points;
  for (const Row& row : rows)
    if (row.refusal.empty()) points.push_back(row.point);
  const std::vector<Cost> costs = measureCosts(chart, starts, points, effort);
  std::size_t next = 0;
  for (Row& row : rows)
    if (row.refusal.empty()) row.cost = costs[next++];
}

void measureScene(const ChartScene& chart, const Options& options)
{
  const std::vector<Start> starts = startsOf(chart, options.effort);
  std::vector<Row> rows;
  for (const EngineKind& engine : engineKinds())
    for (const std::string& variant : engine.variants)
      if (options.engine.empty() || options.engine == engine.name)
        measureVariant(chart, starts, engine, variant, options.effort, rows);
  measureTimes(chart, starts, options.effort, rows);
  writeResults(options.out, chart, referenceError(chart, starts), provenance(options.commit), rows);
  std::printf("%s: %zu points\n", chart.name.c_str(), rows.size());
  std::fflush(stdout);
}

void list()
{
  for (const ChartScene& chart : chartScenes()) std::printf("%s: %s\n", chart.name.c_str(), chart.title.c_str());
  for (const EngineKind& engine : engineKinds())
    for (const std::string& variant : engine.variants) std::printf("%s %s\n", engine.name.c_str(), variant.c_str());
}

void run(const Options& options)
{
  if (options.list) return list();
  bool found = false;
  for (const ChartScene& chart : chartScenes())
  {
    if (!options.only.empty() && options.only != chart.name) continue;
    found = true;
    measureScene(chart, options);
  }
  if (!found) throw std::invalid_argument(options.only + ": no such scene; --list names them");
}
}  // namespace
}  // namespace ping_pong::bench

int main(int argc, char** argv)
{
  try
  {
    ping_pong::bench::run(ping_pong::bench::optionsFrom(argc, argv));
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "chart: %s\n", error.what());
    return 1;
  }
}
