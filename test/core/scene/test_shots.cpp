// The named shots: typical speed and spin, over the net, onto the player's half. And what is drawn and scattered from
// them.
#include <gtest/gtest.h>

#include <set>

#include "ping_pong_sim/shots.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
constexpr double kTurn = 2.0 * kPi;  // [rad]

// A table with its net as one body in the world's origin, in air.
World tableInAir(const Shot& shot, const Surface& surface)
{
  Shape top = boxShape({kTableLength, kTableWidth, 0.025});
  top.p_BS.z() = -0.0125;
  Shape net = boxShape({0.002, 1.83, kNetHeight});
  net.p_BS.z() = 0.5 * kNetHeight;
  Scene scene = SceneBuilder()
                    .gravity(kStandardGravity)
                    .body("table", BodyKind::Static, {top, net}, at({0, 0, 0}))
                    .ball(shot.p_TB, shot.v_TB)
                    .build();
  scene.balls[0].state.w_WB = shot.w_TB;
  scene.forces.drag = scene.forces.magnus = scene.forces.buoyancy = true;
  scene.surfaces.set(0, 1, surface);
  return World(scene);
}

struct Flight
{
  std::vector<Contact> contacts;  // up to the first one beyond the net
  double above_net = 1e9;         // of the ball's lowest point while any of it is over the net [m]
};

Flight fly(const Shot& shot, const Surface& surface)
{
  World world = tableInAir(shot, surface);
  Flight flight;
  for (int i = 0; i < 2000 && (flight.contacts.empty() || flight.contacts.back().p_WC.x() > 0.0); ++i)
  {
    const Vector3d before = positionOf(world);
    world.advance(1e-3);
    flight.contacts.insert(flight.contacts.end(), world.contacts().begin(), world.contacts().end());
    const Vector3d now = positionOf(world);
    if (before.x() > -kR && now.x() < kR)
      flight.above_net = std::min(flight.above_net, std::min(before.z(), now.z()) - kR - kNetHeight);
  }
  return flight;
}

Surface surfaceOf(double restitution, double slope, double friction)
{
  Surface surface;
  surface.restitution = restitution;
  surface.restitution_slope = slope;
  surface.friction = friction;
  return surface;
}

const Surface kMatchTable = surfaceOf(0.98, 0.02, 0.25);  // as measured on match tables

void expectOnPlayersHalf(const Contact& landing, const std::string& name)
{
  EXPECT_EQ(landing.shape, 0u) << name << " meets the net";
  EXPECT_EQ(landing.n_W, Vector3d::UnitZ()) << name;
  EXPECT_GT(landing.p_WC.x(), -1.27) << name << ": 10 cm inside the end line";
  EXPECT_LT(landing.p_WC.x(), -0.3) << name;
  EXPECT_NEAR(landing.p_WC.y(), 0.0, 1e-9) << name;
}

TEST(Shots, HaveTheSpeedAndSpinOfTheirKind)
{
  struct Kind
  {
    const char* name;
    double speed, topspin;  // [m/s], [rev/s]
  };
  const Kind kinds[] = {{"serve", 5, -40}, {"push", 4.5, -30}, {"drive", 12, 50},
                        {"loop", 10, 100}, {"smash", 25, 20},  {"lob", 6, 30}};
  ASSERT_EQ(shots().size(), std::size(kinds));
  for (const Kind& kind : kinds)
  {
    const Shot* shot = findShot(kind.name);
    ASSERT_NE(shot, nullptr) << kind.name;
    EXPECT_NEAR(shot->v_TB.norm(), kind.speed, 1e-12) << kind.name;
    EXPECT_LT(shot->v_TB.x(), 0.0) << kind.name;
    // Topspin: the top of the ball moves along the flight, which is along -x.
    EXPECT_NEAR(-shot->w_TB.cross(Vector3d::UnitZ()).x(), kTurn * kind.topspin, 1e-12) << kind.name;
    EXPECT_NEAR(shot->w_TB.norm(), kTurn * std::abs(kind.topspin), 1e-12) << kind.name;
  }
  EXPECT_EQ(shotNames(), "serve, push, drive, loop, smash, lob");
  EXPECT_EQ(findShot("moonball"), nullptr);
}

