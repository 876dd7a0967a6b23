// The example controllers of docs/ros.md do what they say: the ball keeps bouncing on the paddle.
#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/Contact.h"
#include "sim_client.h"

using namespace ping_pong_sim;

namespace
{
void expectBouncing(const std::string& ns)
{
  ros::NodeHandle nh(ns);
  sim_test::Inbox<Contact> contacts(nh, "contacts");
  sim_test::Inbox<BallStates> balls(nh, "balls");
  const std::string reset = nh.resolveName("ping_pong_sim/reset");
  ASSERT_TRUE(ros::service::waitForService(reset, ros::Duration(sim_test::kPatience)));
  sim_test::Inbox<PaddleStates> paddles(nh, "paddles");
  ASSERT_TRUE(paddles.waitFor([](const PaddleStates& p) { return p.paddles.at(0).command_age >= 0.0; }));
  std_srvs::Trigger trigger;
  ASSERT_TRUE(sim_test::ask(reset, trigger));  // the first fall may have come before the controller
  contacts.clear();
  balls.clear();
  ASSERT_TRUE(contacts.waitForCount(6));
  for (const Contact& contact : contacts.all()) EXPECT_EQ(contact.other, "paddle");
  double highest = 0.0;
  for (const BallStates& state : balls.all())
  {
    if (state.time > contacts.all()[4].time) highest = std::max(highest, state.balls.at(0).pose.position.z);
  }
  std::printf("%s: highest after five bounces %.2f m\n", ns.c_str(), highest);
  EXPECT_GT(highest, 1.15);  // without a stroke 0.8^10 of the first 0.37 m would be left
}
}  // namespace

TEST(Examples, TheCppControllerKeepsTheBallBouncing)
{
  expectBouncing("cpp");
}

TEST(Examples, ThePythonControllerKeepsTheBallBouncing)
{
  expectBouncing("python");
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_examples");
}
