// The tray with 60 balls at 500 Hz keeps real time, tells every tick once, and all of a tick in one message.
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include "ping_pong_sim/BallStates.h"
#include "sim_client.h"

using namespace ping_pong_sim;

namespace
{
class RealTime : public testing::Test
{
protected:
  ros::NodeHandle nh_;
};
}  // namespace

TEST_F(RealTime, IsHeldAt500Hz)
{
  sim_test::Inbox<BallStates> balls(nh_, "balls");
  ASSERT_TRUE(balls.waitForCount(1));
  balls.clear();
  const double start = sim_test::wallNow();
  ASSERT_TRUE(balls.waitForCount(1500));
  const double wall = sim_test::wallNow() - start;
  const std::vector<BallStates> all = balls.all();
  const double simulated = all[1499].time - all[0].time;
  std::printf("%.3f s simulated in %.3f s\n", simulated, wall);
  EXPECT_NEAR(wall / simulated, 1.0, 0.05);
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    ASSERT_EQ((all[i].header.stamp - all[i - 1].header.stamp).toNSec(), 2000000) << "tick " << i;
    ASSERT_EQ(all[i].balls.size(), 60u);
  }
}

TEST_F(RealTime, OneTfMessageHoldsAllOfATick)
{
  sim_test::Inbox<tf2_msgs::TFMessage> tf(nh_, "/tf");
  ASSERT_TRUE(tf.waitForCount(100));
  ros::Time last;
  for (const tf2_msgs::TFMessage& message : tf.all())
  {
    ASSERT_EQ(message.transforms.size(),
              60u + 1u);  // and the newest; the tray has no paddle; static bodies are on /tf_static
    EXPECT_GT(message.transforms[0].header.stamp, last);
    last = message.transforms[0].header.stamp;
    for (const auto& transform : message.transforms) EXPECT_EQ(transform.header.stamp, last);
  }
}

TEST_F(RealTime, MarkersHaveTheirOwnRateAndACrowdIsOneList)
{
  using visualization_msgs::Marker;
  sim_test::Inbox<visualization_msgs::MarkerArray> markers(nh_, "markers");
  ASSERT_TRUE(markers.waitForCount(1));
  markers.clear();
  const double start = sim_test::wallNow();
  ASSERT_TRUE(markers.waitForCount(30));
  EXPECT_NEAR(sim_test::wallNow() - start, 1.0, 0.3);  // 30 Hz
  for (const Marker& marker : markers.last().markers)
  {
    EXPECT_NE(marker.type, Marker::SPHERE);
    if (marker.type != Marker::SPHERE_LIST) continue;
    EXPECT_EQ(marker.points.size(), 60u);
  }
}

TEST_F(RealTime, StatusComesTenTimesASecond)
{
  sim_test::Inbox<SimStatus> status(nh_, "status");
  ASSERT_TRUE(status.waitForCount(1));
  status.clear();
  const double start = sim_test::wallNow();
  ASSERT_TRUE(status.waitForCount(10));
  EXPECT_NEAR(sim_test::wallNow() - start, 1.0, 0.3);
  EXPECT_EQ(status.last().balls, 60u);
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_real_time");
}
