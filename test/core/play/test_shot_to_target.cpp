// Shots that were solved for, as a World flies them.
#include <gtest/gtest.h>

#include "base/random.h"
#include "ping_pong_sim/resolve.h"
#include "ping_pong_sim/scene_loader.h"
#include "play/court.h"
#include "play/shot_to_target.h"
#include "testing/scene_builder.h"

namespace ping_pong::play
{
namespace
{
struct Table
{
  Scene scene = loadScene(std::string(SCENES_DIR) + "/match.yaml");
  Court court{scene, End::A};
  BallParams ball = scene.balls.front().params;
  FlightModel model{scene.forces, ball};
  World world{court.ownScene(scene, ball)};
  Flyer flyer;

  Table()
  {
    flyer.model = &model;
    flyer.edge_x = -court.halfLength();
  }

  /// Contacts of the ball from this state on, until `count` are there.
  std::vector<Contact> fly(const BallState& out, std::size_t count)
  {
    world.reset();
    world.setBallState(world.ballId(0), out);
    std::vector<Contact> contacts;
    for (int i = 0; i < 2000 && contacts.size() < count; ++i)
    {
      world.advance(2e-3);
      contacts.insert(contacts.end(), world.contacts().begin(), world.contacts().end());
    }
    return contacts;
  }
};

TEST(ShotToTarget, LandsThereInTheWorld)
{
  Table table;
  Random random(1, 0);
  constexpr int kCases = 300;
  int solved = 0;
  double worst = 0.0, worst_time = 0.0;
  for (int i = 0; i < kCases; ++i)
  {
    const Vector3d p(random.uniform(-2.6, -1.1), random.uniform(-0.8, 0.8), random.uniform(0.08, 0.5));
    const Vector3d w = random.uniform(0.0, 450.0) * random.direction();
    ShotWish wish;
    wish.target = {random.uniform(0.35, 1.25), random.uniform(-0.65, 0.65), table.ball.radius};
    wish.flight_time = random.uniform(0.25, 0.6);
    wish.least_over_net = table.court.netHeight() + table.ball.radius + 0.01;
    wish.least_over_edge = table.ball.radius + 0.02;
    const auto shot = shotToTarget(
        table.flyer, p, [&](const Vector3d&) { return w; }, wish);
    if (!shot) continue;
    ++solved;
    const std::vector<Contact> contacts = table.fly(shot->out, 1);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_EQ(contacts[0].shape, table.court.surface()) << i;
    worst = std::max(worst, (contacts[0].p_WC - wish.target).head<2>().norm());
    worst_time = std::max(worst_time, std::abs(contacts[0].time - shot->arc.duration));
    EXPECT_GE(shot->arc.duration, wish.flight_time - 1e-5);
  }
  measured("solved, part", static_cast<double>(solved) / kCases);
  measured("landing off by at most [m]", worst);
  measured("time off by at most [s]", worst_time);
  EXPECT_GT(solved, 0.95 * kCases);
  EXPECT_LT(worst, 1e-3);
  EXPECT_LT(worst_time, 1e-4);
}

TEST(ShotToTarget, SpinMayDependOnTheVelocity)
{
  Table table;
  ShotWish wish;
  wish.target = {0.9, 0.1, table.ball.radius};
  const SpinOf spin = [](const Vector3d& v) { return Vector3d(0.0, 20.0 * v.norm(), 0.0); };
  const auto shot = shotToTarget(table.flyer, {-1.6, 0.0, 0.3}, spin, wish);
  ASSERT_TRUE(shot);
  EXPECT_EQ(shot->out.w_WB, spin(shot->out.v_WB));
  EXPECT_LT((table.fly(shot->out, 1).at(0).p_WC - wish.target).head<2>().norm(), 1e-3);
}

TEST(ShotToTarget, ServesBounceOnBothHalves)
{
  Table table;
  const Surface law = table.scene.surfaces.at(table.ball.material, table.court.surfaceMaterial());
  const TableBounce off = [&](BallState& ball) { bounce(law, table.ball, ball, Vector3d::Zero(), Vector3d::UnitZ()); };
  Random random(2, 0);
  int solved = 0;
  for (int i = 0; i < 100; ++i)
  {
    const Vector3d w(0.0, random.uniform(-100.0, 100.0), random.uniform(-150.0, 150.0));
    ServeWish wish;
    wish.target = {random.uniform(0.7, 1.1), random.uniform(-0.5, 0.5), table.ball.radius};
    wish.own_bounce = -0.85;
    wish.speed_guess = 4.5;
    wish.least_over_net = table.court.netHeight() + table.ball.radius;
    const auto shot = serveToTarget(
        table.flyer, {-1.6, -0.15, 0.2}, [&](const Vector3d&) { return w; }, off, wish);
    if (!shot) continue;
    ++solved;
    const std::vector<Contact> contacts = table.fly(shot->out, 2);
    ASSERT_EQ(contacts.size(), 2u);
    EXPECT_NEAR(contacts[0].p_WC.x(), wish.own_bounce, 1e-3);
    EXPECT_LT((contacts[1].p_WC - wish.target).head<2>().norm(), 1e-3);
  }
  measured("serves solved, of 100", solved);
  EXPECT_GT(solved, 60);
}

TEST(ShotToTarget, HasABoundAndSaysNo)
{
  Table table;
  const SpinOf none = [](const Vector3d&) -> Vector3d { return Vector3d::Zero(); };
  ShotWish wish;
  wish.target = {0.9, 0.0, table.ball.radius};
  wish.longest_time = 0.5 * wish.flight_time;
  EXPECT_FALSE(shotToTarget(table.flyer, {-1.6, 0.0, 0.3}, none, wish));
  wish.longest_time = 1.0;
  EXPECT_TRUE(shotToTarget(table.flyer, {-1.6, 0.0, 0.3}, none, wish));
  int few = 3;
  table.flyer.left = &few;
  EXPECT_FALSE(shotToTarget(table.flyer, {-1.6, 0.0, 0.3}, none, wish));
  few = 1000;
  wish.least_over_net = 5.0;  // no ball comes down in a second from there
  EXPECT_FALSE(shotToTarget(table.flyer, {-1.6, 0.0, 0.3}, none, wish));
  EXPECT_GT(few, 0);
}
}  // namespace
}  // namespace ping_pong::play
