#include "touch.h"

#include <algorithm>

namespace ping_pong::stability
{
Touch touchOf(const Body& body, ShapeName of, const Pose& X_WB, const Twist& twist, const BallState& ball,
              double radius)
{
  const Proximity nearest = proximity(body.shapes[of.shape], X_WB.q.conjugate() * (ball.p_WB - X_WB.p));
  Touch touch;
  touch.of = of;
  touch.gap = nearest.distance - radius;
  touch.n_W = X_WB.q * nearest.normal;
  touch.u_WC = twist.v + twist.w.cross(ball.p_WB - radius * touch.n_W - X_WB.p);
  touch.turns = !twist.w.isZero(0.0);
  return touch;
}

Vector3d slipOf(const Touch& touch, const BallState& ball, double radius)
{
  const Vector3d over = ball.v_WB - touch.u_WC;
  return over - touch.n_W.dot(over) * touch.n_W - radius * ball.w_WB.cross(touch.n_W);
}

double deepest(const std::vector<Body>& bodies, const Vector3d& p_WB, double radius)
{
  double depth = -Stage::kNoLimit;
  BallState ball;
  ball.p_WB = p_WB;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (std::size_t s = 0; s < bodies[b].shapes.size(); ++s)
      depth = std::max(depth, -touchOf(bodies[b], {b, s}, bodies[b].pose, Twist(), ball, radius).gap);
  return depth;
}
}  // namespace ping_pong::stability
