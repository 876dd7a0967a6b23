// A paddle may start in motion: it has its velocity from the first instant on, and keeps it until its first command.
#include <gtest/gtest.h>

#include "ping_pong_sim/scene_loader.h"
#include "ping_pong_sim/state_hash.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
const Vector3d kV(1.5, -0.5, 0.25);  // [m/s]
const Vector3d kW(3.0, -4.0, 12.0);  // 13 rad/s

/// One plate far from everything, with a weak drive: coming to speed would take long.
Scene plate(const Twist& twist)
{
  Scene scene =
      SceneBuilder().paddle("plate", boxShape({0.01, 0.16, 0.16}), at({0.2, 0.1, 1.0}, 0.4, {1, 2, 3})).build();
  scene.bodies[0].limits = {2.0, 10.0, 20.0, 100.0};
  scene.bodies[0].twist = twist;
  return scene;
}

/// Largest difference between a world's plate and one that has moved evenly since the start [m], [1].
double errorOf(const World& world, const Scene& scene)
{
  const Body& body = scene.bodies[0];
  const Pose now = world.bodyPose(0);
  const Quaterniond turn(Eigen::AngleAxisd(body.twist.w.norm() * world.time(), body.twist.w.normalized()));
  const Matrix3d R = (turn * body.pose.q).toRotationMatrix();
  return std::max((now.p - body.pose.p - world.time() * body.twist.v).norm(), (now.q.toRotationMatrix() - R).norm());
}

TEST(StartMotion, IsThereBeforeTheFirstTickAndStaysWithoutARamp)
{
  const Scene scene = plate({kV, kW});
  for (const double tick : {1e-4, 0.002, 0.01, 0.25})
  {
    World world(scene);
    EXPECT_EQ(world.bodyTwist(0).v, kV);
    EXPECT_EQ(world.bodyTwist(0).w, kW);
    for (int i = 0; i < 4; ++i)
    {
      world.advance(tick);
      EXPECT_EQ(world.bodyTwist(0).v, kV) << tick;
      EXPECT_LT((world.bodyTwist(0).w - kW).norm(), 1e-14) << tick;  // a rounding of 13 rad/s
      EXPECT_LT(errorOf(world, scene), 1e-13) << tick;               // up to 200 pieces, a rounding each
    }
  }
}

TEST(StartMotion, AsFastAsTheDriveMayBeIsKept)
{
  const Scene scene = plate({{0.0, 2.0, 0.0}, {0.0, 0.0, -20.0}});
  World world(scene);
  world.advance(0.5);
  EXPECT_LT(errorOf(world, scene), 1e-13);
}

TEST(StartMotion, TheFirstCommandEndsIt)
{
  World world(plate({kV, kW}));
  world.advance(0.1);
  const Vector3d from = world.bodyPose(0).p;
  ASSERT_FALSE(world.command(0, PaddleCommand()));
  for (int i = 0; i < 500; ++i) world.advance(0.002);
  EXPECT_TRUE(world.bodyTwist(0).v.isZero(0.0) && world.bodyTwist(0).w.isZero(0.0));
  EXPECT_NEAR((world.bodyPose(0).p - from).norm(), kV.squaredNorm() / (2.0 * 10.0),
              2e-3);  // v^2/2a, the last piece shorter
}

TEST(StartMotion, TellsWhatThePaddleObeys)
{
  EXPECT_EQ(World(plate({})).bodyCommand(0).mode, PaddleCommand::Mode::Hold);
  World world(plate({kV, kW}));
  EXPECT_EQ(world.bodyCommand(0).mode, PaddleCommand::Mode::Velocity);
  EXPECT_EQ(world.bodyCommand(0).twist.v, kV);
  ASSERT_FALSE(world.command(0, PaddleCommand()));
  EXPECT_EQ(world.bodyCommand(0).mode, PaddleCommand::Mode::Hold);
}

