#include "detect/ball_ball.h"

namespace ping_pong
{
Detection contactAhead(const Approach& at, double reach, double from, double until)
{
  const double distance = std::sqrt(at.distance_squared);
  const double c = (distance - reach) * (distance + reach);
  if (distance - reach <= touchTolerance(at.p, reach)) return {from, false};
  const double discriminant = at.closing * at.closing - at.speed_squared * c;
  if (discriminant < 0.0) return {};
  const double t = from + c / (std::sqrt(discriminant) - at.closing);
  if (t > until) return {};
  return {t, false};
}
}  // namespace ping_pong
