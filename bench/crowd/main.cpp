// What a ball of a crowd costs, against the number of balls: time, memory, contacts, and how sound the result is, as CSV.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

#include "apps/command_line.h"
#include "apps/progress.h"
#include "chart/results_file.h"
#include "core_distance.h"
#include "crowd_options.h"
#include "crowd_run.h"
#include "quiet_time.h"

namespace ping_pong::bench
{
namespace
{
constexpr std::size_t kWorthSharing = 1000;  // balls among threads
constexpr std::size_t kSecond = 100;         // ticks
constexpr double kNear = 120.0;              // between processors of one chip a line of the cache takes less [ns]
const std::string kOurs = "ping_pong_sim";

/// Ours: those made for crowds, `exact` and `impulse`. Of the peers those that carry thousands of balls.
std::vector<CrowdPoint> points(const CrowdScene& scene, bool companion)
{
  std::vector<CrowdPoint> all;
  for (const EngineKind& engine : engineKinds())
  {
    const bool ours = engine.name == kOurs;
    for (const std::string& variant : engine.variants)
      if (ours ? variant == "exact" || variant == "impulse" : variant == "default")
        for (const double step : scene.steps)
        {
          if (variant == "exact" && step != scene.steps.front()) continue;  // it takes no steps
          if (ours || engine.name == "ode" || engine.name == "bullet") all.push_back({&engine, variant, step});
          if (ours && step == scene.steps.front()) all.push_back({&engine, variant, step, 2});
          if (companion && variant == "exact") all.push_back({&engine, variant, step, 1, true});
        }
  }
  return all;
}

/// Processes that wanted to run in the last minute, on average.
std::string loadNow()
{
  std::string load = "unknown";
  std::ifstream("/proc/loadavg") >> load;
  return load;
}

/// How far from each other the processors were in the runs that count.
enum class Cores
{
  Any,
  Near,  ///< on one chip
  Far
};

/// A point with so many balls, and what its runs tell, which differ in nothing but time.
struct Measured
{
  const CrowdScene* scene;
  CrowdPoint point;
  std::size_t balls;
  CrowdResult result{};
  QuietTime time{};
  Cores cores = Cores::Any;

