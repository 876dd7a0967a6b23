#include "arc.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evolve/flight.h"

namespace ping_pong::play
{
namespace
{
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr int kMaxPieces = 64;
constexpr int kMaxLooks = 60;

// Where `value` changes its sign between a and b: Newton's method, kept inside by bisection.
template <class Value, class Slope>
double rootBetween(double a, double b, const Value& value, const Slope& slope)
{
  const bool rises = value(b) > value(a);
  double s = 0.5 * (a + b);
  for (int look = 0; look < kMaxLooks && b - a > 1e-13; ++look)
  {
    const double here = value(s);
    (here > 0.0) == rises ? b = s : a = s;
    const double next = s - here / slope(s);
    const bool inside = next > a && next < b;
    if (inside && std::abs(next - s) < 1e-14) return next;
    s = inside ? next : 0.5 * (a + b);
  }
  return s;
}

// First time in [0, h] at which the path comes down through the height, or kNever.
double comesDown(const Segment& path, double h, double height)
{
  const auto above = [&](double s) { return path.position(s).z() - height; };
  const auto climb = [&](double s) { return path.velocity(s).z(); };
  if (!(above(h) < 0.0)) return kNever;
  double from = 0.0;
  if (climb(0.0) > 0.0)
  {
    if (climb(h) >= 0.0) return kNever;
    from = rootBetween(0.0, h, climb, [&](double s) { return path.acceleration(s).z(); });
  }
  return above(from) >= 0.0 ? rootBetween(from, h, above, climb) : kNever;
}

// Height at which the piece passes the plane towards +x before h, or what it was.
double heightAt(const Segment& path, double h, double x, double before)
{
  const auto beyond = [&](double s) { return path.position(s).x() - x; };
  if (before < kNever || !(beyond(0.0) < 0.0) || !(beyond(h) >= 0.0)) return before;
  return path.position(rootBetween(0.0, h, beyond, [&](double s) { return path.velocity(s).x(); })).z();
}
}  // namespace

std::optional<Arc> flyDownTo(const Flyer& flyer, const BallState& state, double height)
{
  if (flyer.left != nullptr && --*flyer.left < 0) return std::nullopt;
  Arc arc{0.0, state, kNever, kNever};
  Segment path;
  for (int piece = 0; piece < kMaxPieces && arc.duration < flyer.longest; ++piece)
  {
    fly(arc.landing, arc.duration, *flyer.model, flyer.tolerance, path);
    const double h = std::min(path.end - path.start, flyer.longest - arc.duration);
    const double down = comesDown(path, h, height);
    const double last = std::min(down, h);
    arc.over_edge = heightAt(path, last, flyer.edge_x, arc.over_edge);
    arc.over_net = heightAt(path, last, 0.0, arc.over_net);
    arc.landing.p_WB = path.position(last);
    arc.landing.v_WB = path.velocity(last);
    arc.landing.w_WB = path.spin(last);
    arc.duration += last;
    if (down < kNever) return arc;
    if (!arc.landing.p_WB.allFinite()) break;
  }
  return std::nullopt;
}
}  // namespace ping_pong::play
