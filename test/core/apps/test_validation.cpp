// The models against measured rebounds and flights: `validate --check` holds them to their bounds.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace
{
struct Outcome
{
  int status = -1;
  std::string text;
};

Outcome validate(const std::string& arguments)
{
  Outcome run;
  std::FILE* pipe = popen((std::string("\"") + VALIDATE + "\" " + arguments + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return run;
  std::array<char, 4096> line;
  while (std::fgets(line.data(), line.size(), pipe) != nullptr) run.text += line.data();
  const int status = pclose(pipe);
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return run;
}

TEST(Validation, ModelsKeepTheirBoundsOnMeasuredData)
{
  const Outcome run = validate("--check --data \"" DATA_DIR "\"");
  std::printf("%s", run.text.c_str());
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.text.find("FAILED"), std::string::npos);
}

TEST(Validation, SaysWhichFileIsMissing)
{
  const Outcome run = validate("--check --data /nowhere");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.text.find("/nowhere/rubber/racket01_sample.csv: cannot be read"), std::string::npos) << run.text;
}

TEST(Validation, RefusesUnknownArguments)
{
  const Outcome run = validate("--frobnicate");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.text,
            "validate: --frobnicate: unknown option: expected one of those that --help lists: --help, --data, --scene, "
            "--out, --check\n");
  EXPECT_EQ(validate("--data").text, "validate: --data: nothing: expected a value after it\n");
}

TEST(Validation, ExplainsItself)
{
  const Outcome run = validate("--help");
  EXPECT_EQ(run.status, 0);
  for (const char* part : {"\nInput:\n", "--data DIR=test/data ", "--scene FILE=config/scenes/rally.yaml",
                           "\nOutput:\n", "--out DIR=. ", "--check"})
    EXPECT_NE(run.text.find(part), std::string::npos) << part;
}
}  // namespace
