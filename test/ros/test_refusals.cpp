// Bad commands and bad calls: refused with a reason, counted, and the simulation goes on.
#include <limits>

#include "ping_pong_sim/DeleteBall.h"
#include "ping_pong_sim/PaddleCommand.h"
#include "ping_pong_sim/SetBallState.h"
#include "ping_pong_sim/SetBodyPose.h"
#include "ping_pong_sim/SpawnBall.h"
#include "sim_client.h"

using namespace ping_pong_sim;

namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

class Refusal : public testing::Test
{
protected:
  void SetUp() override
  {
    ASSERT_TRUE(sim_test::eventually([this] { return commands_.getNumSubscribers() > 0; }));
    ASSERT_TRUE(sim_test::eventually([this] { return twists_.getNumSubscribers() > 0; }));
    ASSERT_TRUE(status_.waitForCount(1));
    before_ = status_.last().rejected;
  }

  void TearDown() override
  {
    const double time = status_.last().time;
    EXPECT_TRUE(status_.waitFor([=](const SimStatus& s) { return s.time > time; })) << "it does not go on";
  }

  /// Exactly one refusal more, and its reason says this.
  void expectRefused(const std::string& reason)
  {
    EXPECT_TRUE(
        status_.waitFor([&](const SimStatus& s)
                        { return s.rejected == before_ + 1 && s.rejected_reason.find(reason) != std::string::npos; }))
        << "last reason: " << status_.last().rejected_reason;
  }

  static PaddleCommand velocity()
  {
    PaddleCommand command;
    command.mode = PaddleCommand::VELOCITY;
    return command;
  }

  template <class Service>
  void expectRefusedCall(const std::string& name, const typename Service::Request& request, const std::string& reason)
  {
    const auto response = sim_test::call<Service>(name, request);
    EXPECT_FALSE(response.success);
    EXPECT_NE(response.message.find(reason), std::string::npos) << response.message;
    expectRefused(reason);
  }

  ros::NodeHandle nh_;
  ros::Publisher commands_ = nh_.advertise<PaddleCommand>("paddle/command", 1);
  ros::Publisher twists_ = nh_.advertise<geometry_msgs::Twist>("paddle/cmd_vel", 1);
  sim_test::Inbox<SimStatus> status_{nh_, "status"};
  std::uint64_t before_ = 0;
};
}  // namespace

TEST_F(Refusal, CommandWithNotANumber)
{
  PaddleCommand command = velocity();
  command.twist.linear.x = kNan;
  commands_.publish(command);
  expectRefused("twist.linear.x");
}

TEST_F(Refusal, CommandWithInfinity)
{
  PaddleCommand command = velocity();
  command.mode = PaddleCommand::ACCELERATION;
  command.accel.angular.z = kInf;
  commands_.publish(command);
  expectRefused("accel.angular.z");
}

TEST_F(Refusal, CommandWithAZeroQuaternion)
{
  PaddleCommand command = velocity();
  command.mode = PaddleCommand::POSE;
  commands_.publish(command);
  expectRefused("zero quaternion");
}

TEST_F(Refusal, CommandInAnUnknownFrame)
{
  PaddleCommand command = velocity();
  command.header.frame_id = "moon";
  commands_.publish(command);
  expectRefused("moon");
}

TEST_F(Refusal, CommandInAnUnknownMode)
{
  PaddleCommand command = velocity();
  command.mode = 77;
  commands_.publish(command);
  expectRefused("mode: 77");
}

TEST_F(Refusal, CmdVelWithNotANumber)
{
  geometry_msgs::Twist twist;
  twist.angular.y = kNan;
  twists_.publish(twist);
  expectRefused("twist.angular.y");
}

TEST_F(Refusal, ABadCommandDoesNotStopAGoodOne)
{
  sim_test::Inbox<PaddleStates> paddles(nh_, "paddles");
  const auto moves = [](const PaddleStates& p) { return p.paddles.at(0).mode == PaddleCommand::VELOCITY; };
  PaddleCommand good = velocity();
  good.twist.linear.y = 0.1;
  PaddleCommand bad = good;
  bad.twist.linear.y = kNan;
  commands_.publish(good);
  ASSERT_TRUE(paddles.waitFor(moves));
  commands_.publish(bad);
  expectRefused("twist.linear.y");
  paddles.clear();
  ASSERT_TRUE(paddles.waitForCount(1));
  EXPECT_TRUE(moves(paddles.all().front()));
}

TEST_F(Refusal, SpawnWithANegativeRadius)
{
  SpawnBall::Request request;
  request.position.z = 3.0;
  request.radius = -0.02;
  expectRefusedCall<SpawnBall>("spawn_ball", request, "radius");
}

TEST_F(Refusal, SpawnWithNotANumber)
{
  SpawnBall::Request request;
  request.position.z = kNan;
  expectRefusedCall<SpawnBall>("spawn_ball", request, "position.z");
}

TEST_F(Refusal, SpawnOfUnknownMaterial)
{
  SpawnBall::Request request;
  request.position.z = 3.0;
  request.material = "cheese";
  expectRefusedCall<SpawnBall>("spawn_ball", request, "cheese");
}

TEST_F(Refusal, DeleteOfAnUnknownBall)
{
  DeleteBall::Request request;
  request.id = 12345;
  expectRefusedCall<DeleteBall>("delete_ball", request, "12345");
}

TEST_F(Refusal, StateOfAnUnknownBall)
{
  SetBallState::Request request;
  request.id = 12345;
  request.pose.orientation.w = 1.0;
  expectRefusedCall<SetBallState>("set_ball_state", request, "12345");
}

TEST_F(Refusal, StateWithAZeroQuaternion)
{
  expectRefusedCall<SetBallState>("set_ball_state", {}, "zero quaternion");
}

TEST_F(Refusal, StateInAnUnknownFrame)
{
  SetBallState::Request request;
  request.frame_id = "moon";
  request.pose.orientation.w = 1.0;
  expectRefusedCall<SetBallState>("set_ball_state", request, "moon");
}

TEST_F(Refusal, PoseOfAnUnknownBody)
{
  SetBodyPose::Request request;
  request.body = "moon";
  request.pose.orientation.w = 1.0;
  expectRefusedCall<SetBodyPose>("set_body_pose", request, "moon");
}

TEST_F(Refusal, PoseWithInfinity)
{
  SetBodyPose::Request request;
  request.body = "table";
  request.pose.position.x = kInf;
  request.pose.orientation.w = 1.0;
  expectRefusedCall<SetBodyPose>("set_body_pose", request, "position.x");
}

TEST_F(Refusal, StepOfARunningWorld)
{
  Step::Request request;
  request.duration = 0.01;
  expectRefusedCall<Step>("step", request, "~pause");
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_refusals");
}
