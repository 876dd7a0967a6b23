// How well the computer player plays: against a launcher, in its service, with itself.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "apps/command_line.h"
#include "apps/progress.h"
#include "measured_data.h"
#include "ping_pong_sim/scene_loader.h"
#include "ping_pong_sim/shots.h"
#include "play/drills.h"

namespace ping_pong::play
{
namespace
{
struct Options
{
  std::string scene = "config/scenes/match.yaml";
  std::string data = "test/data";
  std::string style = "mixed";
  std::uint64_t seed = 1, balls = 200, serves = 100, rallies = 21, longest = 400;
  int level = 5;
  double scatter = 0.05, tick = 1e-3;
  std::optional<std::string> help;
};

Options optionsFrom(int argc, char** argv)
{
  Options options;
  const OptionGroup who = {
      "Player",
      {{"--level", "N", "1 to 5", into(options.level, integerWithin(kLowestLevel, kHighestLevel))},
       {"--style", "S", "attack, defend, mixed or cooperative; rallies are cooperative", into(options.style, anyText)},
       {"--seed", "N", "of the first ball; each other has the next", into(options.seed, integerWithin(0))}}};
  const OptionGroup what = {
      "Trials",
      {{"--balls", "N", "launched of each named shot", into(options.balls, integerWithin(0, 100000))},
       {"--scatter", "S", "of the launcher", into(options.scatter, numberWithin(0.0, 1.0))},
       {"--serves", "N", "services", into(options.serves, integerWithin(0, 100000))},
       {"--rallies", "N", "with itself", into(options.rallies, integerWithin(0, 100000))},
       {"--longest", "N", "a rally is stopped after so many strokes", into(options.longest, integerWithin(1, 1000000))},
       {"--tick", "H", "length of a tick [s]", into(options.tick, numberWithin(1e-4, 0.02))}}};
  const OptionGroup input = {"Input",
                             {{"--scene", "FILE", "with paddle_a and paddle_b", into(options.scene, fileName)},
                              {"--data", "DIR", "measured launches", into(options.data, anyText)}}};
  const CommandLine line = {
      "player_check",
      "How well the computer player returns launched balls, lands them on its targets, serves, and keeps\n"
      "a rally with itself; and how long it thinks.",
      {who, what, input},
      "Exit status: 0; 2 bad input."};
  options.help = parse(line, argc, argv);
  return options;
}

double percentile(std::vector<double> values, double part)
{
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

struct Tally
{
  std::map<Outcome, std::size_t> outcomes;
  std::map<Stroke, std::size_t> strokes;
  std::map<std::string, std::size_t> why;  // nothing was to be returned
  std::vector<double> errors;              // [m]
  double most_spin = 0.0;                  // [rad/s]

  void add(const ReturnResult& result)
  {
    ++outcomes[result.outcome];
    if (!result.why.empty()) ++why[result.why];
    most_spin = std::max(most_spin, result.spin);
    if (result.outcome == Outcome::NotItsHalf || result.outcome == Outcome::Untouched) return;
    ++strokes[result.stroke];
    if (result.outcome == Outcome::Returned) errors.push_back(result.landing_error);
  }

  void print(const std::string& what) const
  {
    std::size_t all = 0;
    for (const auto& [outcome, count] : outcomes) all += count;
    const auto of = [&](Outcome outcome) { return outcomes.count(outcome) ? outcomes.at(outcome) : 0; };
    const std::size_t due = all - of(Outcome::NotItsHalf);
    std::printf(
        "%-10s %5zu of %5zu returned (%.1f %%); landing error median %.2g cm, 95 %% %.2g cm; most spin %.0f rad/s;",
        what.c_str(), of(Outcome::Returned), due,
        due > 0 ? 100.0 * static_cast<double>(of(Outcome::Returned)) / static_cast<double>(due) : 0.0,
        100.0 * percentile(errors, 0.5), 100.0 * percentile(errors, 0.95), most_spin);
    for (const auto& [end, count] : why) std::printf(" %zu %s;", count, end.c_str());
    for (const auto& [outcome, count] : outcomes)
      if (outcome != Outcome::Returned && outcome != Outcome::NotItsHalf) std::printf(" %zu %s;", count, name(outcome));
    for (const auto& [stroke, count] : strokes) std::printf(" %s %zu", name(stroke), count);
    std::printf("\n");
  }
};

BallState launchState(const Shot& shot)
{
  BallState state;
  state.p_WB = shot.p_TB;
  state.v_WB = shot.v_TB;
  state.w_WB = shot.w_TB;
  return state;
}

void checkReturns(Trial& trial, const Options& options)
{
  std::printf("launcher, scatter %g, seeds %llu to %llu:\n", options.scatter,
              static_cast<unsigned long long>(options.seed),
              static_cast<unsigned long long>(options.seed + options.balls - 1));
  for (const Shot& shot : shots())
  {
    Tally tally;
    for (std::uint64_t seed = options.seed; seed < options.seed + options.balls; ++seed)
      tally.add(returnOf(trial, launchState(scattered(shot, options.scatter, seed)), seed));
    tally.print(shot.name);
  }
}

void checkLaunches(Trial& trial, const Options& options)
{
  std::printf("measured launches:\n");
  std::map<std::string, Tally> tallies;
  std::uint64_t seed = options.seed;
  for (const Launch& launch : readLaunches(options.data))
    tallies[launch.kind].add(returnOf(trial, launch.state, seed++));
  for (const auto& [kind, tally] : tallies) tally.print(kind);
}

void checkServes(Trial& trial, const Options& options)
{
  std::size_t legal = 0;
  std::vector<double> errors;
  std::map<std::string, std::size_t> faults;
  for (std::uint64_t seed = options.seed; seed < options.seed + options.serves; ++seed)
  {
    const ServeResult result = serveOf(trial, seed);
    legal += result.legal;
    if (result.legal)
      errors.push_back(result.landing_error);
    else
      ++faults[std::string(name(result.stroke)) + ": " + result.fault];
  }
  std::printf("services: %zu of %llu legal; landing error 95 %% %.2g cm;", legal,
              static_cast<unsigned long long>(options.serves), 100.0 * percentile(errors, 0.95));
  for (const auto& [fault, count] : faults) std::printf(" %zu %s;", count, fault.c_str());
  std::printf("\n");
}

void checkRallies(Trial& trial, const Options& options)
{
  std::vector<double> lengths;
  Progress progress("player_check");
  for (std::uint64_t i = 0; i < options.rallies; ++i)
  {
    lengths.push_back(static_cast<double>(rallyOf(trial, options.seed + i, options.longest).strokes));
    progress.show(static_cast<double>(i + 1) / static_cast<double>(options.rallies), "rallies");
  }
  progress.clear();
  std::printf("rallies with itself: median %.0f strokes, shortest %.0f, of %llu, stopped at %llu\n",
              percentile(lengths, 0.5), percentile(lengths, 0.0), static_cast<unsigned long long>(options.rallies),
              static_cast<unsigned long long>(options.longest));
}

void printCost(const char* what, const Trial& trial)
{
  std::printf(
      "%s: planning %.2f us a tick on average, %.2f ms at worst; racket %.1f m/s, %.0f m/s2 at most; stopped by the "
      "table in "
      "%llu ticks\n",
      what, 1e6 * trial.planningTime() / static_cast<double>(std::max<std::uint64_t>(1, trial.updates())),
      1e3 * trial.worstPlanning(), trial.topSpeed(), trial.topAcceleration(),
      static_cast<unsigned long long>(trial.blocked()));
}

int run(int argc, char** argv)
{
  const Options options = optionsFrom(argc, argv);
  if (options.help) return writeHelp(*options.help) ? 0 : 2;
  const auto scene = std::make_shared<const Scene>(loadScene(options.scene));
  PlayerParams params;
  params.level = options.level;
  params.style = styleFromName(options.style);
  std::printf("level %d, style %s, tick %g ms\n", options.level, options.style.c_str(), 1e3 * options.tick);
  Trial alone(scene, {params}, options.tick);
  if (options.balls > 0)
  {
    checkReturns(alone, options);
    checkLaunches(alone, options);
  }
  if (options.serves > 0) checkServes(alone, options);
  printCost("one player", alone);
  PlayerParams first = params, second = params;
  first.style = second.style = Style::Cooperative;
  second.end = End::B;
  second.paddle = "paddle_b";
  Trial pair(scene, {first, second}, options.tick);
  if (options.rallies > 0)
  {
    checkRallies(pair, options);
    printCost("two players", pair);
  }
  return 0;
}
}  // namespace
}  // namespace ping_pong::play

int main(int argc, char** argv)
{
  try
  {
    return ping_pong::play::run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "player_check: %s\n", error.what());
    return 2;
  }
}