TEST(StartMotion, ComesBackWithAReset)
{
  World world(plate({kV, kW}));
  world.advance(0.1);
  const Pose first = world.bodyPose(0);
  ASSERT_FALSE(world.command(0, PaddleCommand()));
  world.advance(1.0);
  world.reset();
  EXPECT_EQ(world.bodyTwist(0).v, kV);
  world.advance(0.1);
  EXPECT_EQ(world.bodyPose(0).p, first.p);
  EXPECT_EQ(world.bodyPose(0).q.coeffs(), first.q.coeffs());
}

TEST(StartMotion, AJumpOfThePaddleEndsItAndAJumpOfAnotherBodyDoesNot)
{
  Scene scene = plate({kV, kW});
  scene.bodies.push_back(SceneBuilder().box("crate", {0.1, 0.1, 0.1}, at({9, 9, 9})).build().bodies[0]);
  World world(scene);
  ASSERT_FALSE(world.setBodyPose(1, at({8, 8, 8})));
  world.advance(0.1);
  EXPECT_LT(errorOf(world, scene), 1e-13);
  ASSERT_FALSE(world.setBodyPose(0, at({1, 0, 0})));
  world.advance(0.1);
  EXPECT_EQ(world.bodyPose(0).p, Vector3d(1, 0, 0));
  EXPECT_TRUE(world.bodyTwist(0).v.isZero(0.0));
}

TEST(StartMotion, ABallIsHitAtTheRightInstantAtTheRightSpeed)
{
  const double e = 0.8, u = 2.0, v = -3.0;
  for (const double tick : {0.001, 0.007, 0.2})
  {
    SceneBuilder builder;
    builder.restitution(e).paddle("plate", boxShape({0.01, 0.16, 0.16}), at({0, 0, 0})).ball({0.525, 0, 0}, {v, 0, 0});
    Scene scene = builder.build();
    scene.bodies[0].twist.v = {u, 0, 0};
    World world(scene);
    const std::vector<Contact> contacts = run(world, tick, static_cast<int>(std::ceil(0.15 / tick)));
    ASSERT_EQ(contacts.size(), 1u) << tick;
    EXPECT_NEAR(contacts[0].time, 0.5 / (u - v), 1e-13) << tick;
    EXPECT_EQ(contacts[0].v_other, Vector3d(u, 0, 0)) << tick;
    EXPECT_NEAR(velocityOf(world).x(), u + e * (u - v), 1e-13) << tick;
  }
}

// Where the paddle already touches the ball, no instant may pass before it moves.
TEST(StartMotion, ABallThatItTouchesIsHitAtOnce)
{
  for (const Method method : {Method::Exact, Method::Rk4Located})
  {
    SceneBuilder builder(method);
    builder.gravity(kG).restitution(0.5).paddle("tray", boxShape({1, 1, 0.1}), at({0, 0, -0.05})).ball({0, 0, kR});
    Scene scene = builder.build();
    scene.bodies[0].twist.v = {0, 0, 1.0};
    World world(scene);
    const std::vector<Contact> contacts = run(world, 0.01, 2);
    ASSERT_EQ(contacts.size(), 1u) << name(method);
    EXPECT_NEAR(contacts[0].time, 0.0, 1e-8) << name(method);
    EXPECT_NEAR(velocityOf(world).z(), 1.5 - kG * 0.02, 1e-7) << name(method);
  }
}

TEST(StartMotion, FrictionTakesABallOnItAlongFromTheFirstInstantOn)
{
  SceneBuilder builder;
  builder.gravity(kG).paddle("tray", boxShape({4, 1, 0.1}), at({0, 0, -0.05})).ball({0, 0, kR});
  Scene scene = builder.build();
  scene.surfaces.set(0, 1, {0.0, 0.0, 0.5});
  scene.surfaces.set(1, 0, {0.0, 0.0, 0.5});
  scene.bodies[0].twist.v = {1.0, 0, 0};
  World world(scene);
  world.advance(0.01);
  EXPECT_NEAR(velocityOf(world).x(), 0.5 * kG * 0.01, 1e-9);  // mu g t
}

