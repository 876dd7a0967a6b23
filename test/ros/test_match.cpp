// A match in lockstep: two computer players, umpire and simulator as nodes. Nothing here depends on how fast they are.
#include <std_msgs/UInt8.h>

#include "ping_pong_sim/BallStates.h"
#include "ping_pong_sim/DeleteBall.h"
#include "ping_pong_sim/NewMatch.h"
#include "ping_pong_sim/Score.h"
#include "ping_pong_sim/Toss.h"
#include "ping_pong_sim/UmpireCall.h"
#include "sim_client.h"

namespace
{
using namespace ping_pong_sim;
using namespace sim_test;

class Match : public testing::Test
{
protected:
  void SetUp() override
  {
    ASSERT_TRUE(eventually([&] { return ros::service::exists("/umpire/new_match", false); }));
    ASSERT_TRUE(eventually([&] { return score_.connected() && calls_.connected(); }));
  }

  // Both players have answered to the state before, or are late by a second of wall time.
  Step::Response stepTogether(double duration = 0.01)
  {
    Step::Request request;
    request.duration = duration;
    request.wait_for = {"paddle_a", "paddle_b"};
    request.deadline = 1.0;
    return call<Step>("step", request);
  }

  NewMatch::Response newMatch(const std::string& rules, int best_of, int server)
  {
    NewMatch exchange;
    exchange.request.rules = rules;
    exchange.request.best_of = static_cast<std::uint16_t>(best_of);
    exchange.request.server = static_cast<std::int8_t>(server);
    EXPECT_TRUE(ask("/umpire/new_match", exchange));
    return exchange.response;
  }

  ros::NodeHandle nh_;
  Inbox<Score> score_{nh_, "score"};
  Inbox<UmpireCall> calls_{nh_, "umpire_call"};
};

TEST_F(Match, IsPlayedToAPointThatAddsUp)
{
  EXPECT_TRUE(newMatch("ittf", 1, 0).success);
  const auto decided = [](const UmpireCall& c) { return c.kind == UmpireCall::POINT || c.kind == UmpireCall::FAULT; };
  bool over = false;
  for (int n = 0; n < 6000 && !over; ++n)  // a minute of play
  {
    ASSERT_TRUE(stepTogether().success);
    for (const UmpireCall& call : calls_.all()) over |= decided(call);
  }
  ASSERT_TRUE(over);
  for (const UmpireCall& call : calls_.all())
  {
    if (!decided(call)) continue;
    EXPECT_EQ(call.points[0] + call.points[1], 1) << call.reason;
    EXPECT_EQ(call.points[static_cast<std::size_t>(call.winner)], 1);
    EXPECT_FALSE(call.law.empty());
    EXPECT_GT(call.header.stamp.toSec(), 0.0);
    break;
  }
  EXPECT_GE(score_.last().rally, 1u);
  EXPECT_GT(score_.last().stroke_speed, 1.0);
}

TEST_F(Match, ANewOneBeginsAtNothing)
{
  score_.clear();
  EXPECT_TRUE(newMatch("ittf", 7, 1).success);
  EXPECT_TRUE(score_.waitFor(
      [](const Score& s)
      { return s.points[0] + s.points[1] == 0 && s.best_of == 7 && s.server == 1 && s.state == "before service"; }));
  EXPECT_EQ(score_.last().paddles[0], "paddle_a");
}

TEST_F(Match, WhatMakesNoSenseIsRefused)
{
  EXPECT_EQ(newMatch("ittf", 4, 0).success, false);
  EXPECT_NE(newMatch("chess", 0, 0).message.find("relaxed"), std::string::npos);  // the known ones are listed
  EXPECT_NE(newMatch("", 0, 5).message.find("server"), std::string::npos);

  Toss toss;
  toss.request.height = -1.0;
  EXPECT_TRUE(ask("/umpire/toss", toss));
  EXPECT_FALSE(toss.response.success);
  EXPECT_NE(toss.response.message.find("height"), std::string::npos);

  Step::Request step;
  step.duration = 0.01;
  step.wait_for = {"nobody"};
  EXPECT_NE(call<Step>("step", step).message.find("nobody"), std::string::npos);
  step.wait_for = {"paddle_a"};
  step.deadline = 1e9;
  EXPECT_NE(call<Step>("step", step).message.find("deadline"), std::string::npos);
}

// Not even a ball that somebody takes away leaves a rally undecided.
TEST_F(Match, ABallThatIsGoneIsALet)
{
  EXPECT_TRUE(newMatch("ittf", 1, 0).success);
  score_.clear();
  calls_.clear();
  std::uint32_t ball = 0;
  bool seen = false;
  for (int n = 0; n < 3000 && !seen; ++n)
  {
    const Step::Response step = stepTogether();
    if (!step.balls.balls.empty()) ball = step.balls.balls.back().id;
    seen = score_.last().state == "toss";
  }
  ASSERT_TRUE(seen);
  DeleteBall::Request request;
  request.id = ball;
  EXPECT_TRUE(call<DeleteBall>("delete_ball", request).success);
  const auto let = [](const UmpireCall& c)
  { return c.kind == UmpireCall::LET && c.reason.find("gone") != std::string::npos; };
  bool called = false;
  for (int n = 0; n < 1000 && !called; ++n)
  {
    stepTogether();
    for (const UmpireCall& c : calls_.all()) called |= let(c);
  }
  EXPECT_TRUE(called) << "last call: " << calls_.last().reason << ", state " << score_.last().state;
}
}  // namespace

int main(int argc, char** argv)
{
  return sim_test::runTests(argc, argv, "test_match");
}
