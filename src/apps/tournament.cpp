// Computer players against each other, without ROS: each level against the one below, or a pair of levels.
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

#include "apps/command_line.h"
#include "apps/progress.h"
#include "match/headless_match.h"
#include "ping_pong_sim/scene_loader.h"

namespace
{
using namespace ping_pong;

struct Options
{
  std::string scene = SCENES_DIR "/match.yaml";
  std::string rules = "ittf";
  std::size_t games = 200, seed = 1, first = 0, second = 0;
  bool calls = false;
  std::optional<std::string> help;
};

Options readOptions(int argc, char** argv)
{
  Options o;
  const std::vector<OptionGroup> groups = {
      {"Who plays",
       {{"--first", "LEVEL", "a pair instead of all neighbours: level of the one, 1 to 5",
         into(o.first, integerWithin(1, 5))},
        {"--second", "LEVEL", "and of the other", into(o.second, integerWithin(1, 5))}}},
      {"What they play",
       {{"--games", "N", "games of each pair, up to 11 points", into(o.games, integerWithin(1, 1000000))},
        {"--rules", "NAME", "preset, see docs/game.md; players keep their ends", into(o.rules, anyText)},
        {"--seed", "N", "of the first game; each game has the next one", into(o.seed, integerWithin(0, 1000000000))},
        {"--scene", "FILE", "table, net, and a paddle at each end", into(o.scene, fileName)}}},
      {"Output", {{"--calls", "", "every call of the umpire, too", flag(o.calls)}}}};
  const CommandLine line = {"tournament", "Lets computer players of different levels play against each other.", groups};
  o.help = parse(line, argc, argv);
  if (!o.help && (o.first == 0) != (o.second == 0)) throw UsageError("--first and --second: expected both or neither");
  return o;
}

/// What came of all games of a pair; arrays: of the first, of the second.
struct Tally
{
  std::array<std::size_t, 2> won{}, points{}, services{}, faults{};
  std::size_t undecided = 0, rallies = 0, strokes = 0, longest = 0;
  double simulated = 0.0, wall = 0.0;  ///< [s]
};

void sayCalls(const std::vector<game::Call>& calls)
{
  for (const game::Call& call : calls)
    std::printf("%10.3f  %2d:%-2d  %-10s %-10s %s\n", call.time, call.score.points[0], call.score.points[1],
                game::name(call.kind), call.law.c_str(), call.reason.c_str());
}

/// @param ends_changed  the first of the pair plays at the +x end
void add(Tally& tally, const MatchResult& result, bool ends_changed)
{
  for (std::size_t i = 0; i < 2; ++i)
  {
    const std::size_t who = ends_changed ? 1 - i : i;
    tally.won[who] += result.winner && index(*result.winner) == i;
    for (const std::array<int, 2>& game : result.games) tally.points[who] += static_cast<std::size_t>(game[i]);
    tally.services[who] += result.services[i];
    tally.faults[who] += result.faults[i];
  }
  tally.undecided += !result.winner;
  tally.rallies += static_cast<std::size_t>(result.score.rallies);
  tally.strokes += result.strokes;
  tally.longest = std::max(tally.longest, static_cast<std::size_t>(result.score.best_rally));
  tally.simulated += result.time;
}

Tally playPair(const Options& o, const std::shared_ptr<const Scene>& scene, std::array<int, 2> levels,
               Progress& progress)
{
  Tally tally;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t n = 0; n < o.games; ++n)
  {
    const bool ends_changed = n % 2 == 1;
    MatchSetup setup;
    setup.scene = scene;
    setup.rules = game::rulesPreset(o.rules);
    setup.rules.games = 1;
    setup.rules.change_ends = false;
    setup.levels = ends_changed ? std::array<int, 2>{levels[1], levels[0]} : levels;
    setup.first_server = n / 2 % 2 == 0 ? game::Player::A : game::Player::B;
    setup.seed = o.seed + n;
    HeadlessMatch match(setup);
    while (match.advance())
    {
      const std::vector<game::Call> calls = match.takeCalls();
      if (o.calls && !calls.empty()) progress.clear(), sayCalls(calls);
    }
    add(tally, match.result(), ends_changed);
    progress.show(static_cast<double>(n + 1) / static_cast<double>(o.games));
  }
  tally.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return tally;
}

double part(std::size_t some, std::size_t all)
{
  return all == 0 ? 0.0 : 100.0 * static_cast<double>(some) / static_cast<double>(all);
}

void report(const std::array<int, 2>& levels, const Tally& t)
{
  const double rallies = std::max<double>(1.0, static_cast<double>(t.rallies));
  std::printf("| %d : %d | %zu : %zu | %zu : %zu | %.1f | %zu | %.1f %% : %.1f %% | %zu | %.0f |\n", levels[0],
              levels[1], t.won[0], t.won[1], t.points[0], t.points[1], static_cast<double>(t.strokes) / rallies,
              t.longest, part(t.faults[0], t.services[0]), part(t.faults[1], t.services[1]), t.undecided,
              t.simulated / t.wall);
  std::fflush(stdout);
}

int run(int argc, char** argv)
{
  const Options o = readOptions(argc, argv);
  if (o.help) return writeHelp(*o.help) ? 0 : 1;
  const auto scene = std::make_shared<const Scene>(loadScene(o.scene));
  std::vector<std::array<int, 2>> pairs;
  if (o.first != 0)
    pairs.push_back({static_cast<int>(o.first), static_cast<int>(o.second)});
  else
    for (int level = 2; level <= 5; ++level) pairs.push_back({level, level - 1});

  std::printf("Rules %s, %zu games of a pair, seeds from %zu on.\n\n", o.rules.c_str(), o.games, o.seed);
  std::printf(
      "| levels | games | points | strokes of a rally | longest | services that were faults | undecided | times real "
      "time |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::array<int, 2>& levels : pairs)
  {
    Progress progress("level " + std::to_string(levels[0]) + " against " + std::to_string(levels[1]));
    const Tally tally = playPair(o, scene, levels, progress);
    progress.clear();
    report(levels, tally);
  }
  return 0;
}
}  // namespace

int main(int argc, char** argv)
{
  try
  {
    return run(argc, argv);
  }
  catch (const UsageError& error)
  {
    std::fprintf(stderr, "tournament: %s\n", error.what());
    return 2;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "tournament: %s\n", error.what());
    return 1;
  }
}
