// Friction and spin at a bounce, and sliding, rolling and spinning on a surface: closed forms.
#include <gtest/gtest.h>

#include <random>

#include "ping_pong_sim/resolve.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-13;  // velocities of 10 m/s and spins of 500 rad/s, a few roundings each

Surface rough(double e, double mu, double e_t = 0.0)
{
  Surface law;
  law.restitution = e;
  law.friction = mu;
  law.tangential_restitution = e_t;
  return law;
}

BallParams ballWith(double k)
{
  BallParams ball;
  ball.inertia = k;
  return ball;
}

BallState moving(const Vector3d& v, const Vector3d& w)
{
  BallState state;
  state.v_WB = v;
  state.w_WB = w;
  return state;
}

// Down onto a horizontal surface at rest; speeds as v along x and rim speed s = r w of topspin.
BallState bounced(const Surface& law, double k, double v, double s, double down = 3.0)
{
  BallState state = moving({v, 0, -down}, {0, s / kR, 0});
  bounce(law, ballWith(k), state, Vector3d::Zero(), Vector3d::UnitZ());
  return state;
}

// --- one bounce ---

TEST(BounceLaw, ASuperballReversesItsSlip)
{
  for (const double v : {-4.0, 0.0, 7.0})
    for (const double s : {-5.0, 0.0, 2.0, 9.0})
    {
      const BallState shell = bounced(rough(1.0, kInf, 1.0), kShellInertia, v, s);
      EXPECT_NEAR(shell.v_WB.x(), (v + 4.0 * s) / 5.0, kRounding);
      EXPECT_NEAR(kR * shell.w_WB.y(), (6.0 * v - s) / 5.0, kRounding);
      const BallState solid = bounced(rough(1.0, kInf, 1.0), kSolidInertia, v, s);
      EXPECT_NEAR(solid.v_WB.x(), (3.0 * v + 4.0 * s) / 7.0, kRounding);
      EXPECT_NEAR(kR * solid.w_WB.y(), (10.0 * v - 3.0 * s) / 7.0, kRounding);
      const BallState twice = bounced(rough(1.0, kInf, 1.0), kShellInertia, shell.v_WB.x(), kR * shell.w_WB.y());
      EXPECT_NEAR(twice.v_WB.x(), v, kRounding);  // two such bounces undo each other
      EXPECT_NEAR(kR * twice.w_WB.y(), s, kRounding);
    }
}

TEST(BounceLaw, AGrippingShellRollsOffWithThreeFifths)
{
  for (const double v : {-4.0, 1.0, 7.0})
    for (const double s : {-5.0, 0.0, 2.0})
    {
      const BallState shell = bounced(rough(0.9, kInf), kShellInertia, v, s);
      EXPECT_NEAR(shell.v_WB.x(), (3.0 * v + 2.0 * s) / 5.0, kRounding);
      EXPECT_NEAR(kR * shell.w_WB.y(), shell.v_WB.x(), kRounding);
      const BallState solid = bounced(rough(0.9, kInf), kSolidInertia, v, s);
      EXPECT_NEAR(solid.v_WB.x(), (5.0 * v + 2.0 * s) / 7.0, kRounding);
      EXPECT_NEAR(kR * solid.w_WB.y(), solid.v_WB.x(), kRounding);
    }
}

TEST(BounceLaw, ASlidingBallLosesFrictionTimesTheNormalImpulse)
{
  const double e = 0.93, mu = 0.25, down = 3.0;
  for (const double e_t : {0.0, 0.7})  // slides whatever it would do if it gripped
  {
    const BallState state = bounced(rough(e, mu, e_t), kShellInertia, 12.0, -4.0, down);
    const double change = mu * (1.0 + e) * down;
    EXPECT_NEAR(state.v_WB.x(), 12.0 - change, kRounding);
    EXPECT_NEAR(kR * state.w_WB.y(), -4.0 + 1.5 * change, kRounding);
    EXPECT_NEAR(state.v_WB.z(), e * down, kRounding);
  }
}

