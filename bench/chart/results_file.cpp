#include "results_file.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace ping_pong::bench
{
namespace
{
std::string processor()
{
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown";
}

const char* nameOf(Measure measure)
{
  switch (measure)
  {
    case Measure::Position:
      return "position";
    case Measure::Energy:
      return "energy";
    case Measure::Overlap:
      return "overlap";
  }
  return "";
}

std::string failuresOf(const Errors& errors)
{
  std::string text;
  const auto add = [&](bool failed, const char* name)
  {
    if (failed) text += (text.empty() ? "" : " ") + std::string(name);
  };
  add(errors.not_finite > 0, "not_finite");
  add(errors.tunnelled > 0, "tunnelled");
  add(errors.missed > 0, "missed");
  add(errors.unsettled > 0, "unsettled");
  add(errors.gainsEnergy(), "energy");
  return text;
}

// In double quotes, on one line.
std::string quoted(std::string text)
{
  std::replace(text.begin(), text.end(), '"', '\'');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return '"' + text + '"';
}

void writeRow(std::ostream& out, const Row& row)
{
  const Errors& e = row.errors;
  out << row.point.engine->name << ',' << row.point.variant << ',' << row.point.step << ',' << e.starts << ','
      << row.cost.least << ',' << row.cost.median << ',' << e.position_rms << ',' << e.position_max << ',' << e.spin_rms
      << ',' << e.energy_rms << ',' << e.energy_growth << ',' << e.momentum << ',' << e.penetration << ','
      << e.overlap_rms << ',' << e.wrong_bounces << ',' << e.missed << ',' << e.tunnelled << ',' << e.not_finite << ','
      << failuresOf(e) << ',' << quoted(row.refusal) << '\n';
}
}  // namespace

Provenance provenance(const std::string& commit)
{
#ifdef __clang__
  const std::string compiler = "clang " __clang_version__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
  return {commit, processor(), compiler};
}

void writeResults(const std::string& directory, const ChartScene& chart, double reference_error, const Provenance& from,
                  const std::vector<Row>& rows)
{
  std::ostringstream out;
  out.precision(6);
  out << "# title: " << chart.title << "\n# reference: " << chart.reference
      << "\n# reference_error_m: " << reference_error << "\n# measure: " << nameOf(chart.measure)
      << "\n# machine: " << from.machine << "\n# compiler: " << from.compiler << "\n# commit: " << from.commit << '\n'
      << "engine,variant,step,starts,cost_s,cost_median_s,position_rms_m,position_max_m,spin_rms_rad_s,energy_rms,"
         "energy_growth,momentum,penetration_m,overlap_rms_m,wrong_bounces,missed,tunnelled,not_finite,failures,"
         "refusal\n";
  for (const Row& row : rows) writeRow(out, row);
  std::ofstream file(directory + "/" + chart.name + ".csv");
  file << out.str();
  file.close();
  if (!file) throw std::runtime_error(directory + "/" + chart.name + ".csv: cannot be written");
}
}  // namespace ping_pong::bench
