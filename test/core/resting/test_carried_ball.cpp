// Balls on surfaces that bend, turn, tilt and speed up: rolling without slip, held by rolling resistance, let go at the limit.
#include <gtest/gtest.h>

#include "testing/contact_scenes.h"
#include "testing/rolling_reference.h"

namespace ping_pong
{
namespace
{
constexpr double kCarried =
    kShell / (1.0 + kShell);    // 2/5: part of a plate's acceleration that a rolling shell takes over
constexpr double kTick = 0.01;  // [s]

PaddleCommand accelerate(const Vector3d& a, const Vector3d& alpha = Vector3d::Zero())
{
  PaddleCommand command;
  command.mode = PaddleCommand::Mode::Acceleration;
  command.a_W = a;
  command.alpha_W = alpha;
  return command;
}

// --- on a turntable ---

/// A disc of 2 m whose top is z = 0, turning about the z axis, and a ball on it that does not slip.
Scene turntable(double turn, const Surface& law, const Vector3d& p, const Vector3d& v, double k = kShell)
{
  SceneBuilder builder;
  builder.gravity(kG).paddle("turntable", cylinderShape(2.0, 0.1), at({0, 0, -0.05}));
  Scene scene = builder.ball({p.x(), p.y(), kR}, v).build();
  scene.bodies[0].twist = {Vector3d::Zero(), {0, 0, turn}};
  // v - s x n is the velocity of the disc there.
  const Vector3d rim = v - Vector3d(0, 0, turn).cross(p);
  scene.balls[0].state.w_WB = Vector3d::UnitZ().cross(rim) / kR;
  scene.balls[0].params.inertia = k;
  setSurface(scene, "ball", "wall", law);
  return scene;
}

TEST(Turntable, ARollingBallRunsOnACircleAtTwoFifthsOfItsTurn)
{
  for (const double turn : {1.0, 3.0, 8.0})
    for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12})
    {
      const double w = kCarried * turn, radius = 0.1, speed = radius * w;
      Scene scene = turntable(turn, rough(0.5, kInf), {0.3, 0, 0}, {0, speed, 0});
      scene.tolerance = tolerance;
      World world(scene);
      double worst = 0.0, slip = 0.0, faster = 0.0;
      for (int i = 1; i <= 200; ++i)
      {
        ASSERT_TRUE(world.advance(kTick).ok());
        const double angle = w * kTick * i;
        const Vector3d p = positionOf(world);
        worst = std::max(worst, (p - Vector3d(0.2 + radius * std::cos(angle), radius * std::sin(angle), kR)).norm());
        slip = std::max(slip, slipSpeed(world, Vector3d::UnitZ(), Vector3d(0, 0, turn).cross(p)));
        faster = std::max(faster, std::abs(velocityOf(world).norm() - speed));
      }
      std::printf("[ measured ] %g rad/s, tolerance %g: error %.3g m, slip %.3g m/s, speed %.3g m/s\n", turn, tolerance,
                  worst, slip, faster);
      const double rounding = 1e-12;
      EXPECT_LE(worst, std::max(tolerance, rounding));
      EXPECT_LE(slip, std::max(tolerance, rounding));
      EXPECT_LE(faster, std::max(tolerance, rounding));
    }
}

TEST(Turntable, ABallThatRunsOnTheSpotStaysThere)
{
  for (const double k : {kShellInertia, kSolidInertia})
  {
    World world(turntable(8.0, rough(0.5, kInf), {0.5, 0.2, 0}, Vector3d::Zero(), k));
    runFor(world, 2.0, kTick);
    EXPECT_LE((positionOf(world) - Vector3d(0.5, 0.2, kR)).norm(), 1e-12);  // rounding
  }
}

TEST(Turntable, SpinFrictionTakesABallInTheMiddleAlongToTheTurnOfTheTable)
{
  const double turn = 6.0, c = 0.02;
  World world(turntable(turn, rough(0.5, 0.4, 0.0, c), Vector3d::Zero(), Vector3d::Zero()));
  const double takes = turn * kR * kShell / (c * kG);
  runFor(world, 0.5 * takes, 0.05 * takes);
  EXPECT_NEAR(rimSpeed(world, 2), 0.5 * turn * kR, 1e-12);
  runFor(world, 0.5 * takes + 1.0, 0.05 * takes + 0.1);
  EXPECT_NEAR(rimSpeed(world, 2), turn * kR, 1e-12);
  EXPECT_LE((positionOf(world) - Vector3d(0, 0, kR)).norm(), 1e-12);
  world.command(0, velocityCommand({0, 0, 0}));  // and it is stopped by the table that stands still
  runFor(world, takes + kTick, kTick);
  EXPECT_NEAR(rimSpeed(world, 2), 0.0, 1e-12);
}

