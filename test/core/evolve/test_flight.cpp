// Flight in vacuum: `exact` is the parabola; both Euler methods miss it by g h T / 2, one above and one below.
#include <gtest/gtest.h>

#include "ping_pong_sim/scene_loader.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
const Vector3d kStart(-2.0, 0.3, 1.0);
const Vector3d kThrow(5.0, -1.0, 3.5);

// In long double, so that the truth has no rounding of its own at 1e-16.
Vector3d parabola(const Vector3d& p, const Vector3d& v, double t)
{
  const long double s = t;
  const long double fall = 0.5L * static_cast<long double>(kG) * s * s;
  return {static_cast<double>(p.x() + v.x() * s), static_cast<double>(p.y() + v.y() * s),
          static_cast<double>(p.z() + v.z() * s - fall)};
}

World thrown(Method method, double dt)
{
  return SceneBuilder(method, dt).gravity(kG).ball(kStart, kThrow).world();
}

double heightError(Method method, double dt, double duration)
{
  World world = thrown(method, dt);
  world.advance(duration);
  return positionOf(world).z() - parabola(kStart, kThrow, duration).z();
}

// Rodrigues' formula, written out: where an axis of the ball points after turning with spin w for t.
Vector3d rotated(const Vector3d& x, const Vector3d& w, double t)
{
  const double angle = w.norm() * t;
  const Vector3d k = w.normalized();
  return x * std::cos(angle) + k.cross(x) * std::sin(angle) + k * k.dot(x) * (1.0 - std::cos(angle));
}

TEST(Flight, ExactIsTheParabolaAtEveryTick)
{
  World world = thrown(Method::Exact, 1e-3);
  double worst = 0.0;
  for (int i = 1; i <= 10000; ++i)
  {
    world.advance(1e-3);
    const Vector3d truth = parabola(kStart, kThrow, 1e-3 * i);
    worst = std::max(worst, (positionOf(world) - truth).norm() / std::max(1.0, truth.norm()));
  }
  measured("relative position error over 10 s", worst);
  EXPECT_LE(worst, 1e-15);  // a few roundings of a number of size 1
}

TEST(Flight, ArcSceneIsTheParabolaToAPicometre)
{
  Scene scene = loadScene(std::string(SCENES_DIR) + "/arc.yaml");
  const BallState start = scene.balls.at(0).state;
  World world(scene);
  double worst = 0.0;
  for (int i = 1; i <= 460; ++i)  // to 0.92 s; it lands at 0.929 s
  {
    world.advance(2e-3);
    worst = std::max(worst, (positionOf(world) - parabola(start.p_WB, start.v_WB, 2e-3 * i)).norm());
  }
  measured("arc.yaml, position error [m]", worst);
  EXPECT_LE(worst, 1e-12);  // the bound; rounding is 1e-15
}

TEST(Flight, EulerMissesByHalfAStepOfFall)
{
  const double T = 0.9;
  for (const double h : {0.1, 0.02, 1e-3, 1e-4})
  {
    const double drift = 0.5 * kG * h * T;  // sum of g h k h over the steps against g T^2 / 2
    const double rounding = 1e-16 * 2.0 * T / h;
    EXPECT_NEAR(heightError(Method::EulerExplicit, h, T), drift, 1e-15 + rounding);
    EXPECT_NEAR(heightError(Method::EulerSemiImplicit, h, T), -drift, 1e-15 + rounding);
    EXPECT_NEAR(heightError(Method::Exact, h, T), 0.0, 1e-15);
  }
  measured("explicit, h = 1 ms, T = 0.9 s: too high by [m]", heightError(Method::EulerExplicit, 1e-3, T));
  measured("semi-implicit, the same [m]", heightError(Method::EulerSemiImplicit, 1e-3, T));
}

TEST(Flight, EulerIsOfFirstOrder)
{
  for (const Method method : {Method::EulerExplicit, Method::EulerSemiImplicit})
    for (double h = 0.1; h > 1e-3; h *= 0.5)
      EXPECT_NEAR(heightError(method, h, 0.8) / heightError(method, 0.5 * h, 0.8), 2.0, 1e-9) << name(method);
}

TEST(Flight, BallTurnsWithItsSpin)
{
  const Vector3d w(30.0, -80.0, 150.0);
  const Quaterniond q0(Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()));
  for (const Method method : kMethods)
  {
    Scene scene = SceneBuilder(method).gravity(kG).ball(kStart, kThrow).build();
    scene.balls[0].state.q_WB = q0;
    scene.balls[0].state.w_WB = w;
    World world(scene);
    for (int i = 0; i < 500; ++i) world.advance(2e-3);
    const BallState state = world.ballState(0);
    for (int axis = 0; axis < 3; ++axis)
      // 170 rad of turning: the angle itself is rounded to 3e-14, a step adds 1e-16.
      EXPECT_LE((state.q_WB * Vector3d::Unit(axis) - rotated(q0 * Vector3d::Unit(axis), w, 1.0)).norm(), 1e-12)
          << name(method);
    EXPECT_EQ(state.w_WB, w);
    EXPECT_NEAR(state.q_WB.norm(), 1.0, 1e-15);
  }
}

TEST(Flight, WithoutForcesABallFliesStraightOn)
{
  for (const Method method : kMethods)
  {
    World world = SceneBuilder(method).ball(kStart, kThrow).world();
    world.advance(1.0);
    EXPECT_LE((positionOf(world) - kStart - kThrow).norm(), 2e-13) << name(method);  // 1000 roundings of 5 m
    EXPECT_EQ(velocityOf(world), kThrow);
  }
}
}  // namespace
}  // namespace ping_pong
