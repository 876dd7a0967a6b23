// The computer player: it returns, serves and rallies; it keeps its limits, and knows nothing before it can.
#include <gtest/gtest.h>

#include "ping_pong_sim/scene_loader.h"
#include "ping_pong_sim/shots.h"
#include "ping_pong_sim/state_hash.h"
#include "play/drills.h"
#include "play/player.h"
#include "testing/scene_builder.h"

namespace ping_pong::play
{
namespace
{
std::shared_ptr<const Scene> matchScene()
{
  static const auto scene = std::make_shared<const Scene>(loadScene(std::string(SCENES_DIR) + "/match.yaml"));
  return scene;
}

PlayerParams playerA(int level = 5, Style style = Style::Mixed)
{
  PlayerParams params;
  params.level = level;
  params.style = style;
  return params;
}

PlayerParams playerB(int level = 5, Style style = Style::Mixed)
{
  PlayerParams params = playerA(level, style);
  params.end = End::B;
  params.paddle = "paddle_b";
  return params;
}

BallState launched(const Shot& shot)
{
  BallState state;
  state.p_WB = shot.p_TB;
  state.v_WB = shot.v_TB;
  state.w_WB = shot.w_TB;
  return state;
}

struct Score
{
  int due = 0, returned = 0, within_3_cm = 0;
  double worst = 0.0;
};

Score scoreOf(Trial& trial, int balls)
{
  Score score;
  for (const Shot& shot : shots())
    for (int seed = 0; seed < balls; ++seed)
    {
      const ReturnResult result = returnOf(trial, launched(scattered(shot, 0.05, seed)), seed);
      if (result.outcome == Outcome::NotItsHalf) continue;
      ++score.due;
      if (result.outcome != Outcome::Returned) continue;
      ++score.returned;
      score.within_3_cm += result.landing_error < 0.03;
      score.worst = std::max(score.worst, result.landing_error);
    }
  return score;
}

TEST(Player, ReturnsTheShotsToItsTargets)
{
  Trial trial(matchScene(), {playerA()});
  const Score score = scoreOf(trial, 20);
  measured("returned, part", static_cast<double>(score.returned) / score.due);
  measured("landing off by at most [m]", score.worst);
  EXPECT_GT(score.due, 100);
  EXPECT_GE(score.returned, 0.99 * score.due);
  EXPECT_GE(score.within_3_cm, 0.95 * score.returned);
  EXPECT_EQ(trial.blocked(), 0u);
}

TEST(Player, IsAsGoodAtTheOtherEndAndInLongTicks)
{
  for (const double tick : {2e-3, 5e-3, 1e-2})
  {
    Trial trial(matchScene(), {playerB()}, tick);
    const Score score = scoreOf(trial, 5);
    measured("returned, part", static_cast<double>(score.returned) / score.due);
    EXPECT_GE(score.returned, score.due - 1) << tick;
    EXPECT_GE(score.within_3_cm, 0.95 * score.returned) << tick;
  }
}

TEST(Player, TheRacketMeetsTheBallAsPlanned)
{
  Trial trial(matchScene(), {playerA()});
  trial.restart(trial.player(0).court().toWorld(launched(*findShot("drive"))), 1);
  bool met = false;
  std::optional<StrokePlan> plan;
  while (!met && trial.world().time() < 2.0)
  {
    if (trial.player(0).plan() != nullptr) plan = *trial.player(0).plan();
    trial.tick();
    for (const Contact& contact : trial.world().contacts())
    {
      if (contact.body != trial.bodyOf(0)) continue;
      met = true;
      ASSERT_TRUE(plan);
      EXPECT_NEAR(contact.time, plan->path.hit.time, 1e-6);
      EXPECT_LT((contact.n_W - plan->impact.n_W).norm(), 1e-6);
      EXPECT_LT((contact.v_other - plan->impact.v_WP).norm(), 1e-5);
      EXPECT_LT((contact.v_after - plan->shot.out.v_WB).norm(), 1e-4);
      EXPECT_LT((contact.w_after - plan->impact.w_out).norm(), 1e-2);
    }
  }
  EXPECT_TRUE(met);
}

TEST(Player, ServesByTheLaws)
{
  Trial trial(matchScene(), {playerA()});
  int legal = 0;
  for (int seed = 0; seed < 100; ++seed)
  {
    const ServeResult result = serveOf(trial, seed);
    legal += result.legal;
    EXPECT_TRUE(result.legal) << "seed " << seed << ", " << name(result.stroke) << ": " << result.fault;
  }
  EXPECT_EQ(legal, 100);
  Trial other(matchScene(), {playerB(5, Style::Attack)});
  for (int seed = 0; seed < 10; ++seed) EXPECT_TRUE(serveOf(other, seed).legal) << seed;
}

TEST(Player, KeepsARallyWithItself)
{
  Trial trial(matchScene(), {playerA(5, Style::Cooperative), playerB(5, Style::Cooperative)});
  for (int seed = 1; seed <= 3; ++seed) EXPECT_EQ(rallyOf(trial, seed, 60).strokes, 60u) << seed;
  EXPECT_EQ(trial.blocked(), 0u);
}

TEST(Player, KeepsTheLimitsOfItsLevel)
{
  for (int level = kLowestLevel; level <= kHighestLevel; ++level)
  {
    Trial trial(matchScene(), {playerA(level, Style::Attack)});
    const Score score = scoreOf(trial, 4);
    const DriveLimits limits = limitsOf(matchScene()->bodies.at(trial.bodyOf(0)).limits, levelTraits(level));
    std::printf("[ measured ] level %d: %d of %d returned, %.1f m/s, %.0f m/s^2 at most\n", level, score.returned,
                score.due, trial.topSpeed(), trial.topAcceleration());
    EXPECT_LE(trial.topSpeed(), limits.speed);
    EXPECT_LE(trial.topAcceleration(), limits.acceleration);
    EXPECT_EQ(trial.blocked(), 0u);
  }
}

TEST(Player, TheSameSeedIsTheSameRally)
{
  const auto hashOf = [](std::uint64_t seed)
  {
    Trial trial(matchScene(), {playerA(3), playerB(3)});
    trial.restart(trial.player(0).toss(), seed);
    trial.serves(0);
    for (int i = 0; i < 2000; ++i) trial.tick();
    return stateHash(trial.world());
  };
  EXPECT_EQ(hashOf(1), hashOf(1));
  EXPECT_NE(hashOf(1), hashOf(2));
}

// Two balls that are the same until the opponent strikes one of them another way: what the player does is the same until the
// reaction time is over.
TEST(Player, KnowsNothingBeforeItHasSeenIt)
{
  const int level = 2;
  Player one(*matchScene(), playerA(level)), other(*matchScene(), playerA(level));
  World world(matchScene());
  Observation seen;
  seen.balls.resize(1);
  seen.balls[0].v_WB = {-4.0, 0.0, 1.0};
  const std::size_t paddle = world.findBody("paddle_a");
  double first_difference = 1e9;
  const double struck = 0.1;
  for (int i = 0; i < 600; ++i)
  {
    seen.time = 1e-3 * i;
    seen.pose = world.bodyPose(paddle);
    seen.balls[0].p_WB = Vector3d(1.5 - 4.0 * seen.time, 0.0, 1.1);
    seen.balls[0].v_WB = {-4.0, 0.0, 1.0};
    const PaddleCommand a = one.update(seen);
    if (seen.time >= struck) seen.balls[0].v_WB = {-9.0, 1.0, 1.0};
    const PaddleCommand b = other.update(seen);
    if ((a.a_W - b.a_W).norm() + (a.alpha_W - b.alpha_W).norm() > 0.0)
      first_difference = std::min(first_difference, seen.time);
  }
  measured("acts differently so long after the stroke [s]", first_difference - struck);
  EXPECT_GE(first_difference, struck + levelTraits(level).reaction - 1e-9);
  EXPECT_LT(first_difference, struck + 2.0 * levelTraits(level).reaction);
}

TEST(Player, LetsABallGoThatGoesOut)
{
  Trial trial(matchScene(), {playerA()});
  BallState out;
  out.p_WB = {1.0, 0.0, 0.35};
  out.v_WB = {-12.0, 0.0, 1.0};  // passes over the end line where the paddle waits
  trial.restart(trial.player(0).court().toWorld(out), 1);
  for (int i = 0; i < 700; ++i)
  {
    trial.tick();
    for (const Contact& contact : trial.world().contacts()) EXPECT_NE(contact.body, trial.bodyOf(0));
  }
}

TEST(Player, TheSceneHasItsPaddlesWhereItWaits)
{
  for (const PlayerParams& params : {playerA(), playerB()})
  {
    const Pose ready = Player(*matchScene(), params).ready();
    for (const Body& body : matchScene()->bodies)
      if (body.name == params.paddle)
      {
        EXPECT_LT((body.pose.p - ready.p).norm(), 1e-9);
        EXPECT_LT(rotationBetween(body.pose.q, ready.q).norm(), 1e-9);
      }
  }
}

std::string refusalOf(const Scene& scene, const PlayerParams& params)
{
  try
  {
    Player player(scene, params);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

TEST(Player, RefusesWhatItCannotPlayWith)
{
  EXPECT_EQ(refusalOf(*matchScene(), playerA(9)), "level: 9: expected 1 to 5");
  EXPECT_EQ(refusalOf(*matchScene(), playerA(0)), "level: 0: expected 1 to 5");
  PlayerParams nobody = playerA();
  nobody.paddle = "racket";
  EXPECT_EQ(refusalOf(*matchScene(), nobody), "paddle: racket: expected the name of a kinematic body");
  Scene bare = *matchScene();
  bare.bodies.erase(bare.bodies.begin());
  EXPECT_NE(refusalOf(bare, playerA()).find("table"), std::string::npos);
  EXPECT_THROW(styleFromName("wild"), std::invalid_argument);
}

TEST(Player, GoesOnWhenTheBallIsGoneAndWhenTimeGoesBack)
{
  Trial trial(matchScene(), {playerA()});
  trial.restart(trial.player(0).court().toWorld(launched(*findShot("drive"))), 1);
  for (int i = 0; i < 100; ++i) trial.tick();
  World& world = trial.world();
  Observation none;
  none.time = world.time();
  none.pose = world.bodyPose(trial.bodyOf(0));
  EXPECT_TRUE(trial.player(0).update(none).a_W.allFinite());
  EXPECT_EQ(trial.player(0).plan(), nullptr);
  none.time = 0.0;
  none.tick = 0.0;
  EXPECT_TRUE(trial.player(0).update(none).a_W.allFinite());
}
}  // namespace
}  // namespace ping_pong::play
