// ~launch: named shots from the frame of the table, any other ball from any frame, scatter, and what is refused.
#include <limits>

#include "ping_pong_sim/Launch.h"
#include "ping_pong_sim/shots.h"
#include "sim_client.h"

using namespace ping_pong_sim;
using ping_pong::Vector3d;

namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

template <class Message>
Vector3d toEigen(const Message& m)
{
  return {m.x, m.y, m.z};
}

// The scene's table: turned left by 90 degrees.
Vector3d pointInWorld(const Vector3d& p_T)
{
  return Vector3d(1.0, 2.0, 0.8) + Vector3d(-p_T.y(), p_T.x(), p_T.z());
}
Vector3d vectorInWorld(const Vector3d& v_T)
{
  return {-v_T.y(), v_T.x(), v_T.z()};
}

void expectNear(const Vector3d& a, const Vector3d& b)
{
  EXPECT_LT((a - b).norm(), 1e-9) << a.transpose() << " against " << b.transpose();
}

class Launching : public testing::Test
{
protected:
  void SetUp() override
  {
    sim_test::pause(true);
    startAnew();
    ASSERT_TRUE(status_.waitForCount(1));
  }

  /// Resets, and reads `balls` until it shows no ball: numbers begin anew, and states of an earlier ball_0 that are
  /// still under way must not be taken for those of the next one.
  void startAnew()
  {
    balls_.clear();
    sim_test::reset();
    EXPECT_TRUE(balls_.waitFor([](const BallStates& states) { return states.balls.empty(); }));
    balls_.clear();
  }

  static Launch::Request named(const std::string& shot)
  {
    Launch::Request request;
    request.shot = shot;
    return request;
  }

  static Launch::Request explicitly()
  {
    Launch::Request request;
    request.position.x = -1.0;
    request.position.z = 1.5;
    request.velocity.y = 2.0;
    request.spin.z = 30.0;
    return request;
  }

  /// The new ball as `balls` shows it, also in a paused world.
  BallState launched(const Launch::Request& request)
  {
    const auto response = sim_test::call<Launch>("launch", request);
    EXPECT_TRUE(response.success) << response.message;
    BallState found;
    const auto has = [&](const BallStates& states)
    {
      for (const BallState& ball : states.balls)
        if (ball.id == response.id) found = ball;
      return found.radius > 0.0;
    };
    EXPECT_TRUE(balls_.waitFor(has));
    balls_.clear();
    return found;
  }

  void expectRefused(const Launch::Request& request, const std::string& reason)
  {
    const std::uint64_t before = status_.last().rejected;
    const auto response = sim_test::call<Launch>("launch", request);
    EXPECT_FALSE(response.success);
    EXPECT_NE(response.message.find(reason), std::string::npos) << response.message;
    EXPECT_TRUE(status_.waitFor(
        [&](const SimStatus& s)
        { return s.rejected == before + 1 && s.rejected_reason.find(reason) != std::string::npos && s.balls == 0; }))
        << status_.last().rejected_reason;
  }

  ros::NodeHandle nh_;
  sim_test::Inbox<SimStatus> status_{nh_, "status"};
  sim_test::Inbox<BallStates> balls_{nh_, "balls"};
};
}  // namespace

TEST_F(Launching, EveryShotStartsFromTheTableAndLandsOnThePlayersHalf)
{
  for (const ping_pong::Shot& shot : ping_pong::shots())
  {
    SCOPED_TRACE(shot.name);
    startAnew();
    const BallState ball = launched(named(shot.name));
    expectNear(toEigen(ball.pose.position), pointInWorld(shot.p_TB));
    expectNear(toEigen(ball.twist.linear), vectorInWorld(shot.v_TB));
    expectNear(toEigen(ball.twist.angular), vectorInWorld(shot.w_TB));

    const auto flown = sim_test::step(1.2);
    const std::size_t landing = shot.name == "serve" ? 1 : 0;
    ASSERT_GT(flown.contacts.size(), landing);
    EXPECT_EQ(flown.contacts[landing].other, "table");
    EXPECT_EQ(flown.contacts[landing].shape, 0) << "the playing surface";
    EXPECT_GT(flown.contacts[landing].point.y, 2.0 - 1.37);
    EXPECT_LT(flown.contacts[landing].point.y, 2.0);
    EXPECT_EQ(flown.contacts[0].point.y > 2.0, shot.name == "serve") << "first on its own half";
  }
}

