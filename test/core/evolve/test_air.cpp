// Flight through air: closed forms, and agreement with an independent integration in long double.
#include <gtest/gtest.h>

#include <random>

#include "evolve/flight.h"
#include "testing/air_shots.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
constexpr double kRho = 1.2041;
constexpr double kArea = kPi * kR * kR;
constexpr double kVolume = 4.0 / 3.0 * kPi * kR * kR * kR;

Scene inAir(const Forces& forces, const Vector3d& p, const Vector3d& v, const Vector3d& w = Vector3d::Zero(),
            double tolerance = 1e-11)
{
  Scene scene = SceneBuilder().ball(p, v).build();
  scene.forces = forces;
  scene.balls[0].state.w_WB = w;
  scene.tolerance = tolerance;
  return scene;
}

Forces onlyDrag(double C_D)
{
  Forces forces;
  forces.drag = true;
  forces.drag_law = DragLaw::constant(C_D);
  return forces;
}

Forces withLinearLift(Forces forces, double slope)
{
  forces.magnus = true;
  forces.lift_law.kind = LiftLaw::Kind::Linear;
  forces.lift_law.slope = slope;
  return forces;
}

constexpr LiftLaw::Kind kLaws[] = {LiftLaw::Kind::Saturating, LiftLaw::Kind::Linear, LiftLaw::Kind::Constant};

// --- closed forms ---

TEST(Air, AFallWithDragIsALogarithmOfACosh)
{
  Forces forces = onlyDrag(0.44);
  forces.gravity = Vector3d(0, 0, -kG);
  World world(inAir(forces, {0, 0, 100}, {0, 0, 0}));
  const double v_t = std::sqrt(2.0 * kBallMass * kG / (kRho * kArea * 0.44));
  double worst_z = 0.0, worst_v = 0.0;
  for (int i = 1; i <= 300; ++i)
  {
    world.advance(0.01);
    const double x = kG * 0.01 * i / v_t;
    worst_z = std::max(worst_z, std::abs(100.0 - v_t * v_t / kG * std::log(std::cosh(x)) - positionOf(world).z()));
    worst_v = std::max(worst_v, std::abs(v_t * std::tanh(x) + velocityOf(world).z()));
  }
  measured("fall of 3 s, position error [m]", worst_z);
  EXPECT_LE(worst_z, 3e-11);  // the tolerance, 1e-11 per second
  EXPECT_LE(worst_v, 3e-10);  // ten times that per second: drag acts within tenths of a second
}

TEST(Air, ABallFallsNoFasterThanItsTerminalSpeed)
{
  Forces forces = onlyDrag(0.44);
  forces.gravity = Vector3d(0, 0, -kG);
  const double v_t = std::sqrt(2.0 * kBallMass * kG / (kRho * kArea * 0.44));
  EXPECT_NEAR(v_t, 8.92, 0.01);           // from the literature's numbers for this ball
  for (const double start : {0.0, 40.0})  // from below and from above
  {
    World world(inAir(forces, {0, 0, 1000}, {0, 0, -start}));
    world.advance(20.0);  // 22 time scales v_t/g: e^-44 is left
    EXPECT_NEAR(-velocityOf(world).z(), v_t, 1e-10);
  }
}

TEST(Air, ALinearMagnusForceMakesACircle)
{
  const double slope = 1.0, spin = 600.0, speed = 12.0;
  World world(inAir(withLinearLift(Forces(), slope), {0, 0, 0}, {speed, 0, 0}, {0, 0, spin}));
  const double rate = kRho * kArea * kR * slope / (2.0 * kBallMass) * spin;
  const double radius = speed / rate, period = 2.0 * kPi / rate;
  const Vector3d centre(0, radius, 0);  // w x v points to the left
  for (int i = 1; i <= 40; ++i)
  {
    world.advance(period / 40.0);
    const double angle = 2.0 * kPi * i / 40.0;
    const Vector3d truth = centre + radius * Vector3d(std::sin(angle), -std::cos(angle), 0);
    EXPECT_LE((positionOf(world) - truth).norm(), 1e-10);  // the tolerance times 1.9 s and 3.5 m radius
    EXPECT_NEAR(velocityOf(world).norm(), speed, 1e-10);   // a force across the flight does no work
  }
  measured("back at the start after one turn, off by [m]", positionOf(world).norm());
}

