// Two thousand balls: one marker, one small message and a few frames instead of thousands; what is left out is counted; and the
// node computes the very bits that the library computes.
#include <visualization_msgs/MarkerArray.h>

#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/Contact.h"
#include "ping_pong_sim/Crowd.h"
#include "ping_pong_sim/scene_loader.h"
#include "ping_pong_sim/state_hash.h"
#include "sim_client.h"

using namespace ping_pong_sim;

namespace
{
constexpr std::size_t kBalls = 2000;

class CrowdTopics : public testing::Test
{
protected:
  void SetUp() override
  {
    sim_test::pause(true);
    sim_test::reset();
  }
  ros::NodeHandle nh_;
};

using Floats = std::vector<float>;
bool near(const Floats& values, std::size_t first, double x, double y, double z)
{
  return std::abs(values[first] - x) < 1e-6 && std::abs(values[first + 1] - y) < 1e-6 &&
         std::abs(values[first + 2] - z) < 1e-6;
}
}  // namespace

TEST_F(CrowdTopics, SmallMessageHoldsEveryBall)
{
  sim_test::Inbox<Crowd> crowd(nh_, "crowd");
  ASSERT_TRUE(crowd.waitForCount(1));  // a newcomer to a paused world is told at once
  const Step::Response stepped = sim_test::step(0.05);
  ASSERT_TRUE(stepped.success) << stepped.message;
  ASSERT_TRUE(
      crowd.waitFor([&](const Crowd& c) { return c.time == stepped.time; }));  // the end of a step is never kept back
  const Crowd message = crowd.last();
  EXPECT_EQ(message.header.frame_id, "world");
  ASSERT_EQ(message.id.size(), kBalls);
  ASSERT_EQ(message.position.size(), 3 * kBalls);
  ASSERT_EQ(message.velocity.size(), 3 * kBalls);
  EXPECT_EQ(message.radius, Floats{0.02f});
  ASSERT_EQ(stepped.balls.balls.size(), kBalls);
  for (std::size_t i = 0; i < kBalls; ++i)
  {
    const BallState& ball = stepped.balls.balls[i];
    EXPECT_EQ(message.id[i], ball.id);
    const auto& p = ball.pose.position;
    const auto& v = ball.twist.linear;
    EXPECT_TRUE(near(message.position, 3 * i, p.x, p.y, p.z)) << i;
    EXPECT_TRUE(near(message.velocity, 3 * i, v.x, v.y, v.z)) << i;
  }
  EXPECT_LT(ros::serialization::serializationLength(message), 29 * kBalls);
}

TEST_F(CrowdTopics, OneListOfSpheresAndFewFrames)
{
  sim_test::Inbox<visualization_msgs::MarkerArray> markers(nh_, "markers");
  sim_test::Inbox<tf2_msgs::TFMessage> frames(nh_, "/tf");
  sim_test::Inbox<visualization_msgs::MarkerArray> bodies(nh_, "body_markers");
  using visualization_msgs::Marker;
  const auto countOf = [](const visualization_msgs::MarkerArray& array, int type)
  {
    std::size_t count = 0;
    for (const Marker& marker : array.markers) count += marker.type == type && marker.action == Marker::ADD;
    return count;
  };
  ASSERT_TRUE(markers.waitFor([&](const visualization_msgs::MarkerArray& array)
                              { return countOf(array, Marker::SPHERE_LIST) == 1; }));
  for (const visualization_msgs::MarkerArray& array : markers.all())
  {
    EXPECT_EQ(countOf(array, Marker::SPHERE), 0u);
    for (const Marker& marker : array.markers)
      if (marker.type == Marker::SPHERE_LIST)
      {
        EXPECT_EQ(marker.points.size(), kBalls);
      }
  }
  ASSERT_TRUE(frames.waitForCount(1));
  for (const tf2_msgs::TFMessage& message : frames.all())
    EXPECT_EQ(message.transforms.size(), 50u + 1u);  // and the newest
  ASSERT_TRUE(bodies.waitForCount(1));
  EXPECT_EQ(countOf(bodies.last(), Marker::LINE_LIST), 1u);  // the edges of the room
}

TEST_F(CrowdTopics, FullStatesComeSeldom)
{
  sim_test::Inbox<BallStates> balls(nh_, "balls");
  sim_test::Inbox<Crowd> crowd(nh_, "crowd");
  sim_test::pause(false);
  const double start = sim_test::wallNow();
  ASSERT_TRUE(balls.waitForCount(15));
  const double wall = sim_test::wallNow() - start;
  sim_test::pause(true);
  EXPECT_EQ(balls.last().balls.size(), kBalls);
  // Ten a second: 15 take 1.3 s or more, two of them being told for other reasons. Every tick would be 100 a second.
  EXPECT_GT(wall, 1.0);
  EXPECT_GT(crowd.all().size(), balls.all().size());
}

TEST_F(CrowdTopics, ContactsAreBoundedAndTheRestIsCounted)
{
  sim_test::Inbox<Contact> contacts(nh_, "contacts");
  sim_test::Inbox<SimStatus> status(nh_, "status");
  ASSERT_TRUE(sim_test::eventually([&] { return contacts.connected() && status.connected(); }));
  const double start = sim_test::wallNow();
  sim_test::pause(false);
  ASSERT_TRUE(status.waitFor([](const SimStatus& s) { return !s.paused && s.contacts > 3000; }));
  sim_test::pause(true);
  ASSERT_TRUE(status.waitFor([](const SimStatus& s) { return s.paused && s.contacts > 3000; }));
  const SimStatus last = status.last();
  const double wall = sim_test::wallNow() - start;
  EXPECT_GT(last.contacts_left_out, 0u);
  const std::size_t told = last.contacts - last.contacts_left_out;
  EXPECT_LE(static_cast<double>(told), 500.0 * (1.0 + wall) + 1.0);  // a second's worth at once, and 500 a second
  EXPECT_TRUE(contacts.waitForCount(told));
  EXPECT_EQ(contacts.all().size(), told);
}

TEST_F(CrowdTopics, ResetCountsAnew)
{
  sim_test::Inbox<SimStatus> status(nh_, "status");
  ASSERT_TRUE(status.waitForCount(1));
  EXPECT_TRUE(status.waitFor([](const SimStatus& s) { return s.contacts == 0 && s.contacts_left_out == 0; }));
}

TEST_F(CrowdTopics, TheNodeHasTheBitsOfTheLibrary)
{
  ping_pong::LoadOptions options;
  options.balls = kBalls;
  options.seed = 7;
  options.has_seed = true;
  ping_pong::World world(ping_pong::loadScene(std::string(SCENES) + "/gas.yaml", options));
  sim_test::Inbox<SimStatus> status(nh_, "status");
  const std::uint64_t start = ping_pong::stateHash(world);
  ASSERT_TRUE(status.waitFor([&](const SimStatus& s) { return s.time == 0.0 && s.state_hash == start; }));
  ASSERT_TRUE(sim_test::step(0.2).success);
  for (int i = 0; i < 20; ++i) world.advance(0.01);
  const std::uint64_t end = ping_pong::stateHash(world);
  EXPECT_NE(start, end);
  EXPECT_TRUE(status.waitFor([&](const SimStatus& s) { return s.state_hash == end; }));
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_crowd");
}
