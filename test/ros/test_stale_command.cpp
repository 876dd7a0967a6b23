// A paddle whose commands stop coming holds still after ~command_timeout, here 0.3 s of simulated time.
#include "ping_pong_sim/PaddleCommand.h"
#include "ping_pong_sim/PaddleStates.h"
#include "sim_client.h"

using namespace ping_pong_sim;

TEST(StaleCommand, HoldsThePaddleAfterTheTimeout)
{
  ros::NodeHandle nh;
  sim_test::Inbox<PaddleStates> paddles(nh, "paddles");
  ros::Publisher commands = nh.advertise<PaddleCommand>("paddle/command", 1);
  ASSERT_TRUE(sim_test::eventually([&] { return commands.getNumSubscribers() > 0 && paddles.connected(); }));
  PaddleCommand command;
  command.mode = PaddleCommand::VELOCITY;
  command.twist.linear.y = 0.5;
  commands.publish(command);

  const auto in_mode = [](std::uint8_t mode)
  { return [mode](const PaddleStates& p) { return p.paddles.at(0).mode == mode; }; };
  ASSERT_TRUE(paddles.waitFor(in_mode(PaddleCommand::VELOCITY)));
  ASSERT_TRUE(
      paddles.waitFor([](const PaddleStates& p)
                      { return p.paddles.at(0).mode == PaddleCommand::HOLD && p.paddles.at(0).command_age > 0.0; }));

  // It moved on for the timeout, and not for longer: ages are told in every tick.
  double longest = 0.0;
  for (const PaddleStates& state : paddles.all())
  {
    if (state.paddles[0].mode == PaddleCommand::VELOCITY) longest = std::max(longest, state.paddles[0].command_age);
  }
  EXPECT_NEAR(longest, 0.3, 0.011);  // a tick is 0.01 s
  EXPECT_TRUE(paddles.waitFor([](const PaddleStates& p)
                              { return p.paddles.at(0).command_age > 0.35 && p.paddles.at(0).twist.linear.y == 0.0; }))
      << "it does not stand still";
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_stale_command");
}
