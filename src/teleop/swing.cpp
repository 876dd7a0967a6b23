#include "swing.h"

#include <cmath>

namespace ping_pong
{
// With s = t - hit_at: p = v s cos^2(pi s / 2 half), which has slope v at s = 0 and slope 0 at both ends.
SwingPoint at(const Swing& swing, double time)
{
  const double s = time - swing.hit_at;
  if (std::abs(s) >= swing.half) return {};
  const double angle = 0.5 * M_PI * s / swing.half;
  const double c = std::cos(angle);
  return {swing.v * (s * c * c), swing.v * (c * c - angle * std::sin(2.0 * angle))};
}
}  // namespace ping_pong