// --- on plates that speed up and tilt ---

/// A plate whose top goes through the body's origin, with a ball on it above that point.
Scene plate(const Surface& law, const Twist& twist = {})
{
  Shape board = boxShape({4, 4, 0.1});
  board.p_BS = {0, 0, -0.05};
  Scene scene = SceneBuilder().gravity(kG).paddle("plate", board, at({0, 0, 0})).ball({0, 0, kR}).build();
  scene.bodies[0].twist = twist;
  scene.balls[0].state.v_WB = twist.v + twist.w.cross(Vector3d(0, 0, kR));
  scene.balls[0].state.w_WB = twist.w;
  setSurface(scene, "ball", "wall", law);
  return scene;
}

Vector3d onPlate(const World& world)
{
  const Pose pose = world.bodyPose(0);
  return pose.q.conjugate() * (positionOf(world) - pose.p);
}

TEST(Turntable, SpinFrictionSpinsUpABallNoFasterThanItCan)
{
  const double c = 0.02, most = c * kG / (kShell * kR);  // [rad/s^2]
  for (const double part : {0.999, 1.5})
  {
    World world(turntable(0.0, rough(0.5, 0.4, 0.0, c), Vector3d::Zero(), Vector3d::Zero()));
    world.command(0, accelerate(Vector3d::Zero(), {0, 0, part * most}));
    runFor(world, 1.0, kTick);
    EXPECT_NEAR(rimSpeed(world, 2), kR * std::min(1.0, part) * most, 1e-12) << part;
  }
}

TEST(Plate, ARollingBallTakesOverTwoFifthsOfItsAcceleration)
{
  World world(plate(rough(0.5, kInf)));
  world.command(0, accelerate({3.0, -1.0, 0}));
  runFor(world, 1.0, kTick);
  EXPECT_LE((velocityOf(world) - kCarried * Vector3d(3.0, -1.0, 0)).norm(), 1e-12);
  EXPECT_LE((positionOf(world) - Vector3d(0, 0, kR) - 0.5 * kCarried * Vector3d(3.0, -1.0, 0)).norm(), 1e-12);
}

TEST(Plate, ABallOnATiltingPlateAgreesWithAReferenceIntegration)
{
  const double turn = 1.2;
  Scene scene = plate(rough(0.5, kInf), {{0.1, 0.2, 0}, {0.3, turn, 0.2}});
  scene.balls[0].state.p_WB = {0.05, -0.02, kR};
  scene.balls[0].state.v_WB = Vector3d(0.1, 0.2, 0) + scene.bodies[0].twist.w.cross(Vector3d(0.05, -0.02, kR));
  scene.tolerance = 1e-9;
  World world(scene);
  const Vector3r w(0.3L, Real(turn), 0.2L), move(0.1L, 0.2L, 0);
  RollingReference reference;
  reference.ground = [&](Real t, const Vector3r& p, const Vector3r& v)
  {
    RollingReference::Ground ground;
    ground.n = Eigen::AngleAxis<Real>(t * w.norm(), w.normalized()) * Vector3r(0, 0, 1);
    ground.dn = w.cross(ground.n);
    const Vector3r arm = p - Real(kR) * ground.n - t * move;
    ground.u = move + w.cross(arm);
    ground.du = w.cross(v - Real(kR) * ground.dn - move);
    return ground;
  };
  RollingReference::State truth = rollingState(world.ballState(0), kR);
  for (int i = 0; i < 4; ++i)
  {
    runFor(world, 0.1, kTick);
    truth = reference.rolled(truth, 0.1L, 2000, 0.1L * i);
    EXPECT_LE(distance(positionOf(world), truth.p), 1e-9) << i;
    EXPECT_LE(distance(velocityOf(world), reference.velocity(0.1L * (i + 1), truth)), 1e-9) << i;
    EXPECT_LE(distance(kR * world.ballState(0).w_WB, truth.s), 1e-9) << i;
  }
  measured("ball on a tilting plate after 0.4 s, error [m]", distance(positionOf(world), truth.p));
}

