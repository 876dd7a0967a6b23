// A world that waits for somebody to look at it, and a scene that begins again once its ball lies still.
#include <visualization_msgs/MarkerArray.h>

#include "sim_client.h"

using namespace ping_pong_sim;

TEST(Repeat, TheWorldWaitsForItsViewAndBeginsAgainWhenAllIsStill)
{
  ros::NodeHandle nh;
  sim_test::Inbox<SimStatus> status(nh, "status");
  ASSERT_TRUE(status.waitForCount(10));
  EXPECT_EQ(status.last().time, 0.0) << "nobody looks yet";
  sim_test::Inbox<visualization_msgs::MarkerArray> view(nh, "markers");
  // The ball of `drop` comes to rest after 4.70 s; a second later all begins anew.
  ASSERT_TRUE(status.waitFor([](const SimStatus& s) { return s.time > 3.0; }));
  status.clear();
  EXPECT_TRUE(status.waitFor([](const SimStatus& s) { return s.time < 2.0; }));
  double latest = 0.0;
  for (const SimStatus& s : status.all()) latest = std::max(latest, s.time);
  EXPECT_LT(latest, 6.0);
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_repeat");
}
