#include "energy.h"

#include <cmath>

namespace ping_pong::bench
{
namespace
{
double energyOf(const Vector3d& p, const Vector3d& v, const Vector3d& w, const BallParams& ball,
                const Vector3d& gravity)
{
  const double turning = ball.inertia * ball.radius * ball.radius * w.squaredNorm();
  return ball.mass * (0.5 * (v.squaredNorm() + turning) - gravity.dot(p));
}
}  // namespace

double energyOf(const Scene& scene, const std::vector<BallState>& balls)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < balls.size(); ++i)
    sum += energyOf(balls[i].p_WB, balls[i].v_WB, balls[i].w_WB, scene.balls[i].params, scene.forces.gravity);
  return sum;
}

double trueEnergy(const Start& start, std::size_t sample)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < start.truth.size(); ++i)
  {
    const TrueState& at = start.truth[i].samples[sample];
    sum += energyOf(at.p.cast<double>(), at.v.cast<double>(), at.w.cast<double>(), start.scene.balls[i].params,
                    start.scene.forces.gravity);
  }
  return sum;
}

double sidewaysMomentum(const Scene& scene, const std::vector<BallState>& balls, double energy)
{
  Vector3d momentum = Vector3d::Zero();
  double mass = 0.0;
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    momentum += scene.balls[i].params.mass * balls[i].v_WB;
    mass += scene.balls[i].params.mass;
  }
  return momentum.head<2>().norm() / std::sqrt(2.0 * mass * energy);
}
}  // namespace ping_pong::bench