// --- held by rolling resistance ---

struct Held
{
  double mu, c;                                                      // friction and rolling resistance
  double limit() const { return std::min(mu, (1.0 + kShell) * c); }  // of (tangential force needed) / load
};
constexpr Held kHeld[] = {{0.3, 0.5}, {0.5, 0.15}};  // slides first, rolls first

TEST(ConstrainedBall, StaysOnAPlateThatSpeedsUpBelowTheLimitAndIsLeftBehindAboveIt)
{
  for (const Held& held : kHeld)
  {
    World world(plate(rough(0.5, held.mu, held.c)));
    world.command(0, accelerate({0.999 * held.limit() * kG, 0, 0}));
    runFor(world, 10.0, kTick);
    EXPECT_LE((onPlate(world) - Vector3d(0, 0, kR)).norm(),
              1e-9);  // after 75 m or more: a rounding of 1e-14 in each tick
    EXPECT_LE((velocityOf(world) - world.bodyTwist(0).v).norm(), 1e-9);
    World above(plate(rough(0.5, held.mu, held.c)));
    const double a = 1.001 * held.limit() * kG;
    above.command(0, accelerate({a, 0, 0}));
    runFor(above, 1.0, kTick);
    const bool rolls = (1.0 + kShell) * held.c < held.mu;
    const double behind = rolls ? a / (1.0 + kShell) - held.c * kG : a - held.mu * kG;
    EXPECT_NEAR(onPlate(above).x(), -0.5 * behind, 1e-9) << held.mu;
  }
}

// The plate turns evenly about the y axis, in its top; the ball goes along, r above it, with w^2 r towards the axis. It is let go
// where tan of the angle passes the limit: g sin = limit (g cos - w^2 r).
// Not held yet: the way after it is off by up to 0.3 mm.
TEST(ConstrainedBall, IsLetGoByATiltingPlateAtTheRightInstant)
{
  const double turn = 0.5;
  for (const Held& held : kHeld)
  {
    const bool rolls = (1.0 + kShell) * held.c < held.mu;
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 100; ++i)
    {
      const double angle = 0.5 * (low + high);
      (kG * std::sin(angle) < held.limit() * (kG * std::cos(angle) - turn * turn * kR) ? low : high) = angle;
    }
    const double leaves = low / turn;
    Scene scene = plate(rough(0.5, held.mu, held.c), {{0, 0, 0}, {0, turn, 0}});
    scene.tolerance = 1e-9;
    World world(scene);
    runFor(world, 0.999 * leaves, 0.0333 * leaves);
    EXPECT_LE((onPlate(world) - Vector3d(0, 0, kR)).norm(), 1e-12) << held.mu;
    EXPECT_LE((world.ballState(0).w_WB - Vector3d(0, turn, 0)).norm(), 1e-10);
    // Then, in the plate's frame: x'' = w^2 x + g sin - f with N = g cos - w^2 r - 2 w x'; f = mu N if it slides, and if it rolls
    // (1 + k) x'' = w^2 x + g sin - (1 + k) c N.
    const auto slope = [&](double t, double x, double u)
    {
      const double load = kG * std::cos(turn * t) - turn * turn * kR - 2.0 * turn * u;
      const double pull = turn * turn * x + kG * std::sin(turn * t);
      return rolls ? pull / (1.0 + kShell) - held.c * load : pull - held.mu * load;
    };
    const double after = 0.2;
    const int steps = 2000;
    double x = 0.0, u = 0.0;
    const double h = after / steps;
    for (int i = 0; i < steps; ++i)
    {
      const double t = leaves + h * i;
      const double a1 = slope(t, x, u), a2 = slope(t + h / 2, x + h / 2 * u, u + h / 2 * a1);
      const double a3 = slope(t + h / 2, x + h / 2 * u + h * h / 4 * a1, u + h / 2 * a2);
      const double a4 = slope(t + h, x + h * u + h * h / 2 * a2, u + h * a3);
      x += h * u + h * h / 6 * (a1 + a2 + a3);
      u += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    world.advance(leaves + after - world.time());
    measured("let go by a tilting plate, error of the way after 0.2 s [m]", onPlate(world).x() - x);
    ASSERT_GT(x, 1e-3);
    // An instant wrong by 1e-6 s would show as 1e-7 m.
    EXPECT_NEAR(onPlate(world).x(), x, 1e-9) << held.mu;
  }
}

