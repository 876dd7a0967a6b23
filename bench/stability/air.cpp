#include <algorithm>
#include <cmath>

#include "situations.h"

namespace ping_pong::stability
{
namespace
{
World inAir(Method method, double dt, const Forces& forces, const Vector3d& v, const Vector3d& w)
{
  Scene scene = SceneBuilder(method, dt).ball({0, 0, 0}, v).build();
  scene.forces = forces;
  scene.balls[0].state.w_WB = w;
  return World(scene);
}
}  // namespace

double fastDragError(Method method, double dt)
{
  constexpr double kSpeed = 1e4, kEnd = 0.1, kDrag = 0.53;  // [m/s], [s], C_D
  Forces forces;
  forces.drag = true;
  forces.drag_law = DragLaw::constant(kDrag);
  World world = inAir(method, dt, forces, {kSpeed, 0, 0}, {0, 0, 0});
  world.advance(kEnd);
  const double k = 0.5 * forces.air_density * kPi * kR * kR * kDrag / kBallMass;  // [1/m]
  const double truth = kSpeed / (1.0 + k * kSpeed * kEnd);
  return (velocityOf(world) - Vector3d(truth, 0, 0)).norm() / truth;
}

double spinWithoutSpeed(Method method, double dt)
{
  double fastest = 0.0;
  for (const LiftLaw::Kind law : {LiftLaw::Kind::Linear, LiftLaw::Kind::Saturating, LiftLaw::Kind::Constant})
    for (const double speed : {0.0, 1e-12})
    {
      Forces forces;
      forces.drag = forces.magnus = true;
      forces.lift_law.kind = law;
      World world = inAir(method, dt, forces, {speed, 0, 0}, {0, 0, 2000});
      world.advance(1.0);
      const double after = velocityOf(world).norm();
      if (!(after < 1e300)) return after;
      fastest = std::max(fastest, after);
    }
  return fastest;
}

double magnusCircleError(Method method, double dt)
{
  constexpr double kSpeed = 10.0, kSpin = 600.0;  // [m/s], [rad/s]
  Forces forces;
  forces.magnus = true;
  forces.lift_law.kind = LiftLaw::Kind::Linear;
  forces.lift_law.slope = 0.6;
  World world = inAir(method, dt, forces, {kSpeed, 0, 0}, {0, 0, kSpin});
  // The lift turns the velocity at L w, L = rho A r slope / (2 m).
  const double turning = 0.5 * forces.air_density * kPi * kR * kR * kR * forces.lift_law.slope / kBallMass * kSpin;
  world.advance(2.0 * kPi / turning);
  return std::abs(velocityOf(world).norm() / kSpeed - 1.0);
}
}  // namespace ping_pong::stability
