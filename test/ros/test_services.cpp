// Pause, step, reset, spawn, delete, set state, set pose: what they change, and that it is seen, also while paused.
#include <rosgraph_msgs/Clock.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>

#include "ping_pong_sim/DeleteBall.h"
#include "ping_pong_sim/PaddleCommand.h"
#include "ping_pong_sim/SetBallState.h"
#include "ping_pong_sim/SetBodyPose.h"
#include "ping_pong_sim/SpawnBall.h"
#include "sim_client.h"

using namespace ping_pong_sim;
using sim_test::step;

namespace
{
SetBodyPose::Response putBody(const std::string& name, double x, double z)
{
  SetBodyPose::Request request;
  request.body = name;
  request.pose.position.x = x;
  request.pose.position.z = z;
  request.pose.orientation.w = 1.0;
  return sim_test::call<SetBodyPose>("set_body_pose", request);
}

class PausedWorld : public testing::Test
{
protected:
  void SetUp() override
  {
    sim_test::pause(true);
    sim_test::reset();
  }

  static SpawnBall::Response spawn(double x, double y, double z)
  {
    SpawnBall::Request request;
    request.position.x = x;
    request.position.y = y;
    request.position.z = z;
    request.velocity.x = 1.0;
    request.color.g = request.color.a = 1.0f;
    return sim_test::call<SpawnBall>("spawn_ball", request);
  }

  ros::NodeHandle nh_;
};
}  // namespace

TEST_F(PausedWorld, PauseStopsTimeAndStartsItAgain)
{
  sim_test::Inbox<SimStatus> status(nh_, "status");
  ASSERT_TRUE(status.waitFor([](const SimStatus& s) { return s.paused; }));
  const double time = status.last().time;
  status.clear();
  ASSERT_TRUE(status.waitForCount(4));
  EXPECT_EQ(status.last().time, time);
  sim_test::pause(false);
  EXPECT_TRUE(status.waitFor([=](const SimStatus& s) { return !s.paused && s.time > time + 0.1; }));
}

TEST_F(PausedWorld, StepAdvancesByExactlyTheDuration)
{
  const auto first = step(0.01);
  ASSERT_TRUE(first.success) << first.message;
  const auto second = step(0.0253);  // two ticks and a shorter one
  EXPECT_NEAR(second.time - first.time, 0.0253, 1e-12);
  EXPECT_NEAR((second.balls.header.stamp - first.balls.header.stamp).toSec(), 0.0253, 1e-9);
  EXPECT_EQ(second.balls.balls.size(), 2u);
  EXPECT_EQ(second.paddles.paddles.size(), 1u);
}

TEST_F(PausedWorld, StepRefusesWhatIsNoDuration)
{
  for (const double duration : {0.0, -0.1, 1e9, std::nan("")})
  {
    const auto response = step(duration);
    EXPECT_FALSE(response.success);
    EXPECT_NE(response.message.find("duration"), std::string::npos);
  }
}

TEST_F(PausedWorld, EveryTickOfAStepIsPublished)
{
  sim_test::Inbox<BallStates> balls(nh_, "balls");
  ASSERT_TRUE(balls.waitForCount(1)) << "a newcomer to a paused world is told the state";
  balls.clear();
  step(0.1);
  ASSERT_TRUE(balls.waitForCount(10));
  EXPECT_EQ(balls.all().size(), 10u);
}

TEST_F(PausedWorld, SpawnedBallFliesAndDeletedBallIsGone)
{
  const auto spawned = spawn(0.0, -2.0, 1.5);
  ASSERT_TRUE(spawned.success) << spawned.message;
  const auto state = step(0.1);
  ASSERT_EQ(state.balls.balls.size(), 3u);
  EXPECT_EQ(state.balls.balls[2].id, spawned.id);
  EXPECT_NEAR(state.balls.balls[2].pose.position.x, 0.1, 1e-9);
  EXPECT_EQ(state.balls.balls[2].radius, 0.020);

  DeleteBall::Request request;
  request.id = spawned.id;
  EXPECT_TRUE(sim_test::call<DeleteBall>("delete_ball", request).success);
  EXPECT_EQ(step(0.01).balls.balls.size(), 2u);
}