TEST(Air, DragAndMagnusMakeASpiral)
{
  const double spin = 500.0, speed = 20.0, C_D = 0.5, slope = 0.8;
  World world(inAir(withLinearLift(onlyDrag(C_D), slope), {0, 0, 0}, {speed, 0, 0}, {0, 0, spin}));
  const double k = kRho * kArea * C_D / (2.0 * kBallMass);
  const double rate = kRho * kArea * kR * slope / (2.0 * kBallMass) * spin;
  const auto velocity = [&](Real t) {  // the speed falls as if it flew straight on, the direction turns evenly
    const Real v = speed / (1.0L + k * speed * t);
    return Vector3r(v * std::cos(rate * t), v * std::sin(rate * t), 0.0L);
  };
  const int steps = 2000;
  const Real h = 1.0L / steps;
  Vector3r p = Vector3r::Zero();
  for (int i = 0; i < steps; ++i)  // Simpson's rule: h^4 leaves 1e-12
  {
    p += h / 6.0L * (velocity(h * i) + 4.0L * velocity(h * (i + 0.5L)) + velocity(h * (i + 1)));
    world.advance(1.0 / steps);
  }
  EXPECT_LE(distance(velocityOf(world), velocity(1.0L)), 1e-10);
  EXPECT_LE(distance(positionOf(world), p), 3e-11);  // the tolerance and Simpson's
}

TEST(Air, WindIsAMovingFrame)
{
  const Vector3d wind(2.0, -1.0, 0.5), p(0, 0, 1), v(8.0, 1.0, 2.0), w(100.0, -300.0, 50.0);
  Forces still = defaultAir(), windy = still;
  windy.wind = wind;
  World in_still_air(inAir(still, p, v, w)), in_wind(inAir(windy, p, v + wind, w));
  for (int i = 1; i <= 100; ++i)
  {
    in_still_air.advance(0.01);
    in_wind.advance(0.01);
    EXPECT_LE((positionOf(in_wind) - positionOf(in_still_air) - 0.01 * i * wind).norm(), 2e-11);  // both tolerances
  }
}

TEST(Air, BuoyancyAndAddedMassAreTwoConstants)
{
  const double lifted = 1.0 - kRho * kVolume / kBallMass;         // 1.49 % of the weight
  const double heavier = 1.0 + 0.5 * kRho * kVolume / kBallMass;  // 0.75 % of the mass
  for (const bool buoyancy : {false, true})
    for (const bool added_mass : {false, true})
    {
      Forces forces = onlyGravity();
      forces.buoyancy = buoyancy;
      forces.added_mass = added_mass;
      World world(inAir(forces, {0, 0, 0}, {3, 0, 1}));
      world.advance(0.5);
      const double g = kG * (buoyancy ? lifted : 1.0) / (added_mass ? heavier : 1.0);
      EXPECT_NEAR(positionOf(world).z(), 0.5 - 0.5 * g * 0.25, 1e-14);
    }
  EXPECT_NEAR(1.0 - lifted, 0.0149, 1e-4);
  EXPECT_NEAR(heavier - 1.0, 0.0075, 1e-4);
}

TEST(Air, SpinDecaysExponentially)
{
  Forces forces = defaultAir();
  forces.spin_decay = 0.15;
  const Vector3d w(100.0, -200.0, 300.0);
  World world(inAir(forces, {0, 0, 0}, {5, 0, 0}, w));
  world.advance(2.0);
  const BallState state = world.ballState(0);
  EXPECT_LE((state.w_WB - std::exp(-0.15 * 2.0) * w).norm(), 1e-12);
  // The axis stays, so the ball has turned about it by the integral of the spin.
  const double angle = w.norm() * (1.0 - std::exp(-0.3)) / 0.15;
  const Vector3d x = Eigen::AngleAxisd(angle, w.normalized()) * Vector3d::UnitX();
  EXPECT_LE((state.q_WB * Vector3d::UnitX() - x).norm(), 1e-11);  // 650 rad are rounded to 1e-13
}

TEST(Air, TheMagnusForceOfAThrownTopspinPointsDown)
{
  // Forwards x, topspin about +y: the front side moves down, and so does the ball.
  World world(inAir(defaultAir(), {0, 0, 0}, {10, 0, 0}, {0, 300, 0}));
  world.advance(0.2);
  EXPECT_LT(positionOf(world).z(), -0.5 * kG * 0.04 - 0.05);
  EXPECT_EQ(positionOf(world).y(), 0.0);
}