TEST(BounceLaw, TheBorderOfGripAndSlideIsContinuous)
{
  for (const double k : {kShellInertia, kSolidInertia})
    for (const double e_t : {-0.3, 0.0, 0.7})
    {
      const double e = 0.9, mu = 0.3, down = 2.0;
      const double border =
          mu * (1.0 + e) * down * (1.0 + 1.0 / k) / (1.0 + e_t);  // slip; shell, e_t = 0: (5/2) mu (1+e) v_n
      const double d = 1e-9;
      const BallState inside = bounced(rough(e, mu, e_t), k, border - d, 0.0, down);
      const BallState at = bounced(rough(e, mu, e_t), k, border, 0.0, down);
      const BallState outside = bounced(rough(e, mu, e_t), k, border + d, 0.0, down);
      EXPECT_NEAR(inside.v_WB.x(), at.v_WB.x(), 1.1 * d);  // no jump: a step of d moves the answer by at most d
      EXPECT_NEAR(outside.v_WB.x(), at.v_WB.x(), 1.1 * d);
      // Both forms meet there: the slip that grip leaves is the slip that sliding leaves.
      EXPECT_NEAR(at.v_WB.x() - kR * at.w_WB.y(), -e_t * border, kRounding);
    }
}

TEST(BounceLaw, TangentialRestitutionReversesThatPartOfTheSlip)
{
  for (const double e_t : {-1.0, -0.3, 0.0, 0.7, 1.0})
  {
    const BallState state = bounced(rough(0.8, kInf, e_t), kShellInertia, 5.0, -3.0);
    EXPECT_NEAR(state.v_WB.x() - kR * state.w_WB.y(), -e_t * 8.0, kRounding);
  }
}

TEST(BounceLaw, IsTheMatrixFormOfNakashima)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  const double e = 0.93, mu = 0.25;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3d v(10.0 * part(random), 10.0 * part(random), -5.0 + 4.9 * part(random));
    const Vector3d w = 500.0 * Vector3d(part(random), part(random), part(random));
    const Vector3d slip(v.x() - kR * w.y(), v.y() + kR * w.x(), 0.0);
    const double a = std::min(mu * (1.0 + e) * std::abs(v.z()) / slip.norm(), 0.4);
    Matrix3d A_v = Matrix3d::Zero(), B_v = Matrix3d::Zero(), A_w = Matrix3d::Zero(), B_w = Matrix3d::Zero();
    A_v.diagonal() << 1.0 - a, 1.0 - a, -e;
    B_v(0, 1) = a * kR;
    B_v(1, 0) = -a * kR;
    A_w(0, 1) = -1.5 * a / kR;
    A_w(1, 0) = 1.5 * a / kR;
    B_w.diagonal() << 1.0 - 1.5 * a, 1.0 - 1.5 * a, 1.0;
    BallState state = moving(v, w);
    bounce(rough(e, mu), BallParams(), state, Vector3d::Zero(), Vector3d::UnitZ());
    EXPECT_LE((state.v_WB - (A_v * v + B_v * w)).norm(), kRounding);
    EXPECT_LE(kR * (state.w_WB - (A_w * v + B_w * w)).norm(), kRounding);
  }
}

TEST(BounceLaw, SpinAboutTheNormalAndSmoothSurfacesChangeNothing)
{
  BallState state = moving({3, -1, -2}, {100, 200, 300});
  bounce(rough(0.9, 0.25), BallParams(), state, Vector3d::Zero(), Vector3d::UnitZ());
  EXPECT_EQ(state.w_WB.z(), 300.0);
  state = moving({3, -1, -2}, {100, 200, 300});
  bounce(rough(0.9, 0.0, 0.7), BallParams(), state, Vector3d::Zero(), Vector3d::UnitZ());
  EXPECT_EQ(state.w_WB, Vector3d(100, 200, 300));
  EXPECT_EQ(state.v_WB.head<2>(), Vector3d(3, -1, -2).head<2>());
}

TEST(BounceLaw, RestitutionFallsWithTheNormalSpeed)
{
  Surface law = rough(0.98, 0.0);
  law.restitution_slope = 0.02;
  EXPECT_NEAR(bounced(law, kShellInertia, 0.0, 0.0, 2.5).v_WB.z(), 0.93 * 2.5, kRounding);
  EXPECT_NEAR(bounced(law, kShellInertia, 0.0, 0.0, 100.0).v_WB.z(), 0.0, kRounding);  // never below 0
}

// --- through the world ---