TEST(Shots, PassTheNetAndLandOnThePlayersHalf)
{
  for (const Shot& shot : shots())
  {
    const Flight flight = fly(shot, kMatchTable);
    const bool serve = shot.name == "serve";
    ASSERT_EQ(flight.contacts.size(), serve ? 2u : 1u) << shot.name;
    EXPECT_GT(flight.contacts.front().p_WC.x(), serve ? 0.1 : -kTableLength) << shot.name;
    expectOnPlayersHalf(flight.contacts.back(), shot.name);
    EXPECT_GT(flight.above_net, 0.05) << shot.name;
    std::printf("[ measured ] %-5s lands at x = %.2f m after %.2f s with %.1f m/s, %.0f cm above the net\n",
                shot.name.c_str(), flight.contacts.back().p_WC.x(), flight.contacts.back().time,
                flight.contacts.back().v_before.norm(), 100.0 * flight.above_net);
  }
}

TEST(Shots, TheServeIsGoodOnAnyUsualTable)
{
  for (const double friction : {0.0, 0.15, 0.25, 0.35})
    for (const double restitution : {0.88, 0.90, 0.93})
    {
      const Flight flight = fly(*findShot("serve"), surfaceOf(restitution, 0.0, friction));
      ASSERT_EQ(flight.contacts.size(), 2u) << friction << ", " << restitution;
      expectOnPlayersHalf(flight.contacts.back(), "serve");
    }
}

TEST(Shots, EachRoundOfDrawnShotsHasAllOfThem)
{
  std::set<std::string> orders;
  for (std::uint64_t round = 0; round < 20; ++round)
  {
    std::set<std::string> names;
    std::string order;
    for (std::uint64_t i = 0; i < shots().size(); ++i)
    {
      const std::string& name = drawnShot(round * shots().size() + i).name;
      EXPECT_EQ(name, drawnShot(round * shots().size() + i).name);
      names.insert(name);
      order += name;
    }
    EXPECT_EQ(names.size(), shots().size());
    orders.insert(order);
  }
  EXPECT_GT(orders.size(), 10u);  // 720 orders: 20 draws rarely repeat one
}

TEST(Shots, ScatterStaysWithinItsBoundsAndUsesThem)
{
  const Shot& shot = *findShot("drive");
  const double scatter = 0.1;
  double fastest = 0.0, slowest = 1e9, widest = 0.0, most_spin = 0.0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed)
  {
    const Shot off = scattered(shot, scatter, seed);
    EXPECT_EQ(off.p_TB, shot.p_TB);
    const double speed = off.v_TB.norm() / shot.v_TB.norm();
    fastest = std::max(fastest, speed);
    slowest = std::min(slowest, speed);
    most_spin = std::max(most_spin, off.w_TB.norm() / shot.w_TB.norm());
    widest = std::max(widest, std::acos(off.v_TB.normalized().dot(shot.v_TB.normalized())));
  }
  EXPECT_LE(fastest, 1.0 + scatter + 1e-12);
  EXPECT_GE(slowest, 1.0 - scatter - 1e-12);
  EXPECT_LE(most_spin, 1.0 + scatter + 1e-12);
  EXPECT_LE(widest, scatter);
  EXPECT_GT(fastest, 1.0 + 0.95 * scatter);
  EXPECT_LT(slowest, 1.0 - 0.95 * scatter);
  EXPECT_GT(widest, 0.9 * scatter);
}

TEST(Shots, TheSameSeedIsTheSameShot)
{
  const Shot& shot = *findShot("loop");
  EXPECT_EQ(scattered(shot, 0.05, 7).v_TB, scattered(shot, 0.05, 7).v_TB);
  EXPECT_EQ(scattered(shot, 0.05, 7).w_TB, scattered(shot, 0.05, 7).w_TB);
  EXPECT_NE(scattered(shot, 0.05, 7).v_TB, scattered(shot, 0.05, 8).v_TB);
  EXPECT_EQ(scattered(shot, 0.0, 7).v_TB, shot.v_TB);
}
}  // namespace
}  // namespace ping_pong