TEST(Air, DensityFollowsTemperatureAndAltitude)
{
  EXPECT_NEAR(airDensity(293.15, 0.0), 1.2041, 1e-4);
  EXPECT_NEAR(airDensity(288.15, 0.0), 1.2250, 1e-4);     // ICAO standard atmosphere at sea level
  EXPECT_NEAR(airDensity(278.40, 1500.0), 1.0581, 2e-4);  // and at 1500 m
}

// --- tables ---

TEST(AirTables, DragIsBilinearBetweenNodesAndConstantBeyond)
{
  DragLaw law;
  law.reynolds = {1e4, 3e4};
  law.spin_ratio = {0.0, 0.5, 1.0};
  law.values = {0.40, 0.45, 0.55, 0.42, 0.47, 0.60};
  EXPECT_DOUBLE_EQ(law.at(1e4, 0.5), 0.45);
  EXPECT_DOUBLE_EQ(law.at(3e4, 1.0), 0.60);
  EXPECT_DOUBLE_EQ(law.at(2e4, 0.25), 0.25 * (0.40 + 0.45 + 0.42 + 0.47));
  EXPECT_DOUBLE_EQ(law.at(1.0, -0.0), 0.40);
  EXPECT_DOUBLE_EQ(law.at(1e9, 9.0), 0.60);
}

TEST(AirTables, LiftIsLinearBetweenNodesFromZeroAndConstantBeyond)
{
  LiftLaw law;
  law.kind = LiftLaw::Kind::Table;
  law.spin_ratio = {0.2, 0.5, 1.0};
  law.values = {0.18, 0.24, 0.30};
  EXPECT_DOUBLE_EQ(law.perSpinRatio(0.0), 0.9);
  EXPECT_DOUBLE_EQ(0.1 * law.perSpinRatio(0.1), 0.09);
  EXPECT_DOUBLE_EQ(0.35 * law.perSpinRatio(0.35), 0.21);
  EXPECT_DOUBLE_EQ(3.0 * law.perSpinRatio(3.0), 0.30);
}

TEST(AirTables, KinksOfATableStayWithinTheTolerance)
{
  Forces forces = defaultAir();
  forces.lift_law.kind = LiftLaw::Kind::Table;
  forces.lift_law.spin_ratio = {0.2, 0.5, 1.0};
  forces.lift_law.values = {0.18, 0.10, 0.30};  // with a valley
  const LiftLaw law = forces.lift_law;
  AirReference reference = referenceOf(forces);
  reference.C_L = [law](Real S) { return S * law.perSpinRatio(static_cast<double>(S)); };
  std::mt19937 random(5);
  double worst = 0.0;
  for (int i = 0; i < 50; ++i)
  {
    const BallState shot = randomShot(random);
    World world(inAir(forces, shot.p_WB, shot.v_WB, shot.w_WB, 1e-6));
    world.advance(0.5);
    worst = std::max(worst, distance(positionOf(world), reference.flown(stateOf(shot), 0.5L, 5e-4L).p));
  }
  measured("0.5 s through a table with kinks, tolerance 1e-6: error [m]", worst);
  EXPECT_LE(worst, 1e-6);
}

// --- against the reference ---

struct Landing
{
  double point = 0.0, speed = 0.0, spin = 0.0;  // worst errors [m], [m/s], [rad/s]
};

Landing worstLanding(const Forces& forces, double tolerance, int shots)
{
  std::mt19937 random(1);
  const AirReference reference = referenceOf(forces);
  Landing worst;
  for (int i = 0; i < shots; ++i)
  {
    const BallState shot = randomShot(random);
    Scene scene = SceneBuilder().floor().ball(shot.p_WB, shot.v_WB).build();
    scene.balls[0].state = shot;
    scene.forces = forces;
    scene.tolerance = tolerance;
    World world(scene);
    world.advance(3.0);
    if (world.contacts().empty())
    {
      ADD_FAILURE() << "shot " << i << " did not land within 3 s";
      continue;
    }
    const Contact& contact = world.contacts().front();
    AirReference::State landed = stateOf(shot);
    reference.fallTo(kR, landed);
    worst.point = std::max(worst.point, distance(contact.p_WC + kR * Vector3d::UnitZ(), landed.p));
    worst.speed = std::max(worst.speed, distance(contact.v_before, landed.v));
    worst.spin = std::max(worst.spin, distance(contact.w_before, landed.w));
  }
  return worst;
}