TEST(Bounce, ThreeBouncesUnderATableReverseASuperball)
{
  struct Case
  {
    double inertia, ratio;
  };
  // Garwin 1969 for the solid ball; the same algebra for a shell: -71/125.
  for (const Case& test : {Case{kSolidInertia, -333.0 / 343.0}, Case{kShellInertia, -71.0 / 125.0}})
  {
    Scene scene =
        SceneBuilder().floor().box("table", {40.0, 4.0, 0.1}, at({0, 0, 0.81})).ball({0, 0, 0.38}, {3, 0, -3}).build();
    scene.balls[0].params.inertia = test.inertia;
    scene.surfaces.set(0, 1, rough(1.0, kInf, 1.0));
    World world(scene);
    std::vector<Contact> contacts = run(world, 0.1, 7);
    ASSERT_EQ(contacts.size(), 3u);
    EXPECT_NEAR(contacts.back().v_after.x() / 3.0, test.ratio, kRounding);
    measured("v / v0 after three bounces", contacts.back().v_after.x() / 3.0);
  }
}

TEST(Bounce, ASweptSurfaceIsTheSameInItsOwnFrame)
{
  const Vector3d u(2.0, -1.5, 0.7), v(1.0, 3.0, -4.0), w(120.0, -60.0, 90.0);
  BallState still = moving(v - u, w), swept = moving(v, w);
  bounce(rough(0.8, 0.3, 0.5), BallParams(), still, Vector3d::Zero(), Vector3d::UnitZ());
  bounce(rough(0.8, 0.3, 0.5), BallParams(), swept, u, Vector3d::UnitZ());
  EXPECT_LE((swept.v_WB - u - still.v_WB).norm(), kRounding);
  EXPECT_LE((swept.w_WB - still.w_WB).norm() * kR, kRounding);
}

TEST(Bounce, APaddleThatBrushesTheBallGivesItSpin)
{
  Scene scene = SceneBuilder()
                    .paddle("paddle", boxShape({0.01, 0.4, 0.4}), at({0, 0, 0}))
                    .ball({0.1, 0, 0.05}, {-5, 0, 0})
                    .build();
  scene.surfaces.set(0, 1, rough(0.8, kInf, 0.7));
  World world(scene);
  world.command(0, velocityCommand({0, 0, 3.0}));
  const std::vector<Contact> contacts = run(world, 1e-3, 40);
  ASSERT_EQ(contacts.size(), 1u);
  const Vector3d v = velocityOf(world);
  const double gripped = 3.0 * (1.7 * 2.0 / 5.0);  // (1 + e_t) k/(1+k) of the slip
  EXPECT_NEAR(v.x(), 0.8 * 5.0, kRounding);
  EXPECT_NEAR(v.z(), gripped, kRounding);
  EXPECT_NEAR(kR * world.ballState(0).w_WB.y(), 1.5 * gripped, kRounding);  // the side at the paddle moves up: topspin
}

// --- two balls ---

struct Pair
{
  BallState one, two;
};

Pair collided(const Surface& law, const BallParams& ball1, const BallParams& ball2, const Pair& before,
              const Vector3d& n)
{
  Pair after = before;
  const double closing = -n.dot(before.one.v_WB - before.two.v_WB);
  part(law, law.restitutionAt(closing) * closing, ball1, after.one, ball2, after.two, n);
  return after;
}

TEST(BallBall, KeepsMomentumAndAngularMomentumAndScalesTheSlip)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  const auto vector = [&] { return Vector3d(part(random), part(random), part(random)); };
  for (int i = 0; i < 500; ++i)
  {
    BallParams ball1, ball2;
    ball1.mass = 1e-3 * (2.0 + part(random));
    ball2.mass = 1e-3 * (2.0 + part(random));
    ball1.radius = 0.02 + 0.01 * part(random);
    ball2.radius = 0.02 + 0.01 * part(random);
    ball2.inertia = kSolidInertia;
    const Vector3d n = vector().normalized();
    Pair before{moving(5.0 * vector(), 200.0 * vector()), moving(5.0 * vector(), 200.0 * vector())};
    if (n.dot(before.one.v_WB - before.two.v_WB) > 0.0) std::swap(before.one.v_WB, before.two.v_WB);
    const double e_t = part(random);
    const Pair after = collided(rough(0.9, kInf, e_t), ball1, ball2, before, n);
    const auto momentum = [&](const Pair& p) -> Vector3d { return ball1.mass * p.one.v_WB + ball2.mass * p.two.v_WB; };
    const auto angular = [&](const Pair& p) -> Vector3d {  // about the centre of ball 2
      const Vector3d arm = (ball1.radius + ball2.radius) * n;
      const double I1 = ball1.inertia * ball1.mass * ball1.radius * ball1.radius;
      const double I2 = ball2.inertia * ball2.mass * ball2.radius * ball2.radius;
      return ball1.mass * arm.cross(p.one.v_WB) + I1 * p.one.w_WB + I2 * p.two.w_WB;
    };
    const auto slip = [&](const Pair& p) -> Vector3d
    {
      const Vector3d u = p.one.v_WB - p.two.v_WB - (ball1.radius * p.one.w_WB + ball2.radius * p.two.w_WB).cross(n);
      return u - n.dot(u) * n;
    };
    EXPECT_LE((momentum(after) - momentum(before)).norm(), 1e-3 * kRounding);
    EXPECT_LE((angular(after) - angular(before)).norm(), 1e-3 * kRounding);
    EXPECT_LE((slip(after) + e_t * slip(before)).norm(), kRounding);
    EXPECT_NEAR(n.dot(after.one.v_WB - after.two.v_WB), -0.9 * n.dot(before.one.v_WB - before.two.v_WB), kRounding);
  }
}