TEST(ConstrainedBall, IsSwungThroughHalfAMetreWithoutMoving)
{
  for (const Held& held : kHeld)
  {
    World world(plate(rough(0.5, held.mu, held.c)));
    for (int i = 0; i < 100; ++i)  // half a second of 2 m/s^2 and as long a brake: 0.5 m; it tilts and turns, too
    {
      if (i % 50 == 0)
        world.command(0, accelerate({i == 0 ? 2.0 : -2.0, 0, 0}, (i == 0 ? 0.5 : -0.5) * Vector3d(1, 0, 1)));
      ASSERT_TRUE(world.advance(kTick).ok());
      ASSERT_LE((onPlate(world) - Vector3d(0, 0, kR)).norm(), 1e-11) << world.time();  // rounding in each tick
    }
    EXPECT_NEAR(world.bodyPose(0).p.x(), 0.5, 1e-12);
  }
}

TEST(ConstrainedBall, IsCarriedRoundByATurntableUntilItIsTooFast)
{
  for (const Held& held : kHeld)
  {
    const double radius = 0.3, most = std::sqrt(held.limit() * kG / radius);
    for (const double turn : {0.999 * most, 1.001 * most})
    {
      Scene scene = turntable(turn, rough(0.5, held.mu, held.c), {radius, 0, 0}, {0, radius * turn, 0});
      World world(scene);
      runFor(world, 2.0, kTick);
      const double drift = std::abs(positionOf(world).head<2>().norm() - radius);
      if (turn < most)
      {
        const double angle = 2.0 * turn;
        EXPECT_LE((positionOf(world) - Vector3d(radius * std::cos(angle), radius * std::sin(angle), kR)).norm(), 1e-9)
            << held.mu;
      }
      else
        EXPECT_GT(drift, 1e-3) << held.mu;
    }
  }
}

// --- on a lying cylinder and over an edge ---

/// A cylinder of radius R at rest, its axis along y.
std::function<RollingReference::Ground(Real, const Vector3r&, const Vector3r&)> lyingCylinder(Real R)
{
  return [R](Real, const Vector3r& p, const Vector3r& v)
  {
    const Real away = std::hypot(p.x(), p.z());
    RollingReference::Ground ground;
    ground.n = Vector3r(p.x(), 0, p.z()) / away;
    ground.dn = Vector3r(v.x(), 0, v.z()) / (R + Real(kR));
    return ground;
  };
}

TEST(LyingCylinder, ABallThatRollsAcrossItWithSpinKeepsItsEnergyAndAgreesWithAReferenceIntegration)
{
  const Quaterniond lying(Eigen::AngleAxisd(0.5 * kPi, Vector3d::UnitX()));
  Scene scene = SceneBuilder()
                    .gravity(kG)
                    .body("cylinder", BodyKind::Static, {cylinderShape(0.1, 20)}, {Vector3d::Zero(), lying})
                    .ball({0, 0, 0.1 + kR}, {0.15, 0.4, 0})
                    .build();
  scene.balls[0].state.w_WB = {-0.4 / kR, 0.15 / kR, 120};
  setSurface(scene, "ball", "wall", rough(0.5, kInf));
  RollingReference reference;
  reference.ground = lyingCylinder(0.1L);
  for (const double tolerance : {1e-6, 1e-9, 1e-12})
  {
    scene.tolerance = tolerance;
    World world(scene);
    const double before = world.totals().energy(), spent = kBallMass * kG * 0.12;
    RollingReference::State truth = rollingState(world.ballState(0), kR);
    double error = 0.0, energy = 0.0;
    for (int i = 0; i < 34; ++i)
    {
      ASSERT_TRUE(world.advance(kTick).ok());
      truth = reference.rolled(truth, Real(kTick), 500);
      error = std::max({error, distance(positionOf(world), truth.p),
                        distance(velocityOf(world), reference.velocity(0, truth)),
                        distance(kR * world.ballState(0).w_WB, truth.s)});
      energy = std::max(energy, std::abs(world.totals().energy() - before) / spent);
    }
    std::printf("[ measured ] helix, tolerance %g: error %.3g m, m/s; energy %.3g\n", tolerance, error, energy);
    EXPECT_LE(error, std::max(tolerance, 1e-11));
    EXPECT_LE(energy, std::max(tolerance, 1e-11));
  }
}

