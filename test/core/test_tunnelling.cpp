// Fast balls and thin plates, moving and turning paddles.
#include <functional>

#include "scene_builder.h"

namespace ping_pong
{
namespace
{
// A ball flies down at a horizontal plate whose middle is z = 0; `phase` shifts the samples of the fixed-step methods.
World shot(Method method, double dt, double thickness, double speed, double phase, double e = 1.0)
{
  const double start = 1.0 + phase * speed * dt;
  return SceneBuilder(method, dt)
      .restitution(e)
      .box("plate", {4, 4, thickness}, at({0, 0, 0}))
      .ball({0, 0, start}, {0, 0, -speed})
      .world();
}

struct Shots
{
  double missed = 0.0;      // flew through
  double wrong_side = 0.0;  // touched, and was pushed out behind
};

Shots shots(Method method, double dt, double thickness, double speed)
{
  Shots parts;
  constexpr int kCount = 1000;
  for (int i = 0; i < kCount; ++i)
  {
    World world = shot(method, dt, thickness, speed, (i + 0.5) / kCount);
    std::vector<Contact> hits;
    const int steps = static_cast<int>(std::ceil(2.0 / (speed * dt))) + 2;
    double lowest = 0.0;
    for (int k = 0; k < steps; ++k)
    {
      const BallState before = world.ballState(0);
      world.advance(dt);
      lowest = std::min(lowest, (positionOf(world) - before.p_WB - dt * before.v_WB).z());
    }
    const bool behind = positionOf(world).z() < 0.0;
    const bool pushed = behind && lowest < -1e-9;
    parts.wrong_side += pushed / static_cast<double>(kCount);
    parts.missed += (behind && !pushed) / static_cast<double>(kCount);
  }
  return parts;
}

TEST(Tunnelling, SampledContactsMissAThinPlate)
{
  // The ball is in touch for 2 r + 14 mm = 54 mm of its way; a sample every v h hits that with the odds 54 mm / v h.
  for (const Method method : {Method::EulerExplicit, Method::EulerSemiImplicit})
  {
    EXPECT_NEAR(shots(method, 1.0 / 240.0, 0.014, 25.0).missed, 1.0 - 0.054 / (25.0 / 240.0), 2e-3);  // 48 %
    EXPECT_NEAR(shots(method, 1.0 / 60.0, 0.014, 5.0).missed, 1.0 - 0.054 / (5.0 / 60.0), 2e-3);      // 35 %
  }
  for (const double speed : {5.0, 25.0})
  {
    const Shots exact = shots(Method::Exact, 1.0 / 60.0, 0.014, speed);
    EXPECT_EQ(exact.missed, 0.0);
    EXPECT_EQ(exact.wrong_side, 0.0);
  }
  measured("semi-implicit, 14 mm, 25 m/s, 1/240 s: missed",
           shots(Method::EulerSemiImplicit, 1 / 240.0, 0.014, 25).missed);
  measured("semi-implicit, 14 mm, 5 m/s, 1/60 s: missed", shots(Method::EulerSemiImplicit, 1 / 60.0, 0.014, 5).missed);
}

TEST(Tunnelling, SampledContactsPushOutOnTheWrongSide)
{
  // 40 m/s, 1 ms: a sample every 40 mm, none missed; those past the middle of the plate, 13 of 40 mm, go out behind.
  const Shots euler = shots(Method::EulerSemiImplicit, 1e-3, 0.014, 40.0);
  measured("semi-implicit, 14 mm, 40 m/s, 1 ms: pushed out behind", euler.wrong_side);
  EXPECT_EQ(euler.missed, 0.0);
  EXPECT_NEAR(euler.wrong_side, 13.0 / 40.0, 2e-3);
  const Shots exact = shots(Method::Exact, 1e-3, 0.014, 40.0);
  EXPECT_EQ(exact.missed, 0.0);
  EXPECT_EQ(exact.wrong_side, 0.0);
}

TEST(Tunnelling, APlateOfAMicrometreReflectsTwoHundredMetresPerSecond)
{
  for (int i = 0; i < 200; ++i)
  {
    World world = shot(Method::Exact, 1e-3, 1e-6, 200.0, i / 200.0, 0.8);
    const double start = positionOf(world).z();
    const std::vector<Contact> hits = run(world, 0.02, 1);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_NEAR(hits[0].time, (start - kR - 5e-7) / 200.0, 1e-17);  // a rounding or two
    EXPECT_NEAR(velocityOf(world).z(), 160.0, 1e-12);
  }
  const Shots euler = shots(Method::EulerSemiImplicit, 1e-3, 1e-6, 200.0);
  measured("semi-implicit, 1 um, 200 m/s, 1 ms: missed or on the wrong side", euler.missed + euler.wrong_side);
  EXPECT_GT(euler.missed + euler.wrong_side, 0.85);  // 80 % missed, half of the rest pushed out behind
}

TEST(Tunnelling, ABallFliesBackFromAMovingPaddleWithMinusEVrelPlusU)
{
  for (const double u : {-10.0, 0.0, 3.0, 30.0, 100.0})
    for (const double e : {0.0, 0.7, 1.0})
    {
      World world = SceneBuilder()
                        .restitution(e)
                        .paddle("paddle", boxShape({0.006, 0.3, 0.3}), at({0, 0, 0}))
                        .ball({2, 0, 0}, {-40, 0, 0})
                        .world();
      world.command(0, velocityCommand({u, 0, 0}));
      world.advance(1e-3);  // the drive reaches u at the end of this tick
      const double face = world.bodyPose(0).p.x() + 0.003;
      const double expected = 1e-3 + (positionOf(world).x() - kR - face) / (40.0 + u);
      const std::vector<Contact> hits = run(world, 0.02, 4);
      ASSERT_EQ(hits.size(), 1u) << u;
      EXPECT_NEAR(hits[0].time, expected, 1e-16);
      EXPECT_NEAR(hits[0].v_after.x(), e * (40.0 + u) + u, 1e-13);
      EXPECT_NEAR(hits[0].v_other.x(), u, 1e-13);
    }
}

TEST(Tunnelling, SampledContactsMissAFastPaddle)
{
  int missed = 0;
  for (int i = 0; i < 100; ++i)
    for (const Method method : {Method::EulerSemiImplicit, Method::Exact})
    {
      World world = SceneBuilder(method, 5e-3)
                        .paddle("paddle", boxShape({0.006, 0.3, 0.3}), at({0, 0, 0}))
                        .ball({1.0 + 0.003 * i, 0, 0})
                        .world();
      world.command(0, velocityCommand({30, 0, 0}));
      const std::size_t hits = run(world, 5e-3, 20).size();
      if (method == Method::EulerSemiImplicit)
        missed += hits == 0;
      else
        EXPECT_EQ(hits, 1u);
    }
  measured("semi-implicit, paddle at 30 m/s, 5 ms: missed of 100", missed);
  EXPECT_GT(missed, 50);  // 150 mm a step against 46 mm of touch: 69 %
}

TEST(Tunnelling, AJumpOfAPaddleHitsNothing)
{
  World world = SceneBuilder().paddle("paddle", boxShape({0.006, 0.3, 0.3}), at({-1, 0, 0})).ball({0, 0, 0}).world();
  EXPECT_FALSE(world.setBodyPose(0, at({1, 0, 0})));
  EXPECT_EQ(run(world, 0.01, 10).size(), 0u);
  EXPECT_EQ(positionOf(world), Vector3d::Zero());
  EXPECT_EQ(world.bodyTwist(0).v, Vector3d::Zero());
}

// --- row 10: a blade that turns about an end of its own, edge-on to its way ---

constexpr double kTurn = 60.0;        // [rad/s]
constexpr double kThickness = 0.006;  // [m]
constexpr double kLever = 0.15;       // distance of the ball from the axis [m]

// The axis is z through the origin; the blade points along x at t = 0 and the ball waits on the y axis.
World turningBlade(Method method, double dt, double lever = kLever)
{
  Shape shape = boxShape({0.2, kThickness, 0.1});
  shape.p_BS = Vector3d(0.1, 0, 0);
  SceneBuilder builder(method, dt);
  builder.restitution(0.8).paddle("blade", shape, at({0, 0, 0})).ball({0, lever, 0});
  World world = builder.world();
  world.command(0, velocityCommand({0, 0, 0}, {0, 0, kTurn}));
  return world;
}

// The drive needs the first tick to reach its speed: half a tick's angle is lost.
double angleOfBlade(double t, double tick)
{
  return kTurn * (t - 0.5 * tick);
}

double bisected(const std::function<double(double)>& f, double above, double below)
{
  for (int i = 0; i < 200; ++i)
  {
    const double middle = 0.5 * (above + below);
    (f(middle) > 0.0 ? above : below) = middle;
  }
  return 0.5 * (above + below);
}

TEST(Tunnelling, ATurningBladeHitsAtTheRightInstantAndWithTheSpeedOfTheTouchedPoint)
{
  constexpr double kTick = 1.0 / 240.0;
  // Gap to the face of the blade, from the ball's place seen in the blade: (lever cos(pi/2 - angle), lever sin(...)).
  const auto gap = [](double t)
  { return kLever * std::sin(0.5 * kPi - angleOfBlade(t, kTick)) - 0.5 * kThickness - kR; };
  const double truth = bisected(gap, kTick, kTick + 0.5 * kPi / kTurn);
  EXPECT_NEAR(truth, 0.5 * kTick + (0.5 * kPi - std::asin((0.5 * kThickness + kR) / kLever)) / kTurn, 1e-16);

  World world = turningBlade(Method::Exact, kTick);
  const std::vector<Contact> hits = run(world, kTick, 12);
  ASSERT_EQ(hits.size(), 1u);
  measured("turning blade, error of the time of the hit [s]", hits[0].time - truth);
  EXPECT_NEAR(hits[0].time, truth, 1e-15);
  const double angle = angleOfBlade(truth, kTick);
  const Vector3d n(-std::sin(angle), std::cos(angle), 0);
  const double along = kLever * std::cos(0.5 * kPi - angle);  // lever arm of the touched point
  const Vector3d expected = 1.8 * kTurn * along * n;          // (1 + e) W s n
  EXPECT_LE((hits[0].n_W - n).norm(), 1e-13);
  EXPECT_LE((hits[0].v_after - expected).norm(), 1e-12);
}

TEST(Tunnelling, SampledContactsGetATurningBladeWrong)
{
  int missed = 0;
  double worst = 0.0;
  for (int i = 0; i < 100; ++i)
  {
    const double lever = 0.15 + 0.0004 * i;
    World exact = turningBlade(Method::Exact, 5e-3, lever);
    World euler = turningBlade(Method::EulerSemiImplicit, 5e-3, lever);
    ASSERT_EQ(run(exact, 5e-3, 10).size(), 1u);
    missed += run(euler, 5e-3, 10).empty();
    worst = std::max(worst, (velocityOf(euler) - velocityOf(exact)).norm() / velocityOf(exact).norm());
  }
  // 17 degrees a step: at the first sample that overlaps, the ball is behind the blade already and is pushed out there.
  measured("semi-implicit, blade at 60 rad/s, 5 ms: missed of 100", missed);
  measured("largest relative error of the speed", worst);
  EXPECT_GT(worst, 0.2);
}

// --- row 30: the surface's velocity has to be that of the instant of the hit ---

TEST(Tunnelling, AVibratingPaddleKeepsABallOnAnOrbitOfOnePeriod)
{
  // Velocity of the paddle: straight lines between the nodes A sin(2 pi k / 80), 5 ms apart. The ball hits in the
  // middle of piece 30, on the way up and slowing down, where the orbit is stable, at V_p = (g T / 2) (1 - e) / (1 +
  // e).
  constexpr int kNodes = 80;
  constexpr int kPiece = 30;
  constexpr double kTick = 5e-3;
  constexpr double kE = 0.8;
  const double T = kNodes * kTick;
  const double paddle_speed = 0.5 * kG * T * (1.0 - kE) / (1.0 + kE);
  const auto wave = [](int k) { return std::sin(2.0 * kPi * (k % kNodes) / kNodes); };
  const double amplitude = paddle_speed / (0.5 * (wave(kPiece) + wave(kPiece + 1)));
  double height = 0.0;  // of the paddle at the hit: trapezoids, and a half one
  for (int k = 0; k < kPiece; ++k) height += 0.5 * kTick * amplitude * (wave(k) + wave(k + 1));
  height += 0.5 * kTick * amplitude * (0.75 * wave(kPiece) + 0.25 * wave(kPiece + 1));
  const double first = (kPiece + 0.5) * kTick;
  const double start = height + kR + 0.5 * kG * T * first - 0.5 * kG * first * first;

  for (const Method method : {Method::Exact, Method::EulerSemiImplicit})
  {
    World world = SceneBuilder(method, 1e-3)
                      .gravity(kG)
                      .restitution(kE)
                      .paddle("paddle", boxShape({0.3, 0.3, 0.01}), at({0, 0, -0.005}))
                      .ball({0, 0, start}, {0, 0, -0.5 * kG * T + kG * first})
                      .world();
    std::vector<Contact> hits;
    for (int k = 0; k < 50 * kNodes; ++k)
    {
      world.command(0, velocityCommand({0, 0, amplitude * wave(k + 1)}));
      world.advance(kTick);
      hits.insert(hits.end(), world.contacts().begin(), world.contacts().end());
    }
    double time = 0.0;
    double speed = 0.0;
    for (std::size_t n = 0; n < std::min<std::size_t>(hits.size(), 50); ++n)
    {
      time = std::max(time, std::abs(hits[n].time - first - static_cast<double>(n) * T));
      speed = std::max(speed, std::abs(hits[n].v_after.z() - 0.5 * kG * T));
    }
    std::printf("[ measured ] %s\n", name(method));
    measured("50 periods on a vibrating paddle, worst time [s]", time);
    if (method == Method::Exact)
    {
      ASSERT_EQ(hits.size(), 50u);
      EXPECT_LE(time, 1e-12);  // the orbit is stable: roundings do not add up
      EXPECT_LE(speed, 1e-12);
    }
    else
      EXPECT_GT(time, 1e-4);  // hits are found up to a step late
  }
}

// A wall comes nearer at u: every bounce from it adds 2 u. The truth is the recursion of an elastic ball, by hand.
TEST(Tunnelling, AClosingWallAddsTwiceItsSpeedAtEveryHit)
{
  constexpr double kSpeed = 0.5;
  for (const Method method : {Method::Exact, Method::EulerSemiImplicit})
  {
    SceneBuilder builder(method, 1e-3);
    builder.box("wall", {0.1, 1, 1}, at({-0.05, 0, 0})).paddle("mover", boxShape({0.1, 1, 1}), at({1.05, 0, 0}));
    builder.ball({kR, 0, 0}, {1, 0, 0});
    World world = builder.world();
    world.command(1, velocityCommand({-kSpeed, 0, 0}));
    run(world, 1e-3, 1);
    double room = world.bodyPose(1).p.x() - 0.05 - 2.0 * kR;  // for the centre, between the walls
    double x = positionOf(world).x() - kR;
    double v = 1.0;
    double t = world.time();
    std::size_t expected = 0;
    const double end = 1.8;  // 80 mm of room are left then
    for (;;)
    {
      const double away = (room - x) / (v + kSpeed);
      if (t + away > end) break;
      t += away, room -= kSpeed * away, v += 2.0 * kSpeed, ++expected;
      const double back = room / v;
      if (t + back > end) break;
      t += back, room -= kSpeed * back, x = 0.0, ++expected;
    }
    const std::size_t hits = run(world, 1e-3, 1799).size();
    const double error = std::abs(velocityOf(world).norm() - v) / v;
    std::printf("[ measured ] %s: %zu of %zu hits\n", name(method), hits, expected);
    measured("relative error of the speed", error);
    if (method == Method::Exact)
    {
      EXPECT_EQ(hits, expected);
      EXPECT_LE(error, 1e-12);  // a rounding per hit
    }
    else
      EXPECT_GT(error, 1e-3);
  }
}
}  // namespace
}  // namespace ping_pong
