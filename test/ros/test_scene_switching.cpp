// ~load_scene: another world in the same node; a bad one is refused and changes nothing.
#include <visualization_msgs/MarkerArray.h>

#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/LoadScene.h"
#include "ping_pong_sim/PaddleCommand.h"
#include "sim_client.h"

using namespace ping_pong_sim;

namespace
{
class SceneSwitching : public testing::Test
{
protected:
  static LoadScene::Response load(const std::string& scene)
  {
    LoadScene::Request request;
    request.scene = scene;
    return sim_test::call<LoadScene>("load_scene", request);
  }

  bool waitForScene(const std::string& name)
  {
    return status_.waitFor([&](const SimStatus& s) { return s.scene == name; });
  }

  void SetUp() override
  {
    ASSERT_TRUE(load("bench").success);
    ASSERT_TRUE(waitForScene("bench"));
    status_.clear();
  }

  ros::NodeHandle nh_;
  sim_test::Inbox<SimStatus> status_{nh_, "status"};
};
}  // namespace

TEST_F(SceneSwitching, ByNameBringsTheNewWorld)
{
  sim_test::Inbox<BallStates> balls(nh_, "balls");
  sim_test::Inbox<visualization_msgs::MarkerArray> bodies(nh_, "body_markers");
  ASSERT_TRUE(bodies.waitForCount(1));
  bodies.clear();
  const auto response = load("bounce");
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_TRUE(waitForScene("bounce"));
  EXPECT_TRUE(balls.waitFor([](const BallStates& b) { return b.balls.size() == 1; }));
  // What was there goes first, and nothing but the new bodies follows.
  EXPECT_TRUE(bodies.waitFor(
      [](const visualization_msgs::MarkerArray& array) {
        return array.markers.front().action == visualization_msgs::Marker::DELETEALL && array.markers.size() == 1 + 3;
      }));
  EXPECT_TRUE(nh_.hasParam("table_description"));
  EXPECT_FALSE(nh_.hasParam("paddle_description"));
}

TEST_F(SceneSwitching, ByPathWorksToo)
{
  const auto response = load(std::string(TEST_SCENES) + "/bounce.yaml");
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_TRUE(waitForScene("bounce"));
}

TEST_F(SceneSwitching, ABadSceneIsRefusedAndTheOldOneGoesOn)
{
  const auto response = load("broken");
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("mass"), std::string::npos) << response.message;
  const double time = status_.last().time;
  EXPECT_TRUE(
      status_.waitFor([=](const SimStatus& s) { return s.scene == "bench" && s.time > time && s.rejected > 0; }));
}

TEST_F(SceneSwitching, AMissingFileIsRefused)
{
  const auto response = load("no_such_scene");
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("no_such_scene"), std::string::npos) << response.message;
}

TEST_F(SceneSwitching, PaddlesObeyAfterwards)
{
  ASSERT_TRUE(load("bounce").success);
  ASSERT_TRUE(load("bench").success);
  sim_test::Inbox<PaddleStates> paddles(nh_, "paddles");
  ros::Publisher commands = nh_.advertise<PaddleCommand>("paddle/command", 1);
  ASSERT_TRUE(sim_test::eventually([&] { return commands.getNumSubscribers() > 0; }));
  PaddleCommand command;
  command.mode = PaddleCommand::VELOCITY;
  command.twist.linear.y = 0.1;
  commands.publish(command);
  EXPECT_TRUE(
      paddles.waitFor([](const PaddleStates& p) { return !p.paddles.empty() && p.paddles[0].twist.linear.y > 0.09; }));
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_scene_switching");
}
