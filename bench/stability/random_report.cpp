#include "random_report.h"

#include <algorithm>
#include <cstdio>

namespace ping_pong::stability
{
namespace
{
std::string printed(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

double median(std::vector<double> values)
{
  if (values.empty()) return 0.0;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

double largest(const std::vector<double>& values)
{
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

void printLine(std::ostream& out, const std::string& name, const Tally& tally)
{
  char text[160];
  std::snprintf(text, sizeof text, "%-13s %7zu %7zu %9.3g %9.3g %9.2g %9.2g", name.c_str(), tally.scenes, tally.failed,
                median(tally.quiet_events), largest(tally.quiet_events), tally.deepest, tally.gain);
  out << text;
  for (std::size_t i = 0; i < kChecks; ++i)
    if (tally.broken[i] > 0) out << "  " << textOf(static_cast<Check>(i)).name << ' ' << tally.broken[i];
  out << '\n';
}
}  // namespace

void Tally::add(const Verdict& verdict)
{
  ++scenes;
  failed += verdict.failed();
  for (std::size_t i = 0; i < kChecks; ++i) broken[i] += verdict.findings[i].broken;
  if (verdict.quiet_events >= 0.0) quiet_events.push_back(verdict.quiet_events);
  deepest = std::max(deepest, verdict.deepest);
  gain = std::max(gain, verdict.gain);
}

void RandomReport::add(const std::string& category, const Verdict& verdict)
{
  of_[category].add(verdict);
  all_.add(verdict);
}

void RandomReport::print(std::ostream& out) const
{
  out << "category       scenes  failed  events/s: median, worst  deepest m   gain      broken\n";
  for (const StageKind& kind : stageKinds())
    if (const auto found = of_.find(kind.name); found != of_.end()) printLine(out, found->first, found->second);
  printLine(out, "all", all_);
}

void RandomReport::write(std::ostream& out, const char* method) const
{
  for (const StageKind& kind : stageKinds())
  {
    const auto found = of_.find(kind.name);
    if (found == of_.end()) continue;
    const Tally& tally = found->second;
    out << method << ',' << kind.name << ',' << tally.scenes << ",any,\"any of the others\"," << tally.failed << '\n';
    for (std::size_t i = 0; i < kChecks; ++i)
    {
      const CheckText& text = textOf(static_cast<Check>(i));
      out << method << ',' << kind.name << ',' << tally.scenes << ',' << text.name << ",\"" << text.says << "\","
          << tally.broken[i] << '\n';
    }
  }
}

std::string failureLine(std::uint64_t seed, std::uint64_t index, const Verdict& verdict)
{
  std::string line = categoryOf(index);
  for (std::size_t i = 0; i < kChecks; ++i)
  {
    const Finding& finding = verdict.findings[i];
    if (!finding.broken) continue;
    const CheckText& text = textOf(static_cast<Check>(i));
    line += std::string("  ") + text.name + printed(" %.3g", finding.value) + printed(" > %.3g", finding.bound) +
            printed(" at %.3f s", finding.time);
  }
  return line + "   scripts/stability --random 1 --seed " + std::to_string(seed) + " --first " + std::to_string(index);
}

std::string categoryOf(std::uint64_t index)
{
  return stageKinds()[index % stageKinds().size()].name;
}
}  // namespace ping_pong::stability