TEST(BallBall, ASpinningBallGrippedByItsTwinGivesItAFifthOfItsRimSpeed)
{
  // Equal shells head-on, ball 1 with sidespin s/r: slip s, tangential impulse m s / (2 (1 + 1/k)) = m s / 5.
  Scene scene = SceneBuilder().ball({-0.5, 0, 0}, {2, 0, 0}).ball({0.5, 0, 0}, {-2, 0, 0}).build();
  const double s = 3.0;
  scene.balls[0].state.w_WB = {0, 0, s / kR};
  scene.surfaces.set(0, 0, rough(1.0, kInf));
  World world(scene);
  world.advance(0.3);
  EXPECT_NEAR(velocityOf(world, 0).y(), -s / 5.0, kRounding);
  EXPECT_NEAR(velocityOf(world, 1).y(), s / 5.0, kRounding);
  EXPECT_NEAR(kR * world.ballState(0).w_WB.z(), s - 1.5 * s / 5.0, kRounding);
  EXPECT_NEAR(kR * world.ballState(1).w_WB.z(), -1.5 * s / 5.0, kRounding);
}

// --- on a surface ---

Scene onFloor(const Surface& law, const Vector3d& v, const Vector3d& w, double k = kShellInertia)
{
  Scene scene = SceneBuilder().gravity(kG).floor().ball({0, 0, kR}, v).build();
  scene.balls[0].state.w_WB = w;
  scene.balls[0].params.inertia = k;
  scene.surfaces.set(0, 1, law);
  return scene;
}

TEST(Sliding, AThrownBallSlidesThenRollsWithThreeFifthsOrFiveSevenths)
{
  const double mu = 0.2, v0 = 3.0;
  for (const double k : {kShellInertia, kSolidInertia})
  {
    World world(onFloor(rough(0.5, mu), {v0, 0, 0}, Vector3d::Zero(), k));
    const double grips = v0 / (mu * kG * (1.0 + 1.0 / k));
    world.advance(0.5 * grips);
    EXPECT_NEAR(velocityOf(world).x(), v0 - 0.5 * mu * kG * grips, kRounding);
    EXPECT_NEAR(kR * world.ballState(0).w_WB.y(), 0.5 * mu * kG / k * grips, kRounding);
    world.advance(0.5 * grips + 1.0);
    const double rolls = v0 / (1.0 + k);
    EXPECT_NEAR(velocityOf(world).x(), rolls, kRounding);
    EXPECT_NEAR(kR * world.ballState(0).w_WB.y(), rolls, kRounding);
    EXPECT_NEAR(positionOf(world).x(), v0 * grips - 0.5 * mu * kG * grips * grips + rolls, kRounding);
    EXPECT_EQ(positionOf(world).z(), kR);
  }
}

TEST(Sliding, BackspinDrawsTheBallBack)
{
  const double mu = 0.2, v0 = 1.0, s = -4.0;  // rim speed of the backspin
  World world(onFloor(rough(0.5, mu), {v0, 0, 0}, {0, s / kR, 0}));
  const double grips = (v0 - s) / (2.5 * mu * kG);
  world.advance(grips + 1.0);
  const double end = (3.0 * v0 + 2.0 * s) / 5.0;
  EXPECT_NEAR(velocityOf(world).x(), end, kRounding);  // -1 m/s: it comes back
  EXPECT_NEAR(positionOf(world).x(), v0 * grips - 0.5 * mu * kG * grips * grips + end, kRounding);
}

