// Progress: one line, rewritten in place, on a terminal alone.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <regex>

#include "apps/progress.h"

namespace ping_pong
{
namespace
{
/// Both ends of a terminal in memory.
class Terminal
{
public:
  Terminal() : screen(posix_openpt(O_RDWR | O_NOCTTY))
  {
    grantpt(screen);
    unlockpt(screen);
    program = open(ptsname(screen), O_RDWR | O_NOCTTY);
  }
  ~Terminal()
  {
    close(program);
    close(screen);
  }
  int screen, program = -1;
};

std::string readable(int file)
{
  std::string text;
  char block[1000];
  for (pollfd asked = {file, POLLIN, 0}; poll(&asked, 1, 0) == 1 && (asked.revents & POLLIN) != 0;)
  {
    const ssize_t size = read(file, block, sizeof block);
    if (size <= 0) break;
    text.append(block, static_cast<std::size_t>(size));
  }
  return text;
}

using Clock = std::chrono::steady_clock;
const std::string kToEmptyLine = "\r\x1b[K";

TEST(Progress, RewritesOneLineAFewTimesASecondAndClearsIt)
{
  const Terminal terminal;
  std::string line;
  {
    Progress progress("work", terminal.program);
    const Clock::time_point start = Clock::now();
    while (line.empty() && Clock::now() < start + std::chrono::seconds(10))
    {
      for (int i = 0; i < 1000; ++i) progress.show(0.25, "deep in it");
      line = readable(terminal.screen);
    }
    EXPECT_GE(Clock::now() - start, std::chrono::milliseconds(400)) << "what is done at once shows nothing";
  }
  // A quarter took half a second, or some more on a busy machine: three times as long is left.
  EXPECT_TRUE(std::regex_match(line, std::regex("\r\x1b\\[Kwork: 25 %, \\d+ s left, deep in it"))) << line;
  EXPECT_EQ(readable(terminal.screen), kToEmptyLine);
}

TEST(Progress, OfAStretchIsThatOfTheWhole)
{
  const Terminal terminal;
  Progress progress("work", terminal.program);
  const PartDone done = progress.stretch(0.5, 0.9, "end");
  std::string line;
  for (const Clock::time_point start = Clock::now(); line.empty() && Clock::now() < start + std::chrono::seconds(10);)
  {
    done(0.5);
    line = readable(terminal.screen);
  }
  EXPECT_EQ(line.rfind(kToEmptyLine + "work: 70 %, ", 0), 0u) << line;
}

TEST(Progress, WritesNothingElsewhere)
{
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  {
    Progress progress("work", ends[1]);
    for (const Clock::time_point start = Clock::now(); Clock::now() < start + std::chrono::milliseconds(700);)
      progress.show(0.5);
  }
  EXPECT_EQ(readable(ends[0]), "");
  close(ends[0]);
  close(ends[1]);
}

TEST(Progress, TellsTimesForPeople)
{
  EXPECT_EQ(roughTime(0.4), "0 s");
  EXPECT_EQ(roughTime(99.0), "99 s");
  EXPECT_EQ(roughTime(120.0), "2 min");
  EXPECT_EQ(roughTime(4.0 * 3600.0 + 61.0), "4 h 1 min");
}
}  // namespace
}  // namespace ping_pong
