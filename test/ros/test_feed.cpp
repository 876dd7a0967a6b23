// ~feed_period: a ball every so many simulated seconds, at most ~feed_keep of them, and the same ones after a reset.
#include <map>

#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/DeleteBall.h"
#include "ping_pong_sim/LoadScene.h"
#include "ping_pong_sim/SpawnBall.h"
#include "ping_pong_sim/shots.h"
#include "sim_client.h"

using namespace ping_pong_sim;
using ping_pong::Vector3d;

namespace
{
constexpr double kPeriod = 0.25;  // of the node [s]
constexpr int kTicks = 25;        // of a period
constexpr std::size_t kKeep = 3;  // of the node

struct FirstSeen
{
  double time;
  BallState ball;
};

/// When each ball was first seen, and how.
std::map<std::uint32_t, FirstSeen> firstSeen(const std::vector<BallStates>& messages)
{
  std::map<std::uint32_t, FirstSeen> seen;
  for (const BallStates& message : messages)
    for (const BallState& ball : message.balls) seen.insert({ball.id, {message.time, ball}});
  return seen;
}

/// The scene's table: turned left by 90 degrees.
void expectStartOf(const ping_pong::Shot& shot, const BallState& ball)
{
  const Vector3d p(ball.pose.position.x, ball.pose.position.y, ball.pose.position.z);
  const Vector3d v(ball.twist.linear.x, ball.twist.linear.y, ball.twist.linear.z);
  EXPECT_LT((p - Vector3d(1.0 - shot.p_TB.y(), 2.0 + shot.p_TB.x(), 0.8 + shot.p_TB.z())).norm(), 1e-9) << shot.name;
  EXPECT_LT((v - Vector3d(-shot.v_TB.y(), shot.v_TB.x(), shot.v_TB.z())).norm(), 1e-9) << shot.name;
}

class Feed : public testing::Test
{
protected:
  void SetUp() override
  {
    sim_test::pause(true);
    sim_test::reset();
    ASSERT_TRUE(balls_.waitForCount(1));
    balls_.clear();
  }

  /// All that `balls` tells about so many ticks; a tick is 10 ms. In pieces that the publisher's queue can hold.
  std::vector<BallStates> steps(int ticks)
  {
    for (int left = ticks; left > 0; left -= 50)
    {
      const auto response = sim_test::step(0.01 * std::min(left, 50));
      EXPECT_TRUE(response.success) << response.message;
      EXPECT_TRUE(balls_.waitFor([&](const BallStates& b) { return b.header.stamp == response.balls.header.stamp; }));
    }
    return balls_.all();
  }

  ros::NodeHandle nh_;
  sim_test::Inbox<BallStates> balls_{nh_, "balls"};
};
}  // namespace

TEST_F(Feed, BallsComeAtTheirTimesAndTheOldestMakeRoom)
{
  const auto messages = steps(20 * kTicks);
  const auto seen = firstSeen(messages);
  ASSERT_EQ(seen.size(), 20u);
  for (const auto& [id, first] : seen)
  {
    EXPECT_NEAR(first.time, (id + 1) * kPeriod, 1e-9) << id;
    expectStartOf(ping_pong::drawnShot(id), first.ball);
  }
  for (const BallStates& message : messages) EXPECT_LE(message.balls.size(), kKeep);
  ASSERT_EQ(messages.back().balls.size(), kKeep);
  EXPECT_EQ(messages.back().balls.front().id, 17u) << "the youngest stay";
}

TEST_F(Feed, BeginsAnewWithTheWorld)
{
  steps(85);
  sim_test::reset();
  balls_.clear();
  const auto seen = firstSeen(steps(60));
  ASSERT_EQ(seen.size(), 2u);
  for (const auto& [id, first] : seen) expectStartOf(ping_pong::drawnShot(id), first.ball);

  LoadScene::Request request;
  request.scene = "turned_table";
  ASSERT_TRUE(sim_test::call<LoadScene>("load_scene", request).success);
  balls_.clear();
  EXPECT_EQ(firstSeen(steps(60)).size(), 2u);
}

TEST_F(Feed, OthersBallsAreLeftAlone)
{
  SpawnBall::Request spawn;
  spawn.position.x = -3.0;
  spawn.position.z = 0.02;  // on the floor
  const auto mine = sim_test::call<SpawnBall>("spawn_ball", spawn);
  ASSERT_TRUE(mine.success) << mine.message;
  steps(60);
  DeleteBall::Request deletion;
  deletion.id = mine.id + 1;  // one that was fed
  ASSERT_TRUE(sim_test::call<DeleteBall>("delete_ball", deletion).success);
  const BallStates last = steps(6 * kTicks).back();
  ASSERT_EQ(last.balls.size(), kKeep + 1);
  EXPECT_EQ(last.balls.front().id, mine.id);
}

TEST_F(Feed, ABallWithoutAPlaceIsLeftOutAndCounted)
{
  sim_test::Inbox<SimStatus> status(nh_, "status");
  ASSERT_TRUE(status.waitForCount(1));
  const std::uint64_t before = status.last().rejected;
  steps(kTicks - 1);
  const Vector3d p = ping_pong::drawnShot(0).p_TB;
  SpawnBall::Request spawn;
  spawn.frame_id = "table";
  spawn.position.x = p.x();
  spawn.position.z = p.z();
  ASSERT_TRUE(sim_test::call<SpawnBall>("spawn_ball", spawn).success);
  EXPECT_EQ(steps(2).back().balls.size(), 1u);
  EXPECT_TRUE(status.waitFor(
      [&](const SimStatus& s)
      { return s.rejected == before + 1 && s.rejected_reason.find("feed: position: inside ball_0") == 0; }))
      << status.last().rejected_reason;
  EXPECT_EQ(steps(kTicks).back().balls.size(), 2u) << "the next one comes";
}

TEST_F(Feed, OneNamedShotAgainAndAgainAsFastAsItGoes)
{
  sim_test::Inbox<BallStates> balls(nh_, "lobs/balls");
  ASSERT_TRUE(balls.waitFor([](const BallStates& b) { return b.time > 20.0; }));
  ASSERT_TRUE(
      balls.waitForCount(100));  // of all phases of the flight: that world may have been far on when one came to listen
  const double top = 0.8 + 1.27;  // a lob's, above the floor [m]
  double highest = 0.0;
  for (const BallStates& message : balls.all())
  {
    // Balls 0, 1, 2, ... came at 0.5 s, 1 s, 1.5 s, ...; the last two are there.
    const auto fed = static_cast<std::uint32_t>(std::floor(message.time / 0.5 + 1e-6));
    ASSERT_EQ(message.balls.size(), std::min<std::size_t>(fed, 2)) << message.time;
    EXPECT_EQ(fed == 0 ? 0 : message.balls.back().id + 1, fed) << message.time;
    for (const BallState& ball : message.balls) highest = std::max(highest, ball.pose.position.z);
  }
  EXPECT_GT(highest, top - 0.3);
  EXPECT_LT(highest, top + 0.05);
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_feed");
}