TEST_F(PausedWorld, SpawnedBallIsSeenInTfAndMarkersWithoutAStep)
{
  sim_test::Frames frames;
  sim_test::Inbox<visualization_msgs::MarkerArray> markers(nh_, "markers");
  const auto spawned = spawn(0.5, -2.0, 1.5);
  const std::string frame = "ball_" + std::to_string(spawned.id);
  EXPECT_NEAR(frames.at(frame).transform.translation.x, 0.5, 1e-12);
  EXPECT_TRUE(markers.waitFor(
      [&](const visualization_msgs::MarkerArray& array)
      {
        for (const auto& marker : array.markers)
        {
          if (marker.ns == "balls" && marker.header.frame_id == frame && marker.color.g == 1.0f) return true;
        }
        return false;
      }));
}

TEST_F(PausedWorld, TheNewestBallHasAFrameOfItsOwn)
{
  sim_test::Frames frames;
  const auto isAt = [&](double x)
  {
    return sim_test::eventually([&] { return std::abs(frames.at("newest_ball").transform.translation.x - x) < 1e-12; });
  };
  const auto first = spawn(0.5, -2.0, 1.5), second = spawn(-0.5, -2.0, 1.5);
  ASSERT_TRUE(first.success && second.success) << first.message << second.message;
  EXPECT_TRUE(isAt(-0.5));
  DeleteBall::Request request;
  request.id = second.id;
  ASSERT_TRUE(sim_test::call<DeleteBall>("delete_ball", request).success);
  step(0.1);  // a transform is sent only when its stamp has advanced
  EXPECT_TRUE(isAt(0.5 + 0.1));
}

TEST_F(PausedWorld, LateListenersSeeWhereThingsAre)
{
  sim_test::Frames frames;  // subscribes now, while nothing happens
  EXPECT_EQ(frames.at("ball_0").child_frame_id, "ball_0");
  EXPECT_EQ(frames.at("paddle").child_frame_id, "paddle");
  EXPECT_EQ(frames.at("table").child_frame_id, "table");
  sim_test::Inbox<visualization_msgs::MarkerArray> bodies(nh_, "body_markers");
  ASSERT_TRUE(bodies.waitForCount(1));
  const auto& markers = bodies.last().markers;
  const auto added = std::count_if(markers.begin(), markers.end(),
                                   [](const visualization_msgs::Marker& marker)
                                   { return marker.action == visualization_msgs::Marker::ADD; });
  EXPECT_EQ(added, 3 + 1);  // table; paddle
}

TEST_F(PausedWorld, SetBallStatePutsTheBallElsewhere)
{
  SetBallState::Request request;
  request.id = 1;
  request.frame_id = "paddle";  // at -1, 0, 1
  request.pose.position.y = -2.0;
  request.pose.orientation.w = 5.0;
  request.twist.linear.z = 3.0;
  request.twist.angular.y = 100.0;
  const auto response = sim_test::call<SetBallState>("set_ball_state", request);
  ASSERT_TRUE(response.success) << response.message;
  const auto ball = step(0.1).balls.balls.at(1);
  EXPECT_NEAR(ball.pose.position.x, -1.0, 1e-9);
  EXPECT_NEAR(ball.pose.position.y, -2.0, 1e-9);
  EXPECT_NEAR(ball.pose.position.z, 1.3, 1e-9);
  EXPECT_NEAR(ball.twist.angular.y, 100.0, 1e-9);
}

TEST_F(PausedWorld, SetBodyPoseMovesTableAndPaddle)
{
  sim_test::Frames frames;
  for (const auto& [name, x] : {std::pair<std::string, double>{"table", 4.0}, {"paddle", -2.0}})
  {
    EXPECT_TRUE(putBody(name, x, 0.0).success);
    EXPECT_TRUE(sim_test::eventually([&, x = x, name = name] { return frames.at(name).transform.translation.x == x; }));
  }
}