TEST_F(Launching, AFrameMayBeNamedForAShot)
{
  Launch::Request request = named("lob");
  request.frame_id = "world";
  const BallState ball = launched(request);
  expectNear(toEigen(ball.pose.position), ping_pong::findShot("lob")->p_TB);
  expectNear(toEigen(ball.twist.linear), ping_pong::findShot("lob")->v_TB);
}

TEST_F(Launching, AnyBallFromTheWorldsFrame)
{
  const BallState ball = launched(explicitly());
  expectNear(toEigen(ball.pose.position), {-1.0, 0.0, 1.5});
  expectNear(toEigen(ball.twist.linear), {0.0, 2.0, 0.0});
  expectNear(toEigen(ball.twist.angular), {0.0, 0.0, 30.0});
}

TEST_F(Launching, AnyBallFromTheFrameOfABody)
{
  Launch::Request request = explicitly();
  request.frame_id = "table";
  const BallState ball = launched(request);
  expectNear(toEigen(ball.pose.position), pointInWorld({-1.0, 0.0, 1.5}));
  expectNear(toEigen(ball.twist.linear), vectorInWorld({0.0, 2.0, 0.0}));
}

TEST_F(Launching, ScatterIsTheSameForTheSameSeed)
{
  Launch::Request request = named("drive");
  request.scatter = 0.05;
  request.seed = 7;
  const BallState first = launched(request);
  startAnew();
  const BallState again = launched(request);
  EXPECT_EQ(toEigen(first.twist.linear), toEigen(again.twist.linear));
  EXPECT_EQ(toEigen(first.twist.angular), toEigen(again.twist.angular));
  startAnew();
  request.seed = 8;
  EXPECT_NE(toEigen(launched(request).twist.linear), toEigen(first.twist.linear));
  const double speed = ping_pong::findShot("drive")->v_TB.norm();
  EXPECT_NEAR(toEigen(first.twist.linear).norm(), speed, 0.05 * speed);
}

TEST_F(Launching, AnUnknownShotIsRefusedWithTheNamesThatAreKnown)
{
  expectRefused(named("moonball"), "shot: moonball: expected one of serve, push, drive, loop, smash, lob");
}

TEST_F(Launching, AShotBesideAPositionIsRefused)
{
  Launch::Request request = explicitly();
  request.shot = "drive";
  expectRefused(request, "not both");
}

TEST_F(Launching, ATakenPlaceIsRefused)
{
  Launch::Request request;
  request.position.x = 1.0;
  request.position.y = 2.5;
  request.position.z = 0.8;
  expectRefused(request, "position: inside table");
}

TEST_F(Launching, APlaceTakenByABallIsRefused)
{
  EXPECT_TRUE(sim_test::call<Launch>("launch", named("push")).success);
  const auto second = sim_test::call<Launch>("launch", named("push"));
  EXPECT_FALSE(second.success);
  EXPECT_NE(second.message.find("position: inside ball_0"), std::string::npos) << second.message;
}

TEST_F(Launching, WhatIsNotFiniteIsRefused)
{
  Launch::Request request = explicitly();
  request.velocity.x = kNan;
  expectRefused(request, "velocity.x");
  request = explicitly();
  request.spin.y = kInf;
  expectRefused(request, "spin.y");
  request = named("drive");
  request.scatter = kNan;
  expectRefused(request, "scatter");
}

TEST_F(Launching, ScatterBeyondItsRangeIsRefused)
{
  Launch::Request request = named("drive");
  for (const double scatter : {-0.1, 1.5})
  {
    request.scatter = scatter;
    expectRefused(request, "scatter: ");
  }
}

TEST_F(Launching, AnUnknownFrameIsRefused)
{
  Launch::Request request = named("drive");
  request.frame_id = "moon";
  expectRefused(request, "frame_id: moon");
}

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_launch");
}