TEST(AirReference, LandsWhereTheReferenceLands)
{
  for (const LiftLaw::Kind law : kLaws)
    for (const double tolerance : {1e-11, 1e-10})
    {
      const Landing worst = worstLanding(fullAir(law), tolerance, 40);
      measured("reference mode, landing point [m]", worst.point);
      measured("reference mode, landing speed [m/s]", worst.speed);
      EXPECT_LE(worst.point, 1e-9) << "law " << static_cast<int>(law) << ", tolerance " << tolerance;
      EXPECT_LE(worst.speed, 1e-9) << "law " << static_cast<int>(law) << ", tolerance " << tolerance;
      EXPECT_LE(worst.spin, 1e-9) << "law " << static_cast<int>(law) << ", tolerance " << tolerance;
    }
}

TEST(AirReference, DefaultToleranceLandsWithinATenthOfAMillimetre)
{
  for (const LiftLaw::Kind law : kLaws)
  {
    const Landing worst = worstLanding(fullAir(law), Scene().tolerance, 40);
    measured("default tolerance, landing point [m]", worst.point);
    EXPECT_LE(worst.point, 1e-4);
    EXPECT_LE(worst.speed, 1e-3);  // [m/s]: air changes a velocity at 1 to 10 per second
  }
}

constexpr double kRally = 1.0;  // [s]
const Surface kTable{0.93, 0.0, 0.25};

Vector3d endOfRally(const BallState& shot, double tolerance)
{
  Scene scene = SceneBuilder().floor().ball(shot.p_WB, shot.v_WB).build();
  scene.balls[0].state = shot;
  scene.forces = fullAir(LiftLaw::Kind::Saturating);
  scene.tolerance = tolerance;
  scene.surfaces.set(0, 1, kTable);
  World world(scene);
  world.advance(kRally);
  return positionOf(world);
}

TEST(AirReference, ToleranceIsKeptToTheEndOfARally)
{
  std::mt19937 random(11);
  std::vector<BallState> shots(60);
  std::vector<Vector3r> truths;
  int bounces = 0;
  const AirReference reference = referenceOf(fullAir(LiftLaw::Kind::Saturating));
  for (BallState& shot : shots)
  {
    shot = randomShot(random);
    truths.push_back(reference.rally(stateOf(shot), kTable, kRally, &bounces).p);
  }
  EXPECT_GE(bounces, 60);
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11})
  {
    double worst = 0.0;
    for (std::size_t i = 0; i < shots.size(); ++i)
      worst = std::max(worst, distance(endOfRally(shots[i], tolerance), truths[i]));
    std::printf("[ measured ] tolerance %.0e: worst error at the end of 60 rallies %.2e m\n", tolerance, worst);
    EXPECT_LE(worst, tolerance);
  }
}

TEST(AirReference, IsAsAccurateInsideAPieceAsAtItsEnd)
{
  std::mt19937 random(3);
  const Forces forces = fullAir(LiftLaw::Kind::Saturating);
  const AirReference reference = referenceOf(forces);
  for (const double tolerance : {1e-4, 1e-7, 1e-10})
  {
    double worst = 0.0;
    for (int shot = 0; shot < 10; ++shot)
    {
      const BallState start = randomShot(random);
      World world(inAir(forces, start.p_WB, start.v_WB, start.w_WB, tolerance));
      AirReference::State truth = stateOf(start);
      for (int i = 1; i <= 500; ++i)
      {
        world.advance(2e-3);
        truth = reference.step(truth, 2e-3);
        worst = std::max(worst, distance(positionOf(world), truth.p));
      }
    }
    std::printf("[ measured ] tolerance %.0e: worst error at any of 5000 instants %.2e m\n", tolerance, worst);
    EXPECT_LE(worst, tolerance);
  }
}

TEST(AirReference, VelocityIsTheDerivativeOfPositionInsideAPiece)
{
  const Forces forces = defaultAir();
  const BallParams ball;
  const FlightModel model(forces, ball);
  BallState state;
  state.v_WB = Vector3d(10, 2, 3);
  state.w_WB = Vector3d(50, 300, -80);
  Segment piece;
  fly(state, 0.0, model, 1e-9, piece);
  ASSERT_GT(piece.end, 0.003);
  for (int i = 1; i < 16; ++i)
  {
    const double s = piece.end * i / 16.0, d = 1e-5;  // central differences: d^2 and rounding / d leave 1e-9
    const Vector3d slope = (piece.position(s + d) - piece.position(s - d)) / (2.0 * d);
    EXPECT_LE((piece.velocity(s) - slope).norm(), 1e-8);
    EXPECT_LE((piece.acceleration(s) - model.acceleration(piece.velocity(s), state.w_WB)).norm(), 1e-4);
  }
}