TEST(Sliding, TopspinBeyondRollingDrivesTheBallOn)
{
  const double mu = 0.2, v0 = 1.0, s = 6.0;
  World world(onFloor(rough(0.5, mu), {v0, 0, 0}, {0, s / kR, 0}));
  world.advance((s - v0) / (2.5 * mu * kG) + 0.5);
  EXPECT_NEAR(velocityOf(world).x(), (3.0 * v0 + 2.0 * s) / 5.0, kRounding);  // 3 m/s
}

TEST(Sliding, SpinAcrossTheMotionBendsThePathIntoAParabola)
{
  const double mu = 0.2;
  const Vector3d v(2.0, 0, 0), w(-150.0, 0, 40.0);  // slip along -y from the spin, and spin about the normal
  World world(onFloor(rough(0.5, mu), v, w));
  const Vector3d slip = v + kR * Vector3d::UnitZ().cross(w);  // v - r w x n
  const Vector3d slip_t(slip.x(), slip.y(), 0.0);
  const double grips = slip_t.norm() / (2.5 * mu * kG), t = 0.7 * grips;
  world.advance(t);
  const Vector3d a = -mu * kG * slip_t.normalized();
  EXPECT_LE((positionOf(world) - Vector3d(0, 0, kR) - v * t - 0.5 * t * t * a).norm(), kRounding);
  world.advance(grips);
  EXPECT_LE((velocityOf(world) - (v - 0.4 * slip_t)).norm(), kRounding);
  EXPECT_NEAR(world.ballState(0).w_WB.z(), 40.0, kRounding);
}

TEST(Rolling, KeepsItsSpeedForEver)
{
  const double v = 1.2;
  World world(onFloor(rough(0.5, 0.2), {v, 0, 0}, {0, v / kR, 0}));
  const double energy = world.totals().energy();
  run(world, 0.01, 1000);
  EXPECT_NEAR(velocityOf(world).x(), v, 1e-15);
  EXPECT_NEAR(positionOf(world).x(), 10.0 * v, 1e-13);  // 12 m are rounded to 2e-15, at a thousand ticks
  EXPECT_NEAR(world.totals().energy() / energy, 1.0, 1e-14);
}

// A long box whose top goes through the origin, tilted down towards +x.
Scene onSlope(double angle, const Surface& law, double k)
{
  const Quaterniond q(Eigen::AngleAxisd(angle, Vector3d::UnitY()));
  const Pose pose{q * Vector3d(0, 0, -0.05), q};
  Scene scene = SceneBuilder().gravity(kG).box("slope", {20.0, 2.0, 0.1}, pose).ball(q * Vector3d(-5.0, 0, kR)).build();
  scene.balls[0].params.inertia = k;
  scene.surfaces.set(0, 1, law);
  return scene;
}

TEST(Rolling, DownATiltedTableAtGSineOverOnePlusK)
{
  for (const double k : {kShellInertia, kSolidInertia})
    for (const double angle : {0.02, 0.2, 0.5})
    {
      World world(onSlope(angle, rough(0.5, 1.0), k));
      const Vector3d start = positionOf(world), down(std::cos(angle), 0, -std::sin(angle));
      world.advance(1.0);
      const double a = kG * std::sin(angle) / (1.0 + k);
      EXPECT_LE((positionOf(world) - start - 0.5 * a * down).norm(), kRounding);
      EXPECT_NEAR(kR * world.ballState(0).w_WB.y(), a, kRounding);
    }
}

TEST(Rolling, DownASteepTableItSlidesAndSpinsUp)
{
  const double angle = 0.6, mu = 0.1, k = kShellInertia;  // rolls up to tan(angle) = (1 + 1/k) mu
  World world(onSlope(angle, rough(0.5, mu), k));
  const Vector3d start = positionOf(world), down(std::cos(angle), 0, -std::sin(angle));
  world.advance(1.0);
  EXPECT_LE((positionOf(world) - start - 0.5 * kG * (std::sin(angle) - mu * std::cos(angle)) * down).norm(), kRounding);
  EXPECT_NEAR(kR * world.ballState(0).w_WB.y(), mu * kG * std::cos(angle) / k, kRounding);
}

