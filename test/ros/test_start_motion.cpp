// A paddle that its scene starts in motion (0.5 m/s to the left) keeps it until its first command, and has it again after a reset.
#include "ping_pong_sim/PaddleCommand.h"
#include "ping_pong_sim/PaddleStates.h"
#include "sim_client.h"

using namespace ping_pong_sim;

namespace
{
/// It has moved evenly since the start, for longer than ~command_timeout (0.1 s), though nobody commands it.
bool movesByItself(const PaddleStates& states)
{
  const PaddleState& paddle = states.paddles.at(0);
  return states.time > 0.2 && paddle.mode == PaddleCommand::VELOCITY && paddle.command_age == -1.0 &&
         paddle.twist.linear.y == 0.5 && std::abs(paddle.pose.position.y - 0.5 * states.time) < 1e-9;
}
}  // namespace

TEST(StartMotion, LastsUntilTheFirstCommandAndComesBackWithAReset)
{
  ros::NodeHandle nh;
  sim_test::Inbox<PaddleStates> paddles(nh, "paddles");
  ros::Publisher commands = nh.advertise<PaddleCommand>("paddle/command", 1);
  ASSERT_TRUE(sim_test::eventually([&] { return commands.getNumSubscribers() > 0 && paddles.connected(); }));
  EXPECT_TRUE(paddles.waitFor(movesByItself));

  commands.publish(PaddleCommand());
  EXPECT_TRUE(
      paddles.waitFor([](const PaddleStates& s)
                      { return s.paddles.at(0).mode == PaddleCommand::HOLD && s.paddles[0].twist.linear.y == 0.0; }));
  sim_test::reset();
  paddles.clear();
  EXPECT_TRUE(paddles.waitFor(movesByItself));
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_start_motion");
}