TEST(StartMotion, ABallMayRideAlongFromTheStart)
{
  SceneBuilder builder;
  builder.gravity(kG)
      .restitution(0.5)
      .paddle("lift", boxShape({1, 1, 0.1}), at({0, 0, -0.05}))
      .ball({0, 0, kR}, {0.3, 0, 1.0});
  Scene scene = builder.build();
  scene.bodies[0].twist.v = {0.3, 0, 1.0};
  World world(scene);
  EXPECT_TRUE(run(world, 0.01, 100).empty());
  EXPECT_NEAR(positionOf(world).z(), kR + 1.0, 1e-9);
  EXPECT_NEAR(positionOf(world).x(), 0.3, 1e-12);
}

TEST(StartMotion, TheTableStopsIt)
{
  Scene scene = loadScene(SCENES_DIR "/paddle.yaml");
  scene.bodies[1].pose = at({-0.7, 0, 0.9});
  scene.bodies[1].twist.v = {0.2, 0, -2.0};
  World world(scene);
  EXPECT_EQ(world.advance(0.2).blocked_paddles, 1u);
  EXPECT_NEAR(world.bodyTwist(1).v.x(), 0.2, 1e-9);     // it slides on
  EXPECT_LT(std::abs(world.bodyTwist(1).v.z()), 1e-4);  // what is left takes it to its distance from the table, 25 um
}

// The loader refuses these; code may ask for them.
TEST(StartMotion, InCodeAStaticBodyStandsStillAndADriveKeepsItsLimits)
{
  Scene scene = plate({kV, kW});
  scene.bodies[0].kind = BodyKind::Static;
  World furniture(scene);
  furniture.advance(0.1);
  EXPECT_EQ(furniture.bodyPose(0).p, scene.bodies[0].pose.p);
  EXPECT_TRUE(furniture.bodyTwist(0).v.isZero(0.0));

  World fast(plate({{0, 0, 8.0}, {0, -80.0, 0}}));
  EXPECT_EQ(fast.bodyTwist(0).v, Vector3d(0, 0, 2.0));
  EXPECT_EQ(fast.bodyTwist(0).w, Vector3d(0, -20.0, 0));

  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  World none(plate({{nan, 0, 1}, {0, inf, 0}}));
  none.advance(0.1);
  EXPECT_EQ(none.bodyPose(0).p, plate({}).bodies[0].pose.p);
  EXPECT_TRUE(none.bodyTwist(0).v.isZero(0.0) && none.bodyTwist(0).w.isZero(0.0));
}

TEST(StartMotion, EveryMethodHitsTheBall)
{
  for (const Method method : kMethods)
  {
    SceneBuilder builder(method, 1e-4);
    builder.restitution(1.0).paddle("plate", boxShape({0.01, 0.16, 0.16}), at({0, 0, 0})).ball({0.125, 0, 0});
    Scene scene = builder.build();
    scene.bodies[0].twist.v = {1.0, 0, 0};
    World world(scene);
    run(world, 0.01, 15);
    EXPECT_NEAR(velocityOf(world).x(), 2.0, 1e-9) << name(method);
    EXPECT_NEAR(positionOf(world).x(), 0.125 + 2.0 * 0.05, 3e-4) << name(method);  // contact at 0.1 s, or a step later
  }
}

TEST(StartMotion, SameBitsOnEveryRun)
{
  for (const Method method : kMethods)
  {
    Scene scene = loadScene(SCENES_DIR "/tray.yaml");
    scene.method = method;
    Scene paddle = plate({{0.1, 0, 0}, {0, 0, 2.0}});
    scene.bodies.push_back(paddle.bodies[0]);
    World first(scene), second(scene);
    run(first, 0.01, 50);
    run(second, 0.01, 50);
    EXPECT_EQ(stateHash(first), stateHash(second)) << name(method);
    first.reset();
    run(first, 0.01, 50);
    EXPECT_EQ(stateHash(first), stateHash(second)) << "after reset, " << name(method);
  }
}
}  // namespace
}  // namespace ping_pong
