// /clock: never zero, never back (also through reset and change of scene), at its own rate, in step with the messages.
#include <rosgraph_msgs/Clock.h>

#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/LoadScene.h"
#include "sim_client.h"

using namespace ping_pong_sim;

namespace
{
class Clock : public testing::Test
{
protected:
  void expectForward()
  {
    ros::Time last;
    for (const rosgraph_msgs::Clock& message : clock_.all())
    {
      EXPECT_FALSE(message.clock.isZero());
      EXPECT_GE(message.clock, last);
      last = message.clock;
    }
  }

  ros::NodeHandle nh_;
  sim_test::Inbox<rosgraph_msgs::Clock> clock_{nh_, "/clock"};
};
}  // namespace

TEST_F(Clock, RunsForwardThroughResets)
{
  for (int i = 0; i < 5; ++i)
  {
    const std::size_t seen = clock_.all().size();
    ASSERT_TRUE(clock_.waitForCount(seen + 5));
    sim_test::reset();
  }
  expectForward();
}

TEST_F(Clock, RunsForwardThroughAChangeOfScene)
{
  LoadScene::Request request;
  request.scene = "bounce";
  ASSERT_TRUE(clock_.waitForCount(10));
  ASSERT_TRUE(sim_test::call<LoadScene>("load_scene", request).success);
  const std::size_t seen = clock_.all().size();
  ASSERT_TRUE(clock_.waitForCount(seen + 10));
  expectForward();
}

TEST_F(Clock, HasItsOwnRate)  // 50 Hz, while the world ticks at 200 Hz
{
  sim_test::Inbox<BallStates> balls(nh_, "balls");
  ASSERT_TRUE(balls.waitForCount(1));
  balls.clear();
  clock_.clear();
  ASSERT_TRUE(balls.waitForCount(200));
  const double count = static_cast<double>(clock_.all().size());
  EXPECT_GT(count, 30.0);  // half the rate and more, on a machine that has other things to do
  EXPECT_LT(count, 60.0);
}

TEST_F(Clock, IsWhatOtherNodesCallNow)
{
  ASSERT_TRUE(sim_test::eventually([] { return !ros::Time::now().isZero(); }));
  const ros::Time before = ros::Time::now();
  EXPECT_TRUE(sim_test::eventually([&] { return ros::Time::now() > before; }));
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_clock");
}
