#include "ping_pong_sim/resolve.h"

namespace ping_pong
{
Vector3d bounce(const Surface& law, const Vector3d& v_WB, const Vector3d& u_WC, const Vector3d& n_W)
{
  const double closing = n_W.dot(v_WB - u_WC);
  if (closing >= 0.0) return v_WB;
  return v_WB - (1.0 + law.restitution) * closing * n_W;
}

Vector3d impulseBetween(const Surface& law, double m1, const Vector3d& v1, double m2, const Vector3d& v2,
                        const Vector3d& n_W)
{
  const double closing = n_W.dot(v1 - v2);
  if (closing >= 0.0) return Vector3d::Zero();
  return -(1.0 + law.restitution) * closing * (m1 * m2 / (m1 + m2)) * n_W;
}
}  // namespace ping_pong