  /// Of a ball and simulated second; 0 if it was not done [us].
  double cost() const
  {
    return result.done ? 1e6 * time.total() / (result.simulated * static_cast<double>(balls)) : 0.0;
  }
};

const char* nameOf(Cores cores)
{
  return cores == Cores::Near ? "near" : cores == Cores::Far ? "far" : "";
}

void writeRow(std::FILE* file, const Measured& measured)
{
  const CrowdResult& r = measured.result;
  const CrowdPoint& point = measured.point;
  const double n = static_cast<double>(measured.balls);
  std::fprintf(file, "%s,%s,%s,%g,%zu,%zu,%d,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%g,%.6g,%.6g,%zu,%016llx,%s\n",
               measured.scene->name.c_str(), point.engine->name.c_str(),
               (point.variant + (point.companion ? "_with_companion" : "")).c_str(),
               point.variant == "exact" ? 0.0 : point.step, point.threads, measured.balls, r.done, r.start, r.simulated,
               measured.cost(), r.contacts / n, r.events / n, r.bytes / n, r.energy_change, r.overlap, r.escaped,
               1e6 * measured.time.mostOf(kSecond) / n, r.rest_after, measured.time.runs(),
               static_cast<unsigned long long>(r.hash), nameOf(measured.cores));
}

void tell(const Measured& measured)
{
  std::fprintf(stderr, "%s %s %s %g, %zu threads, %zu balls, run %zu: %.4g us per ball and simulated second%s\n",
               measured.scene->name.c_str(), measured.point.engine->name.c_str(), measured.point.variant.c_str(),
               measured.point.step, measured.point.threads, measured.balls, measured.time.runs(), measured.cost(),
               !measured.result.done      ? ", not done"
               : measured.point.companion ? ", beside another world"
                                          : "");
}

/// Once more: as many ticks as the first time.
CrowdRun measure(Measured& measured, const CrowdEffort& effort, Progress& progress)
{
  const CrowdRun run = measureCrowd(measured.point, *measured.scene, measured.balls, effort, measured.time.ticks());
  const bool first = measured.time.runs() == 0;
  if (first) measured.result = run.result;
  if (run.result.done)
  {
    if (run.result.hash != measured.result.hash)
      throw std::runtime_error(measured.scene->name + ": two runs ended in different states");
    measured.time.add(run.ticks);
  }
  progress.clear();
  if (first || run.result.done) tell(measured);
  return run;
}

bool isOneOf(const std::vector<std::string>& names, const std::string& name)
{
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

struct Candidate
{
  const CrowdScene* scene;
  CrowdPoint point;
};

std::vector<Candidate> candidates(const CrowdOptions& options)
{
  std::vector<Candidate> all;
  for (const CrowdScene& scene : crowdScenes())
    if (isOneOf(options.scenes, scene.name))
      for (const CrowdPoint& point : points(scene, options.companion))
        if (options.variant.empty() || (point.engine->name == kOurs && point.variant == options.variant))
          all.push_back({&scene, point});
  return all;
}

/// Ever more balls, as long as they do not take too long.
void measureRow(const Candidate& candidate, const CrowdOptions& options, const CrowdEffort& effort,
                std::vector<Measured>& all, Progress& progress)
{
  const auto& [scene, point] = candidate;
  const double most = options.quick ? 1000.0 : 100000.0;
  const auto settled = static_cast<std::size_t>(std::max(5, options.rounds / 2));
  for (double n = options.balls > 0.0 ? options.balls : scene->fewest; n <= 1.0001 * most; n *= std::sqrt(10.0))
  {
    const auto balls = static_cast<std::size_t>(n + 0.5);
    if (point.threads > 1 && balls < kWorthSharing) continue;
    if (!point.engine->refuse(crowdOf(*scene, balls), point.variant).empty()) break;
    Measured& measured = all.emplace_back(Measured{scene, point, balls, {}, QuietTime(settled)});
    measure(measured, effort, progress);
    if (!measured.result.done || options.balls > 0.0 || 4.0 * measured.result.wall > effort.most)
      break;  // more would take too long
  }
}

/// Rounds, each of which takes about as long.
double roundsOf(const CrowdOptions& options)
{
  return options.companion ? 1.0 + options.rounds
         : options.quick   ? 1.0
                           : std::max(1.0, static_cast<double>(options.rounds));
}

/// All points once.
std::vector<Measured> firstRound(const CrowdOptions& options, const CrowdEffort& effort, Progress& progress)
{
  std::vector<Measured> all;
  const std::vector<Candidate> rows = candidates(options);
  const PartDone done = progress.stretch(0.0, 1.0 / roundsOf(options), "first round");
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    measureRow(rows[i], options, effort, all, progress);
    done((i + 1.0) / static_cast<double>(rows.size()));
  }
  return all;
}

Cores coresNow()
{
  return coreDistance() < kNear ? Cores::Near : Cores::Far;
}

/// Of each point apart what it costs with near and with far processors: this system moves them from chip to chip at times. A
/// run counts if they were as far from each other after it as before; those of `all`, which tell how many ticks it has, do not.
std::vector<Measured> measureApart(std::vector<Measured>& all, const CrowdOptions& options, const CrowdEffort& effort,
                                   Progress& progress)
{
  std::vector<Measured> apart;
  for (const Measured& measured : all)
    for (const Cores cores : {Cores::Near, Cores::Far})
      apart.push_back({measured.scene, measured.point, measured.balls, measured.result, QuietTime(), cores});
  Cores before = coresNow();
  for (int round = 0; round < options.rounds; ++round)
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      const CrowdRun run = measure(all[k], effort, progress);
      const Cores after = coresNow();
      if (run.result.done && after == before) apart[2 * k + (after == Cores::Far)].time.add(run.ticks);
      before = after;
      progress.show((1.0 + round + (k + 1.0) / static_cast<double>(all.size())) / roundsOf(options));
    }
  apart.erase(
      std::remove_if(apart.begin(), apart.end(), [](const Measured& measured) { return measured.time.runs() == 0; }),
      apart.end());
  return apart;
}

/// Round after round, so that whoever else uses the machine for a while does not do so at the cost of one point.
void measureAgain(std::vector<Measured>& all, const CrowdOptions& options, const CrowdEffort& effort,
                  Progress& progress)
{
  for (int round = 1; round < options.rounds; ++round)
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      Measured& measured = all[k];
      if (measured.result.done && 4.0 * measured.result.wall < effort.most && !measured.time.settled())
        measure(measured, effort, progress);
      progress.show((round + (k + 1.0) / static_cast<double>(all.size())) / options.rounds);
    }
}

void measureAll(const CrowdOptions& options)
{
  std::FILE* file = std::fopen(options.out.c_str(), "w");
  if (file == nullptr) throw std::runtime_error(options.out + ": cannot be written");
  const Provenance from = provenance(options.commit);
  const std::string load = loadNow();
  const CrowdEffort effort = options.quick ? CrowdEffort{0.1, 5.0} : CrowdEffort();
  Progress progress("crowd");
  std::vector<Measured> all = firstRound(options, effort, progress);
  if (options.companion)
    all = measureApart(all, options, effort, progress);
  else if (!options.quick)
    measureAgain(all, options, effort, progress);
  std::fprintf(file, "# machine: %s\n# compiler: %s\n# commit: %s\n# load: %s\n", from.machine.c_str(),
               from.compiler.c_str(), from.commit.c_str(), load.c_str());
  std::fprintf(
      file,
      "scene,engine,variant,step,threads,balls,done,start_s,simulated_s,cost_us,contacts,events,bytes,energy_change,"
      "overlap_m,escaped,most_cost_us,rest_after_s,runs,hash,cores\n");
  for (const Measured& measured : all) writeRow(file, measured);
  std::fclose(file);
}
}  // namespace
}  // namespace ping_pong::bench

int main(int argc, char** argv)
{
  try
  {
    const ping_pong::bench::CrowdOptions options = ping_pong::bench::crowdOptions(argc, argv);
    if (options.help) return ping_pong::writeHelp(*options.help) ? 0 : 2;
    ping_pong::bench::measureAll(options);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "crowd: %s\n", error.what());
    return 2;
  }
}