TEST_F(PausedWorld, LightsAndCamerasMoveLikeBodies)
{
  sim_test::Frames frames;
  sim_test::Inbox<SimStatus> status(nh_, "status");
  ASSERT_TRUE(status.waitForCount(1));
  EXPECT_EQ(status.last().props, (std::vector<std::string>{"camera", "light"}));
  EXPECT_EQ(status.last().paddles, (std::vector<std::string>{"paddle"}));
  EXPECT_EQ(status.last().furniture, (std::vector<std::string>{"table"}));
  EXPECT_EQ(status.last().ball_ids, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_TRUE(putBody("light", 0.0, 2.5).success);
  EXPECT_TRUE(sim_test::eventually([&] { return frames.at("light").transform.translation.z == 2.5; }));
  const auto refused = putBody("lamp", 0.0, 2.5);
  EXPECT_FALSE(refused.success);
  EXPECT_NE(refused.message.find("lamp"), std::string::npos);
}

TEST_F(PausedWorld, StatusTellsTheLastContactAndTheRally)
{
  sim_test::Inbox<SimStatus> status(nh_, "status");
  SetBallState::Request request;
  request.id = 0;
  request.pose.position.x = -0.8;
  request.pose.position.z = 1.0;
  request.pose.orientation.w = 1.0;
  request.twist.linear.x = -2.0;  // onto the forehand
  ASSERT_TRUE(sim_test::call<SetBallState>("set_ball_state", request).success);
  step(0.2);
  ASSERT_TRUE(status.waitFor([](const SimStatus& s) { return s.has_contact; }));
  EXPECT_EQ(status.last().rally, 0u) << "nobody plays: the ball only came by a paddle that waits";

  sim_test::reset();
  ros::Publisher commands = nh_.advertise<PaddleCommand>("paddle/command", 1);
  ASSERT_TRUE(sim_test::eventually([&] { return commands.getNumSubscribers() > 0; }));
  PaddleCommand hold;
  hold.pose.orientation.w = 1.0;
  EXPECT_TRUE(sim_test::eventually(
      [&]
      {
        commands.publish(hold);
        return step(0.01).paddles.paddles.at(0).command_age >= 0.0;
      }));
  ASSERT_TRUE(sim_test::call<SetBallState>("set_ball_state", request).success);
  step(0.2);
  ASSERT_TRUE(status.waitFor([](const SimStatus& s) { return s.rally == 1 && s.has_contact; }));
  EXPECT_EQ(status.last().last_contact.other, "paddle");
  EXPECT_NEAR(status.last().last_contact.velocity_before.x, -2.0, 1e-9);
  sim_test::reset();
  EXPECT_TRUE(status.waitFor([](const SimStatus& s) { return s.rally == 0 && !s.has_contact; }));
}

TEST_F(PausedWorld, BallsThrowDiscsOnThePlatesBelow)
{
  sim_test::Inbox<visualization_msgs::MarkerArray> markers(nh_, "markers");
  SetBodyPose::Request light;
  light.body = "light";
  light.pose.position.x = 3.0;
  light.pose.position.z = 4.0;
  light.pose.orientation.w = 1.0;
  ASSERT_TRUE(sim_test::call<SetBodyPose>("set_body_pose", light).success);
  ASSERT_TRUE(spawn(3.0, 0.0, 1.0).success);  // right under it, over the table
  EXPECT_TRUE(markers.waitFor(
      [](const visualization_msgs::MarkerArray& array)
      {
        for (const auto& marker : array.markers)
        {
          if (marker.ns != "shadows" || marker.points.empty()) continue;
          double x = 0.0;
          for (const auto& point : marker.points) x += point.x / static_cast<double>(marker.points.size());
          return std::abs(x - 3.0) < 0.03 && marker.points.front().z < 1.0;
        }
        return false;
      }));
}

TEST_F(PausedWorld, ResetReturnsToTheSceneWhileTheClockRunsOn)
{
  sim_test::Inbox<rosgraph_msgs::Clock> clock(nh_, "/clock");
  spawn(0.0, -2.0, 1.5);
  const auto before = step(0.5);
  sim_test::reset();
  const auto after = step(0.01);
  EXPECT_NEAR(after.time, 0.01, 1e-12);
  EXPECT_EQ(after.balls.balls.size(), 2u);
  EXPECT_GT(after.balls.header.stamp, before.balls.header.stamp);
  ASSERT_TRUE(clock.waitFor([&](const rosgraph_msgs::Clock& c) { return c.clock == after.balls.header.stamp; }));
  ros::Time last;
  for (const rosgraph_msgs::Clock& message : clock.all())
  {
    EXPECT_FALSE(message.clock.isZero());
    EXPECT_GE(message.clock, last);
    last = message.clock;
  }
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_services");
}
