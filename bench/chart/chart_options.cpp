#include "chart_options.h"

#include <limits>

#include "apps/command_line.h"

namespace ping_pong::bench
{
namespace
{
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

double budget(const std::string& text)
{
  return text == "inf" ? std::numeric_limits<double>::infinity() : numberNotNegative(text);
}

OptionGroup whatToMeasure(ChartOptions& options)
{
  return {"What is measured",
          {{"--only", "SCENE", "this scene alone", into(options.only, anyText)},
           {"--engine", "NAME", "this engine alone", into(options.engine, anyText)},
           {"--list", "", "names of scenes and engines; measures nothing", flag(options.list)}}};
}

OptionGroup howLong(ChartOptions& options)
{
  return {"Effort",
          {{"--quick",
            "",
            "few starts, short repeats, every tenth step: does it work?\nA --budget or --repeat after it counts all "
            "the same",
            {[&options](const std::string&) { options.effort = quickEffort(); }}},
           {"--budget", "SECONDS", "leaves out points whose error run takes longer; inf: none",
            into(options.effort.error_budget, budget)},
           {"--repeat", "SECONDS", "least time of one repeat of the timing",
            into(options.effort.repeat_time, numberNotNegative)}}};
}

OptionGroup whereTo(ChartOptions& options)
{
  return {"Results",
          {{"--out", "DIRECTORY", "the folder for one CSV file per scene, which must exist; required but for --list",
            into(options.out, anyText)},
           {"--commit", "TEXT", "that the results say they come from", into(options.commit, anyText)}}};
}
}  // namespace

ChartOptions chartOptions(int argc, char** argv)
{
  ChartOptions options;
  const CommandLine line = {
      "chart",
      "Measures the work-precision chart: errors and costs of every scene, engine, variant and step.",
      {whatToMeasure(options), howLong(options), whereTo(options)}};
  options.help = parse(line, argc, argv);
  if (!options.help && options.out.empty() && !options.list)
    refuse("--out", "missing", "the folder for the CSV files; see --help");
  return options;
}
}  // namespace ping_pong::bench
