// The estimate by which crowds are measured.
#include <gtest/gtest.h>

#include <stdexcept>

#include "crowd/quiet_time.h"

namespace ping_pong::bench
{
namespace
{
TEST(QuietTime, TakesTheLeastOfEachTick)
{
  QuietTime time;
  time.add({1.0, 5.0, 2.0, 4.0});
  EXPECT_EQ(time.total(), 12.0);
  time.add({3.0, 2.0, 2.5, 1.0});
  EXPECT_EQ(time.total(), 1.0 + 2.0 + 2.0 + 1.0);
  EXPECT_EQ(time.runs(), 2u);
}

TEST(QuietTime, TellsTheCostliestWholePart)
{
  QuietTime time;
  time.add({1.0, 2.0, 4.0, 1.0, 9.0});
  EXPECT_EQ(time.mostOf(2), 5.0);  // the last tick has no partner
  EXPECT_EQ(time.mostOf(6), 0.0);
}

TEST(QuietTime, HasSettledWhenFiveRunsInARowHardlyLowerIt)
{
  QuietTime time;
  time.add({2.0, 2.0});
  for (int run = 0; run < 4; ++run) time.add({3.0, 3.0});
  EXPECT_FALSE(time.settled()) << "four";
  time.add({3.0, 3.0});
  EXPECT_TRUE(time.settled());
  time.add({1.0, 3.0});
  EXPECT_FALSE(time.settled());
}

TEST(QuietTime, SettlesLaterIfAskedTo)
{
  QuietTime time(7);
  for (int run = 0; run < 7; ++run) time.add({2.0, 2.0});
  EXPECT_FALSE(time.settled()) << "the first one cannot lower it";
  time.add({2.0, 2.0});
  EXPECT_TRUE(time.settled());
}

TEST(QuietTime, RefusesARunOfOtherLength)
{
  QuietTime time;
  time.add({1.0, 2.0});
  EXPECT_THROW(time.add({1.0}), std::runtime_error);
}
}  // namespace
}  // namespace ping_pong::bench
