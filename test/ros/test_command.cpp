// Commands by topic move the paddle in TF. Lockstep: the world is paused, every tick is asked for.
#include "ping_pong_sim/PaddleCommand.h"
#include "sim_client.h"

using ping_pong_sim::PaddleCommand;
using sim_test::step;

namespace
{
constexpr double kTick = 0.01;  ///< [s]

class Command : public testing::Test
{
protected:
  void SetUp() override
  {
    sim_test::reset();
    ASSERT_TRUE(sim_test::eventually([this] { return commands_.getNumSubscribers() > 0; }));
    ASSERT_TRUE(sim_test::eventually([this] { return twists_.getNumSubscribers() > 0; }));
  }

  /// Ticks until the paddle obeys in this mode; returns the state after that tick.
  ping_pong_sim::Step::Response stepUntil(std::uint8_t mode)
  {
    ping_pong_sim::Step::Response state;
    EXPECT_TRUE(sim_test::eventually(
        [&]
        {
          state = step(kTick);
          return state.paddles.paddles.at(0).mode == mode;
        }));
    return state;
  }

  static PaddleCommand make(std::uint8_t mode)
  {
    PaddleCommand command;
    command.header.frame_id = "world";
    command.mode = mode;
    return command;
  }

  ros::NodeHandle nh_;
  ros::Publisher commands_ = nh_.advertise<PaddleCommand>("paddle/command", 1);
  ros::Publisher twists_ = nh_.advertise<geometry_msgs::Twist>("paddle/cmd_vel", 1);
  sim_test::Frames frames_;
};
}  // namespace

TEST_F(Command, VelocityMovesThePaddleInTf)
{
  PaddleCommand command = make(PaddleCommand::VELOCITY);
  command.twist.linear.y = 2.0;
  commands_.publish(command);
  stepUntil(PaddleCommand::VELOCITY);
  const auto before = step(0.1);  // it has reached its speed by then
  const auto after = step(0.1);
  EXPECT_NEAR(after.paddles.paddles[0].twist.linear.y, 2.0, 1e-9);
  EXPECT_NEAR(after.paddles.paddles[0].pose.position.y - before.paddles.paddles[0].pose.position.y, 0.2, 1e-9);
  const auto frame = frames_.at("paddle", after.paddles.header.stamp);
  EXPECT_EQ(frame.header.stamp, after.paddles.header.stamp);
  EXPECT_NEAR(frame.transform.translation.y, after.paddles.paddles[0].pose.position.y, 1e-12);
}

TEST_F(Command, AccelerationIsASwing)
{
  PaddleCommand command = make(PaddleCommand::ACCELERATION);
  command.accel.linear.z = 10.0;
  commands_.publish(command);
  const auto first = stepUntil(PaddleCommand::ACCELERATION);
  EXPECT_NEAR(first.paddles.paddles[0].twist.linear.z, 10.0 * kTick, 1e-9);
  const auto later = step(0.1);
  EXPECT_NEAR(later.paddles.paddles[0].twist.linear.z, 10.0 * (kTick + 0.1), 1e-9);
  EXPECT_NEAR(later.paddles.paddles[0].pose.position.z, 1.0 + 0.5 * 10.0 * std::pow(kTick + 0.1, 2), 1e-9);
}

TEST_F(Command, PoseIsReachedAndKept)
{
  PaddleCommand command = make(PaddleCommand::POSE);
  command.pose.position.x = -1.2;
  command.pose.position.y = 0.3;
  command.pose.position.z = 1.1;
  command.pose.orientation.z = 2.0 * std::sin(0.4);  // not of unit length: it is normalised
  command.pose.orientation.w = 2.0 * std::cos(0.4);
  commands_.publish(command);
  stepUntil(PaddleCommand::POSE);
  const auto pose = step(0.4).paddles.paddles[0].pose;
  EXPECT_NEAR(pose.position.x, -1.2, 1e-6);
  EXPECT_NEAR(pose.position.y, 0.3, 1e-6);
  EXPECT_NEAR(pose.position.z, 1.1, 1e-6);
  EXPECT_NEAR(std::abs(pose.orientation.z), std::sin(0.4), 1e-6);
}

TEST_F(Command, FrameOfABodyIsExpressedInTheWorld)
{
  PaddleCommand command = make(PaddleCommand::POSE);
  command.header.frame_id = "table";  // at 3, 0, 0.76
  command.pose.position.x = -4.2;
  command.pose.position.z = 0.34;
  command.pose.orientation.w = 1.0;
  commands_.publish(command);
  stepUntil(PaddleCommand::POSE);
  const auto pose = step(0.4).paddles.paddles[0].pose;
  EXPECT_NEAR(pose.position.x, -1.2, 1e-6);
  EXPECT_NEAR(pose.position.z, 1.1, 1e-6);
}

TEST_F(Command, CmdVelIsInThePaddlesOwnFrameAndTurnsAlong)
{
  geometry_msgs::Twist twist;
  twist.linear.y = 1.0;
  twist.angular.z = 4.0;
  twists_.publish(twist);
  stepUntil(PaddleCommand::VELOCITY);
  const auto paddle = step(0.3).paddles.paddles[0];
  // After turning by some angle about z, "left" has turned with it.
  const double angle = 2.0 * std::atan2(paddle.pose.orientation.z, paddle.pose.orientation.w);
  EXPECT_GT(angle, 0.9);
  EXPECT_NEAR(paddle.twist.linear.x, -std::sin(angle), 0.06);  // one tick is 0.04 rad
  EXPECT_NEAR(paddle.twist.linear.y, std::cos(angle), 0.06);
}

TEST_F(Command, AnImpossibleOneIsLimited)
{
  PaddleCommand command = make(PaddleCommand::VELOCITY);
  command.twist.linear.z = 1000.0;
  commands_.publish(command);
  const auto first = stepUntil(PaddleCommand::VELOCITY).paddles.paddles[0];
  EXPECT_LE(first.twist.linear.z, 400.0 * kTick + 1e-9);
  EXPECT_LE(step(0.2).paddles.paddles[0].twist.linear.z, 20.0 + 1e-9);
}

TEST_F(Command, HitGivesTheBallTheSpeedOfTheBlade)
{
  PaddleCommand command = make(PaddleCommand::VELOCITY);
  command.twist.linear.x = 5.0;
  commands_.publish(command);
  stepUntil(PaddleCommand::VELOCITY);
  std::vector<ping_pong_sim::Contact> hits = step(0.2).contacts;
  ASSERT_EQ(hits.size(), 1u);
  const double e = 0.8;
  const double u = 5.0;
  EXPECT_EQ(hits[0].other, "paddle");
  EXPECT_NEAR(hits[0].normal.x, 1.0, 1e-9);
  EXPECT_NEAR(hits[0].velocity_before.x, 0.0, 1e-12);
  EXPECT_NEAR(hits[0].velocity_other.x, u, 1e-9);
  EXPECT_NEAR(hits[0].velocity_after.x, -e * (0.0 - u) + u, 1e-9);
  EXPECT_NEAR(step(kTick).balls.balls[0].twist.linear.x, (1.0 + e) * u, 1e-9);
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_command");
}
