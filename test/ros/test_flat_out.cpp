// real_time_factor 0: faster than real time, while services answer and messages come at a bounded rate.
#include "ping_pong_sim/BallStates.h"
#include "sim_client.h"

using namespace ping_pong_sim;

TEST(FlatOut, IsMuchFasterThanRealTime)
{
  ros::NodeHandle nh;
  sim_test::Inbox<SimStatus> status(nh, "status");
  ASSERT_TRUE(status.waitFor([](const SimStatus& s) { return s.real_time_factor > 0.0; }));
  EXPECT_TRUE(status.waitFor([](const SimStatus& s) { return s.real_time_factor > 10.0; }))
      << status.last().real_time_factor;
  std::printf("real-time factor: %.0f\n", status.last().real_time_factor);
}

TEST(FlatOut, MessagesComeAtABoundedRate)  // 100 Hz of wall time
{
  ros::NodeHandle nh;
  sim_test::Inbox<BallStates> balls(nh, "balls");
  ASSERT_TRUE(balls.waitForCount(1));
  balls.clear();
  const double start = sim_test::wallNow();
  ASSERT_TRUE(balls.waitForCount(50));
  EXPECT_GT(sim_test::wallNow() - start, 0.4);
}

TEST(FlatOut, ServicesAnswer)
{
  const double start = sim_test::wallNow();
  for (int i = 0; i < 20; ++i) sim_test::reset();
  EXPECT_LT(sim_test::wallNow() - start, 2.0);
  sim_test::pause(true);
  EXPECT_TRUE(sim_test::step(0.01).success);
  sim_test::pause(false);
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_flat_out");
}