TEST(AirReference, TicksDoNotChangeTheFlight)
{
  std::mt19937 random(8);
  const BallState shot = randomShot(random);
  World once(inAir(defaultAir(), shot.p_WB, shot.v_WB, shot.w_WB, 1e-6));
  World often(inAir(defaultAir(), shot.p_WB, shot.v_WB, shot.w_WB, 1e-6));
  once.advance(1.0);
  for (int i = 0; i < 1000; ++i) often.advance(1e-3);
  EXPECT_LE((positionOf(once) - positionOf(often)).norm(), 1e-14);  // the clock's rounding
}

// --- where methods fail ---

TEST(AirLimits, StiffDragAtTenThousandMetresPerSecond)
{
  const double k = kRho * kArea * 0.44 / (2.0 * kBallMass), v0 = 1e4;
  World world(inAir(onlyDrag(0.44), {0, 0, 0}, {v0, 0, 0}, Vector3d::Zero(), 1e-6));
  const StepStatus status = world.advance(0.1);
  EXPECT_TRUE(status.ok());
  EXPECT_NEAR(velocityOf(world).x(), v0 / (1.0 + k * v0 * 0.1), 1e-4);  // 80.5 m/s; Euler's sign flips here
  EXPECT_NEAR(positionOf(world).x(), std::log1p(k * v0 * 0.1) / k, 1e-5);
  measured("10 000 m/s, position error after 0.1 s [m]", positionOf(world).x() - std::log1p(k * v0 * 0.1) / k);
}

TEST(AirLimits, SpinAtNoSpeedIsHarmless)
{
  for (const LiftLaw::Kind law : kLaws)
  {
    Forces forces = fullAir(law);
    forces.wind = Vector3d::Zero();
    const Vector3d w(0, 2000.0, 500.0);  // 328 rev/s
    World dropped(inAir(forces, {0, 0, 0}, {0, 0, 0}, w, 1e-9));
    EXPECT_TRUE(dropped.advance(0.3).ok());
    AirReference::State start;
    start.w = w.cast<Real>();
    // The reference starts a step late, where the speed is not zero: until then it falls freely, and that is right to 1e-9 m.
    const double late = 1e-5;
    start.p = Vector3r(0, 0, -0.5L * kG * late * late);
    start.v = Vector3r(0, 0, -static_cast<Real>(kG) * late);
    const AirReference reference = referenceOf(forces);
    EXPECT_LE(distance(positionOf(dropped), reference.flown(start, 0.3L - late, 1e-4L).p), 1e-6)
        << "law " << static_cast<int>(law);
    forces.gravity = Vector3d::Zero();
    World hovering(inAir(forces, {1, 2, 3}, {0, 0, 0}, w, 1e-9));
    hovering.advance(1.0);
    EXPECT_EQ(positionOf(hovering), Vector3d(1, 2, 3));
  }
}

TEST(AirLimits, AThrowStraightUpTurnsRoundAtNoSpeed)
{
  Forces forces = defaultAir();
  forces.magnus = false;
  const double k = kRho * kArea * 0.33 / (2.0 * kBallMass), v_t = std::sqrt(kG / k);
  const double up = v_t / kG * std::atan(6.0 / v_t);
  const double apex = 0.5 / k * std::log1p(36.0 / (v_t * v_t));
  const double truth = apex - std::log(std::cosh(kG * (1.2 - up) / v_t)) / k;
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-11})
  {
    World world(inAir(forces, {0, 0, 0}, {0, 0, 6.0}, Vector3d::Zero(), tolerance));
    world.advance(1.2);
    const double error = std::abs(positionOf(world).z() - truth);
    std::printf("[ measured ] tolerance %.0e: error after the turn %.2e m\n", tolerance, error);
    // Drag has no third derivative where the speed is exactly zero: pieces across that instant have to be short.
    EXPECT_LE(error, tolerance);
  }
}
}  // namespace
}  // namespace ping_pong
