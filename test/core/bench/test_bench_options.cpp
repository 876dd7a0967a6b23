// Command lines of `chart`, `crowd` and `stability`: what --help tells, how bad ones are refused, what scripts rely on.
#include <gtest/gtest.h>

#include <cmath>

#include "apps/command_line.h"
#include "chart/chart_options.h"
#include "crowd/crowd_options.h"
#include "stability/options.h"

namespace ping_pong
{
namespace
{
using Words = std::vector<std::string>;

template <class Options>
Options taken(Options (*take)(int, char**), Words words)
{
  words.insert(words.begin(), "program");
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  return take(static_cast<int>(pointers.size()), pointers.data());
}

template <class Options>
std::string refusal(Options (*take)(int, char**), const Words& words)
{
  try
  {
    taken(take, words);
  }
  catch (const UsageError& error)
  {
    return error.what();
  }
  return "";
}

template <class Options>
void expectHelp(Options (*take)(int, char**), const Words& parts)
{
  const std::optional<std::string> help = taken(take, {"--help"}).help;
  ASSERT_TRUE(help);
  for (const std::string& part : parts) EXPECT_NE(help->find(part), std::string::npos) << part << "\n" << *help;
}

TEST(ChartOptions, HelpTellsGroupsAndDefaults)
{
  expectHelp(bench::chartOptions, {"What is measured:\n", "--only SCENE", "--engine NAME", "--list", "Effort:\n",
                                   "--quick", "--budget SECONDS=8 ", "--repeat SECONDS=0.2 ", "Results:\n",
                                   "--out DIRECTORY", "--commit TEXT=unknown "});
}

TEST(ChartOptions, AreTakenAsScriptsGiveThem)
{
  const bench::ChartOptions options =
      taken(bench::chartOptions, {"--quick", "--only", "rally", "--commit", "abc", "--out", "/tmp"});
  EXPECT_EQ(options.only, "rally");
  EXPECT_EQ(options.commit, "abc");
  EXPECT_EQ(options.out, "/tmp");
  EXPECT_EQ(options.effort.most_starts, 4);
  EXPECT_TRUE(taken(bench::chartOptions, {"--list"}).list);
  EXPECT_TRUE(std::isinf(taken(bench::chartOptions, {"--budget", "inf", "--list"}).effort.error_budget));
}

TEST(ChartOptions, WhatFollowsQuickOverrulesIt)
{
  EXPECT_EQ(taken(bench::chartOptions, {"--quick", "--budget", "3", "--list"}).effort.error_budget, 3.0);
  EXPECT_EQ(taken(bench::chartOptions, {"--budget", "3", "--quick", "--list"}).effort.error_budget, 0.4);
}

TEST(ChartOptions, ThatAreBadAreRefused)
{
  EXPECT_EQ(refusal(bench::chartOptions, {}), "--out: missing: expected the folder for the CSV files; see --help");
  EXPECT_EQ(refusal(bench::chartOptions, {"--budget", "5s"}), "--budget: 5s: expected a finite number >= 0");
  EXPECT_EQ(refusal(bench::chartOptions, {"--out"}), "--out: nothing: expected a value after it");
  EXPECT_EQ(refusal(bench::chartOptions, {"--slow"}).rfind("--slow: unknown option: expected one of", 0), 0u);
}

TEST(CrowdOptions, HelpTellsGroupsAndDefaults)
{
  expectHelp(bench::crowdOptions,
             {"What is measured:\n", "--scene NAME", "--variant NAME", "--balls N=0 ", "--companion", "Effort:\n",
              "--quick", "--rounds N=8 ", "Results:\n", "--out FILE REQUIRED", "--commit NAME=unknown "});
}

TEST(CrowdOptions, AreTakenAsScriptsGiveThem)
{
  const bench::CrowdOptions options =
      taken(bench::crowdOptions, {"--scene", "gas", "--scene", "crowd", "--variant", "exact", "--companion", "--balls",
                                  "1e4", "--rounds", "200", "--commit", "abc", "--out", "x.csv"});
  EXPECT_EQ(options.scenes, (Words{"gas", "crowd"}));
  EXPECT_EQ(options.variant, "exact");
  EXPECT_TRUE(options.companion);
  EXPECT_EQ(options.balls, 1e4);
  EXPECT_EQ(options.rounds, 200);
  EXPECT_EQ(options.out, "x.csv");
}

TEST(CrowdOptions, ThatAreBadAreRefused)
{
  EXPECT_EQ(refusal(bench::crowdOptions, {"--quick"}), "--out: missing: expected the CSV file to write; see --help");
  EXPECT_EQ(refusal(bench::crowdOptions, {"--out", "x", "--balls", "1k"}),
            "--balls: 1k: expected a finite number >= 0");
  EXPECT_EQ(refusal(bench::crowdOptions, {"--out", "x", "--rounds", "many"}),
            "--rounds: many: expected an integer from 0 to 1000000");
  EXPECT_EQ(refusal(bench::crowdOptions, {"--tray", "--out", "x"}).rfind("--tray: unknown option: expected one of", 0),
            0u);
  EXPECT_EQ(refusal(bench::crowdOptions, {"x", "--out", "x"}).rfind("x: no option: expected one of", 0), 0u);
}

TEST(StabilityOptions, HelpTellsGroupsAndDefaults)
{
  expectHelp(stability::optionsFrom,
             {"DIRECTORY", "Which scenes:\n", "--random N=1000 ", "--seed S=1 ", "--first K=0 ", "--dump FOLDER",
              "How they run:\n", "--method M=exact ", "--dt H=0.001 ", "--patience SECONDS=10 ", "--processes P="});
}

TEST(StabilityOptions, AreTakenAsFailingScenesAreRepeated)
{
  const stability::Options options = taken(
      stability::optionsFrom,
      {"--random", "1", "--seed", "7", "--first", "31", "--method", "impulse", "--processes", "0", "--dump", "x"});
  EXPECT_EQ(options.directory, "");
  EXPECT_EQ(options.random.count, 1u);
  EXPECT_EQ(options.random.seed, 7u);
  EXPECT_EQ(options.random.first, 31u);
  EXPECT_EQ(options.random.method, Method::Impulse);
  EXPECT_EQ(options.random.processes, 1u);
  EXPECT_EQ(options.random.dump, "x");
}

TEST(StabilityOptions, WithoutAFolderAreOfRandomScenes)
{
  EXPECT_EQ(taken(stability::optionsFrom, {}).random.count, 1000u);
  EXPECT_EQ(taken(stability::optionsFrom, {"results"}).directory, "results");
}

TEST(StabilityOptions, ThatAreBadAreRefused)
{
  EXPECT_EQ(refusal(stability::optionsFrom, {"--seed", "x"}), "--seed: x: expected an integer >= 0");
  EXPECT_EQ(refusal(stability::optionsFrom, {"--dt", "0"}), "--dt: 0: expected a finite number > 0");
  EXPECT_EQ(refusal(stability::optionsFrom, {"--method", "magic"})
                .rfind("--method: magic: expected one of: euler_explicit, ", 0),
            0u);
  EXPECT_EQ(refusal(stability::optionsFrom, {"--random"}), "--random: nothing: expected a value after it");
  EXPECT_EQ(refusal(stability::optionsFrom, {"results", "--seed", "2"})
                .rfind("results: beside options: expected no options", 0),
            0u);
  EXPECT_EQ(refusal(stability::optionsFrom, {"results", "more"}), "more: second directory: expected one directory");
}
}  // namespace
}  // namespace ping_pong
