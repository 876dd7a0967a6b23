#include "moment.h"

#include <algorithm>
#include <cmath>

namespace ping_pong::stability
{
namespace
{
double energyOf(const BallParams& ball, const BallState& state, const Vector3d& g)
{
  const double rim = ball.radius * state.w_WB.norm();
  return 0.5 * state.v_WB.squaredNorm() + 0.5 * ball.inertia * rim * rim - g.dot(state.p_WB);
}
}  // namespace

double Moment::depth() const
{
  double deepest = 0.0;
  for (const Touch& touch : around) deepest = std::max(deepest, -touch.gap);
  return deepest;
}

double Moment::scale() const
{
  return ball.v_WB.norm() + radius * ball.w_WB.norm() + 1.0;
}

Moment momentOf(const World& world, const Vector3d& g)
{
  Moment now;
  const BallParams& params = world.ballParams(0);
  now.time = world.time();
  now.ball = world.ballState(0);
  now.radius = params.radius;
  now.energy = energyOf(params, now.ball, g);
  for (std::size_t b = 0; b < world.bodyCount(); ++b)
    for (std::size_t s = 0; s < world.body(b).shapes.size(); ++s)
      now.around.push_back(
          touchOf(world.body(b), {b, s}, world.bodyPose(b), world.bodyTwist(b), now.ball, params.radius));
  for (const Touch& touch : now.around)
    if (touch.gap < kTouchGap) now.touching.push_back(touch);
  // `impulse` keeps no account of it.
  now.held = world.method() == Method::Impulse ? !now.touching.empty() : !std::isnan(world.restingSince(0));
  return now;
}

Vector3d pullOf(const Scene& scene)
{
  return FlightModel(scene.forces, scene.balls[0].params).acceleration(scene.forces.wind, Vector3d::Zero());
}

bool sameTouches(const Moment& a, const Moment& b)
{
  return std::equal(a.touching.begin(), a.touching.end(), b.touching.begin(), b.touching.end(),
                    [](const Touch& x, const Touch& y) { return x.of.body == y.of.body && x.of.shape == y.of.shape; });
}
}  // namespace ping_pong::stability
