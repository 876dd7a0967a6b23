// Command lines: how words become values, what --help tells, how bad ones are refused.
#include <gtest/gtest.h>

#include "apps/command_line.h"

namespace ping_pong
{
namespace
{
class Words : public ::testing::Test
{
protected:
  std::optional<std::string> take(std::vector<const char*> words)
  {
    words.insert(words.begin(), "program");
    const OptionGroup numbers = {"Numbers",
                                 {{"--rate", "R", "rows per second [Hz]", into(rate_, positiveNumber)},
                                  {"--rounds", "N", "how often", into(rounds_, integerWithin(0, 9))},
                                  {"--limit", "L", "at most", into(limit_, numberNotNegative)}}};
    const OptionGroup names = {"Names",
                               {{"SCENE.yaml", "", "the scene file to run", into(scene_, fileName)},
                                {"--out", "FILE", "the file to write", into(out_, fileName), kRequired},
                                {"--quick", "", "three rounds", {[this](const std::string&) { rounds_ = 3; }}},
                                {"--check", "", "writes nothing", flag(check_)}}};
    return parse({"program", "What it does.", {numbers, names}, "Exit status: 0."}, static_cast<int>(words.size()),
                 words.data());
  }
  std::string refusal(const std::vector<const char*>& words)
  {
    try
    {
      take(words);
    }
    catch (const UsageError& error)
    {
      return error.what();
    }
    return "";
  }

  double rate_ = 100.0;
  int rounds_ = 8;
  std::optional<double> limit_;
  std::string scene_, out_;
  bool check_ = false;
};

TEST_F(Words, BecomeValues)
{
  EXPECT_FALSE(take({"--rate", "2.5", "a.yaml", "--out=b.csv", "--check"}));
  EXPECT_EQ(rate_, 2.5);
  EXPECT_EQ(scene_, "a.yaml");
  EXPECT_EQ(out_, "b.csv");
  EXPECT_TRUE(check_);
  EXPECT_EQ(rounds_, 8);
  EXPECT_FALSE(limit_);
}

TEST_F(Words, MayBeCutShortWhereNoOtherBeginsSo)
{
  take({"--ra", "3", "--ro=4", "--o", "x"});
  EXPECT_EQ(rate_, 3.0);
  EXPECT_EQ(rounds_, 4);
  EXPECT_EQ(out_, "x");
  EXPECT_EQ(refusal({"--r", "3", "--out", "x"}).rfind("--r: unknown option: expected", 0), 0u);
}

TEST_F(Words, ActInTheirOrderAndTheLastOneCounts)
{
  take({"--rate", "3", "--out", "x", "--rate", "4", "--quick", "--quick"});
  EXPECT_EQ(rate_, 4.0);
  EXPECT_EQ(rounds_, 3);
  take({"--quick", "--rounds", "5", "--out", "x"});
  EXPECT_EQ(rounds_, 5);
  take({"--rounds", "5", "--quick", "--out", "x"});
  EXPECT_EQ(rounds_, 3);
}

TEST_F(Words, AfterAnOptionAreItsValueHoweverTheyLook)
{
  take({"--out", "--rate", "--", "-5.yaml"});
  EXPECT_EQ(out_, "--rate");
  EXPECT_EQ(scene_, "-5.yaml");
  EXPECT_EQ(rate_, 100.0);
}

TEST_F(Words, ThatAreBadAreRefusedByOneLine)
{
  const std::pair<std::vector<const char*>, std::string> cases[] = {
      {{"--rate", "-1", "--out", "x"}, "--rate: -1: expected a finite number > 0"},
      {{"--rate", "1s", "--out", "x"}, "--rate: 1s: expected a finite number > 0"},
      {{"--rate", "", "--out", "x"}, "--rate: nothing: expected a finite number > 0"},
      {{"--rounds", "10", "--out", "x"}, "--rounds: 10: expected an integer from 0 to 9"},
      {{"--limit=inf", "--out", "x"}, "--limit: inf: expected a finite number >= 0"},
      {{"--rate"}, "--rate: nothing: expected a value after it"},
      {{"--out", ""}, "--out: nothing: expected a file name"},
      {{"--rate", "1"}, "--out: missing: expected the file to write; see --help"},
      {{"--out", "x", "a.yaml", "b.yaml"}, "b.yaml: second scene: expected one scene"},
      {{"--fast", "--out", "x"},
       "--fast: unknown option: expected one of those that --help lists: --help, --rate, --rounds, --limit, --out, "
       "--quick, --check"},
  };
  for (const auto& [words, message] : cases) EXPECT_EQ(refusal(words), message);
}

TEST_F(Words, HelpTellsGroupsDefaultsAndWhatIsRequired)
{
  for (const char* word : {"--help", "-h", "--he"})
  {
    const std::optional<std::string> help = take({word});
    ASSERT_TRUE(help) << word;
    for (const char* part : {"What it does.\n", "Usage: program [OPTIONS] [SCENE.yaml]\n", "  SCENE.yaml  ",
                             "\n\nNumbers:\n  --rate R=100  ", "  --rounds N=8  ", "  --limit L  ",
                             "\n\nNames:\n  --out FILE REQUIRED  ", "  --quick  ", "\n\nExit status: 0.\n"})
      EXPECT_NE(help->find(part), std::string::npos) << part << "\n" << *help;
    EXPECT_EQ(help->find("--rat,"), std::string::npos) << "short spellings are not listed";
    EXPECT_EQ(help->find("\n\n\n"), std::string::npos);
  }
}
}  // namespace
}  // namespace ping_pong