TEST(Rolling, ResistanceBringsTheBallToRest)
{
  Surface law = rough(0.5, 0.3);
  law.rolling_resistance = 0.02;
  const double v = 0.8;
  World world(onFloor(law, {v, 0, 0}, {0, v / kR, 0}));
  const double stops = v / (0.02 * kG);
  world.advance(0.5 * stops);
  EXPECT_NEAR(velocityOf(world).x(), 0.5 * v, kRounding);
  EXPECT_NEAR(kR * world.ballState(0).w_WB.y(), 0.5 * v, kRounding);
  world.advance(0.5 * stops + 1.0);
  EXPECT_NEAR(positionOf(world).x(), 0.5 * v * stops, kRounding);  // 1.6 m
  EXPECT_LE(velocityOf(world).norm(), kRounding);
  EXPECT_LE(kR * world.ballState(0).w_WB.norm(), kRounding);
}

TEST(Spinning, FrictionStopsASpinningTop)
{
  Surface law = rough(0.5, 0.3);
  law.spin_friction = 0.01;
  const double w = 50.0;
  World world(onFloor(law, Vector3d::Zero(), {0, 0, w}));
  const double stops = w * kShellInertia * kR / (0.01 * kG);
  world.advance(0.5 * stops);
  EXPECT_NEAR(world.ballState(0).w_WB.z(), 0.5 * w, 1e-12);  // of 50 rad/s
  EXPECT_EQ(positionOf(world), Vector3d(0, 0, kR));
  world.advance(0.5 * stops + 0.1);
  EXPECT_NEAR(world.ballState(0).w_WB.z(), 0.0, 1e-12);
}

TEST(Rolling, ABallThatBouncesToRestWithSpinRollsAway)
{
  Scene scene = SceneBuilder().gravity(kG).floor().ball({0, 0, kR + 0.1}).build();
  scene.balls[0].state.w_WB = {0, 60.0, 0};
  scene.surfaces.set(0, 1, rough(0.5, 0.2));
  World world(scene);
  world.advance(5.0);
  const double end = 0.4 * kR * 60.0;  // (3 v + 2 s)/5 whatever the bounces between
  EXPECT_NEAR(velocityOf(world).x(), end, kRounding);
  EXPECT_NEAR(kR * world.ballState(0).w_WB.y(), end, kRounding);
  EXPECT_EQ(positionOf(world).z(), kR);
}

// --- off the edge ---

World rollingOff(double v, double mu)
{
  Scene scene = SceneBuilder()
                    .gravity(kG)
                    .box("table", {1.0, 1.0, 0.1}, at({-0.5, 0, -0.05}))
                    .ball({-0.1, 0, kR}, {v, 0, 0})
                    .build();
  scene.balls[0].state.w_WB = {0, v / kR, 0};
  scene.surfaces.set(0, 1, rough(0.5, mu));
  return World(scene);
}

TEST(Rolling, OffTheEdgeAFastBallFliesOnWithItsSpin)
{
  const double v = 1.0;  // v^2 > g r: the edge cannot hold it
  World world = rollingOff(v, 0.3);
  world.advance(0.1 / v + 0.2);
  EXPECT_NEAR(positionOf(world).x(), 0.2, kRounding);
  EXPECT_NEAR(positionOf(world).z(), kR - 0.5 * kG * 0.04, 1e-9);  // g t times the instant of leaving: 0.5 ns
  EXPECT_NEAR(kR * world.ballState(0).w_WB.y(), v, kRounding);
}

TEST(Rolling, OffTheEdgeASlowBallPivotsOnItAndKeepsItsEnergy)
{
  const double v = 0.2, k = kShellInertia;
  World world = rollingOff(v, kInf);
  const double energy = world.totals().energy();
  double leaves = 0.0;
  for (int i = 0; i < 8000 && leaves == 0.0; ++i)
  {
    world.advance(1e-4);
    if (std::isnan(world.restingSince(0)) && world.time() > 0.1 / v) leaves = velocityOf(world).norm();
  }
  // It leaves where v^2 = g r cos(angle), with (1 + k) v^2/2 + g r cos(angle) kept.
  const double cosine = (v * v / (kG * kR) + 2.0 / (1.0 + k)) / (1.0 + 2.0 / (1.0 + k));
  EXPECT_NEAR(leaves, std::sqrt(kG * kR * cosine), 1.5e-3);  // seen up to a tick late: 1e-4 s of free fall
  EXPECT_NEAR(world.totals().energy() / energy, 1.0, 1e-9);  // pieces of a tolerance of 1e-6 m are far better than that
  EXPECT_NEAR(kR * world.ballState(0).w_WB.y(), std::sqrt(kG * kR * cosine),
              1e-4);  // it rolled to the end, and let go within some 10 us, at 4 m/s^2
}
}  // namespace
}  // namespace ping_pong
