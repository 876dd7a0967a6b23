#include "stroke_inversion.h"

#include <algorithm>
#include <cmath>

namespace ping_pong::play
{
namespace
{
constexpr double kInsideFriction = 1.0 - 1e-9;  // of mu: rounding shall not make a contact slide that just grips

// Change of spin within reach, and the sine of the lean of J from the normal that it takes.
struct SpinChange
{
  Vector3d dw = Vector3d::Zero();
  double lean_sine = 0.0;
};

SpinChange spinChange(const Surface& law, const BallParams& ball, const Vector3d& J, const Vector3d& wanted)
{
  const Vector3d across = wanted - J * (J.dot(wanted) / J.squaredNorm());
  const double length = across.norm();
  if (!(length > 0.0)) return {};
  const double inertia = ball.inertia * ball.mass * ball.radius * ball.radius;
  const double lever = ball.radius * J.norm() / inertia;  // change of spin when all of J is friction
  const double lean = std::min(std::atan(kInsideFriction * law.friction), kMostLean);
  const double sine = std::min(length / lever, std::sin(lean));
  return {across * (sine * lever / length), sine};
}
}  // namespace

Vector3d reachableSpin(const Surface& law, const BallParams& ball, const BallState& before, const Vector3d& v_out,
                       const Vector3d& w_wanted)
{
  const Vector3d J = ball.mass * (v_out - before.v_WB);
  if (!(J.squaredNorm() > 0.0)) return before.w_WB;
  return before.w_WB + spinChange(law, ball, J, w_wanted - before.w_WB).dw;
}

std::optional<RacketImpact> invertStroke(const Surface& law, const BallParams& ball, const BallState& before,
                                         const Vector3d& v_out, const Vector3d& w_wanted)
{
  const Vector3d J = ball.mass * (v_out - before.v_WB);
  if (!(J.squaredNorm() > 0.0)) return std::nullopt;
  const SpinChange change = spinChange(law, ball, J, w_wanted - before.w_WB);
  const Vector3d along = J.normalized();
  Vector3d n = along;
  if (change.lean_sine > 0.0)
    n = std::sqrt(1.0 - change.lean_sine * change.lean_sine) * along +
        change.lean_sine * change.dw.cross(along).normalized();
  n.normalize();
  const std::optional<Vector3d> v = surfaceVelocityFor(law, ball, before, J, n);
  if (!v) return std::nullopt;
  return RacketImpact{n, *v, before.w_WB + change.dw};
}
}  // namespace ping_pong::play
