#include <algorithm>
#include <cmath>

#include "base/law_counter.h"
#include "geometry/tangential.h"
#include "ping_pong_sim/resolve.h"

namespace ping_pong
{
namespace
{
// How much slip a gripping contact takes: all of it, and more if it springs back.
double grip(const Surface& law)
{
  if (law.tangential_restitution == 0.0) return 1.0;
  count(Law::TangentialRestitution);
  return 1.0 + law.tangential_restitution;
}

// Impulse against the slip: what grips, or what friction can do.
Vector3d tangentialImpulse(const Surface& law, const Vector3d& slip, double mass, double normal_impulse)
{
  count(Law::Friction);
  const Vector3d gripping = -grip(law) * mass * slip;
  const double most = law.friction * normal_impulse;
  const double needed = gripping.norm();
  return needed > most ? Vector3d(most / needed * gripping) : gripping;
}

void apply(const BallParams& ball, BallState& state, const Vector3d& n, const Vector3d& impulse)
{
  state.v_WB += impulse / ball.mass;
  state.w_WB -= n.cross(impulse) / (ball.inertia * ball.mass * ball.radius);
}

// Mass that a gripping contact has to stop along the surface.
double slidingMass(const BallParams& ball)
{
  return ball.mass * ball.inertia / (1.0 + ball.inertia);
}

double normalChange(const Surface& law, double closing)
{
  return (1.0 + law.restitutionAt(closing)) * closing;
}

// Closing speed that changes the normal velocity by so much [m/s]. The change grows with it, ever slower: secants from below converge.
double closingSpeedFor(const Surface& law, double change)
{
  constexpr int kMaxSecants = 60;
  double before = change / (1.0 + law.restitution), at_before = normalChange(law, before);
  double closing = std::min(change, before * change / at_before), at_closing = normalChange(law, closing);
  for (int i = 0; i < kMaxSecants && at_closing != change && at_closing != at_before; ++i)
  {
    const double next = closing + (change - at_closing) * (closing - before) / (at_closing - at_before);
    before = closing;
    at_before = at_closing;
    closing = std::min(std::max(next, 0.5 * change), change);  // as e is from 0 to 1
    at_closing = normalChange(law, closing);
  }
  return closing;
}
}  // namespace

Vector3d bounce(const Surface& law, const BallParams& ball, BallState& state, const Vector3d& u_WC, const Vector3d& n_W)
{
  const Vector3d relative = state.v_WB - u_WC;
  const double closing = -n_W.dot(relative);
  if (closing <= 0.0) return Vector3d::Zero();
  count(Law::Restitution);
  const double change = normalChange(law, closing);
  const double normal = ball.mass * change;
  state.v_WB += change * n_W;
  if (law.friction == 0.0) return normal * n_W;
  count(Law::Slip);
  const Vector3d slip = tangential(relative, n_W) - ball.radius * state.w_WB.cross(n_W);
  const Vector3d sideways = tangentialImpulse(law, slip, slidingMass(ball), normal);
  apply(ball, state, n_W, sideways);
  return normal * n_W + sideways;
}

std::optional<Vector3d> surfaceVelocityFor(const Surface& law, const BallParams& ball, const BallState& before,
                                           const Vector3d& J_W, const Vector3d& n_W)
{
  const double normal = n_W.dot(J_W);
  if (!(normal > 0.0)) return std::nullopt;
  const Vector3d sideways = tangential(J_W, n_W);
  const double rounding = 1e-14 * normal;
  Vector3d slip = Vector3d::Zero();
  if (sideways.norm() > rounding)
  {
    if (!(sideways.norm() <= law.friction * normal + rounding) || grip(law) <= 0.0) return std::nullopt;
    slip = -sideways / (grip(law) * slidingMass(ball));
  }
  const double closing = closingSpeedFor(law, normal / ball.mass);
  const Vector3d relative = slip + ball.radius * before.w_WB.cross(n_W) - closing * n_W;
  return before.v_WB - relative;
}

Vector3d part(const Surface& law, double speed, const BallParams& ball1, BallState& state1, const BallParams& ball2,
              BallState& state2, const Vector3d& n_W)
{
  const Vector3d relative = state1.v_WB - state2.v_WB;
  const double closing = -n_W.dot(relative);
  const double reduced = ball1.mass * ball2.mass / (ball1.mass + ball2.mass);
  count(Law::Restitution);
  const double normal = reduced * (closing + speed);
  state1.v_WB += normal / ball1.mass * n_W;
  state2.v_WB -= normal / ball2.mass * n_W;
  if (law.friction == 0.0) return normal * n_W;
  count(Law::Slip);
  const Vector3d spin = ball1.radius * state1.w_WB + ball2.radius * state2.w_WB;
  const Vector3d slip = tangential(relative, n_W) - spin.cross(n_W);
  const double inverse_effective_mass =
      (1.0 + 1.0 / ball1.inertia) / ball1.mass + (1.0 + 1.0 / ball2.inertia) / ball2.mass;
  const Vector3d sideways = tangentialImpulse(law, slip, 1.0 / inverse_effective_mass, normal);
  apply(ball1, state1, n_W, sideways);
  apply(ball2, state2, -n_W, -sideways);
  return normal * n_W + sideways;
}
}  // namespace ping_pong