TEST(LyingCylinder, SpinFrictionThatHoldsKeepsABallFromTurningAboutTheNormal)
{
  const Quaterniond lying(Eigen::AngleAxisd(0.5 * kPi, Vector3d::UnitX()));
  Scene scene = SceneBuilder()
                    .gravity(kG)
                    .body("cylinder", BodyKind::Static, {cylinderShape(0.1, 20)}, {Vector3d::Zero(), lying})
                    .ball({0, 0, 0.1 + kR}, {0.15, 0.4, 0})
                    .build();
  scene.balls[0].state.w_WB = {-0.4 / kR, 0.15 / kR, 0};
  setSurface(scene, "ball", "wall", rough(0.5, kInf, 0.0, 10.0));
  RollingReference reference;
  reference.ground = lyingCylinder(0.1L);
  reference.holds_spin = true;
  World world(scene);
  RollingReference::State truth = rollingState(world.ballState(0), kR);
  double error = 0.0;
  for (int i = 0; i < 25; ++i)
  {
    ASSERT_TRUE(world.advance(kTick).ok());
    truth = reference.rolled(truth, Real(kTick), 200, 0);
    error = std::max({error, distance(positionOf(world), truth.p),
                      distance(velocityOf(world), reference.velocity(0, truth)),
                      distance(kR * world.ballState(0).w_WB, truth.s)});
  }
  measured("no spin on a cylinder, error [m], [m/s]", error);
  EXPECT_LE(error, 1e-9);
}

TEST(Edge, ABallWithSidespinRollsOverItAndKeepsItsEnergy)
{
  for (const double spin : {0.0, 60.0})
  {
    const double v = 0.2;
    Scene scene = SceneBuilder()
                      .gravity(kG)
                      .box("table", {1, 1, 0.1}, at({-0.5, 0, -0.05}))
                      .ball({-0.01, 0, kR}, {v, 0, 0})
                      .build();
    scene.balls[0].state.w_WB = {0, v / kR, spin};
    setSurface(scene, "ball", "wall", rough(0.5, kInf));
    scene.tolerance = 1e-9;
    World world(scene);
    const double energy = world.totals().energy();
    runFor(world, 0.01 / v, 0.01 / v);
    RollingReference reference;  // on the edge from here on: a cylinder without radius
    reference.ground = lyingCylinder(0.0L);
    RollingReference::State truth{Vector3r(0, 0, Real(kR)), Vector3r(0, Real(v), Real(kR * spin))};
    double worst = 0.0, error = 0.0;
    int ticks = 0;
    for (; ticks < 1000; ++ticks)
    {
      truth = reference.rolled(truth, 1e-3L, 1000);
      if (!(reference.load(0, truth) > 0.0L)) break;
      ASSERT_TRUE(world.advance(1e-3).ok());
      error = std::max({error, distance(positionOf(world), truth.p),
                        distance(velocityOf(world), reference.velocity(0, truth)),
                        distance(kR * world.ballState(0).w_WB, truth.s)});
      worst = std::max(worst, std::abs(world.totals().energy() / energy - 1.0));
    }
    std::printf("[ measured ] over the edge with %g rad/s: %d ms on it, error %.3g m, m/s; energy %.3g\n", spin, ticks,
                error, worst);
    ASSERT_GT(ticks, 10);
    ASSERT_LT(ticks, 1000);
    EXPECT_LE(error, 1e-9);
    EXPECT_LE(worst, 1e-9);
    world.advance(0.01);  // then it flies: nothing but the height changes the energy any more
    const BallState flies = world.ballState(0);
    world.advance(0.02);
    EXPECT_LE((velocityOf(world) - flies.v_WB - Vector3d(0, 0, -kG * 0.02)).norm(), 1e-14);
    EXPECT_EQ(world.ballState(0).w_WB, flies.w_WB);
    EXPECT_NEAR(world.totals().energy() / energy, 1.0, 1e-9);
  }
}

// --- between two bars that turn ---

/// Two bars along y, side by side, each turning about its own axis; a ball lies in the groove between them.
Scene betweenBars(double left, double right, const Surface& law)
{
  const double R = 0.05, apart = 0.06, height = std::sqrt((R + kR) * (R + kR) - apart * apart);
  const Quaterniond lying(Eigen::AngleAxisd(0.5 * kPi, Vector3d::UnitX()));
  SceneBuilder builder;
  builder.gravity(kG);
  for (const int side : {-1, 1})
    builder.paddle(side < 0 ? "left" : "right", cylinderShape(R, 2), {{side * apart, 0, 0}, lying});
  Scene scene = builder.ball({0, 0, height}).build();
  scene.bodies[0].twist.w = {0, left, 0};
  scene.bodies[1].twist.w = {0, right, 0};
  setSurface(scene, "ball", "wall", law);
  return scene;
}

TEST(TurningBars, BothTheSameWaySpinTheBallToTheirRimSpeed)
{
  // As in a groove: friction turns both loads by its angle; here it drives the ball. sin of half the opening is height / (R + r).
  const double mu = 0.2, turn = 4.0, rim = 0.05 * turn;
  World world(betweenBars(turn, turn, rough(0.5, mu)));
  const Vector3d start = positionOf(world);
  const double rate = mu * kG / ((1.0 + mu * mu) * (start.z() / 0.07) * kShell);
  const double takes = rim / rate;
  runFor(world, 0.5 * takes, 0.05 * takes);
  EXPECT_NEAR(rimSpeed(world, 1), -0.5 * rim, 1e-6);
  runFor(world, 1.0, kTick);
  EXPECT_NEAR(rimSpeed(world, 1), -rim, 1e-9);
  EXPECT_LE((positionOf(world) - start).norm(), 1e-9);
  EXPECT_LE(velocityOf(world).norm(), 1e-9);
}

TEST(TurningBars, AgainstEachOtherTheyDoFiniteWork)
{
  // Below the tangent of half the opening, 0.6, friction holds the balance of both bars: the ball lies still. Above it, one bar alone
  // can carry the ball up and away from the other.
  const double tangent = 0.6;
  for (const double mu : {0.2, 0.8, 3.0, kInf})
    for (const double turn : {-10.0, 10.0})
    {
      if (turn > 0.0 && mu > tangent) continue;  // they jam it
      World world(betweenBars(turn, -turn, rough(0.5, mu)));
      const Vector3d start = positionOf(world);
      double fastest = 0.0;
      std::size_t events = 0;
      for (int i = 0; i < 100; ++i)
      {
        const StepStatus status = world.advance(kTick);
        ASSERT_FALSE(status.event_limit || status.not_finite) << mu << " " << turn;
        events += status.events;
        if (positionOf(world).z() < 0.0) break;
        fastest = std::max({fastest, velocityOf(world).norm(), kR * world.ballState(0).w_WB.norm()});
      }
      std::printf("[ measured ] bars of 0.5 m/s, mu = %g, %s: fastest %.3g m/s, %zu events\n", mu,
                  turn > 0 ? "inwards" : "outwards", fastest, events);
      EXPECT_LE(fastest, 2.0) << mu << " " << turn;  // rims of 0.5 m/s meet it one after the other
      EXPECT_LE(events, 2000u) << mu << " " << turn;
      if (mu < tangent)
      {
        EXPECT_LE((positionOf(world) - start).norm(), 1e-12) << mu << " " << turn;
      }
    }
}
// --- cost ---

TEST(CostOfACarriedBall, IsAFewEventsASecond)
{
  World rolling(turntable(8.0, rough(0.5, kInf), {0.3, 0, 0}, {0, 0.3, 0}));
  const std::size_t rolls = runFor(rolling, 1.0, 0.01).events;
  World held(turntable(2.0, rough(0.5, 0.5, 0.5), {0.3, 0, 0}, {0, 0.6, 0}));
  const std::size_t lies = runFor(held, 1.0, 0.01).events;
  World bars(betweenBars(4.0, 4.0, rough(0.5, 0.2)));
  runFor(bars, 1.0, 0.01);
  const std::size_t turns = runFor(bars, 1.0, 0.01).events;
  std::printf("[ measured ] events in a second: rolling on a turntable %zu, held by it %zu, between bars %zu\n", rolls,
              lies, turns);
  EXPECT_LE(rolls, 10u);
  EXPECT_LE(lies, 10u);
  EXPECT_LE(turns, 10u);
}
}  // namespace
}  // namespace ping_pong
