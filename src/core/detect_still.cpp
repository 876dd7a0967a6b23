// First contact with a shape that does not move: the path is taken into the shape's frame once, and searched there.
#include "count.h"
#include "fall_on_plane.h"
#include "proximity_here.h"

namespace ping_pong
{
namespace
{
double hornerScalar(const double* c, int degree, double s)
{
  double sum = c[degree];
  for (int k = degree - 1; k >= 0; --k) sum = sum * s + c[k];
  return sum;
}

double slopeScalar(const double* c, int degree, double s)
{
  double sum = 0.0;
  for (int k = degree; k >= 1; --k) sum = sum * s + k * c[k];
  return sum;
}

double curvatureScalar(const double* c, int degree, double s)
{
  double sum = 0.0;
  for (int k = degree; k >= 2; --k) sum = sum * s + k * (k - 1) * c[k];
  return sum;
}

// Only the height above the plane matters.
Detection meetPlane(const Segment& path, double radius, const Shape& shape, double from, double until)
{
  const Vector3d n = shape.R_BS.col(2);
  if (path.degree == 2) return fallOnPlane(path, radius, n, shape, from, until);
  double height[Segment::kMaxDegree + 1];
  height[0] = n.dot(path.c[0] - shape.p_BS) - radius;
  for (int k = 1; k <= path.degree; ++k) height[k] = n.dot(path.c[k]);
  const double least = leastAlong(n, path.a_low, path.a_high);
  const auto at = [&](double t) {
    const double s = t - path.start;
    return Look{hornerScalar(height, path.degree, s), slopeScalar(height, path.degree, s), least};
  };
  const auto presses = [&](double t) { return curvatureScalar(height, path.degree, t - path.start) < 0.0; };
  return march(at, presses, from, until, touchTolerance(path.position(from - path.start), radius));
}

// The path in the frame of the shape.
Segment seenFrom(const Shape& shape, const Segment& path)
{
  const Matrix3d R_SW = shape.R_BS.transpose();
  Segment seen;
  seen.start = path.start;
  seen.end = path.end;
  seen.degree = path.degree;
  seen.c[0] = R_SW * (path.c[0] - shape.p_BS);
  for (int k = 1; k <= path.degree; ++k) seen.c[k] = R_SW * path.c[k];
  const Vector3d middle = R_SW * (0.5 * (path.a_low + path.a_high));
  const Vector3d spread = R_SW.cwiseAbs() * (0.5 * (path.a_high - path.a_low));
  seen.a_low = middle - spread;
  seen.a_high = middle + spread;
  return seen;
}

// Whether one coordinate y + u s + (at least a_low, at most a_high) s^2 / 2 stays outside of [-limit, limit] up to s = T.
bool staysOutside(double y, double u, double a_low, double a_high, double limit, double T)
{
  const double side = y < 0.0 ? -1.0 : 1.0;
  const double gap = side * y - limit;
  return gap > 0.0 && !(safeStep(gap, side * u, side > 0.0 ? a_low : -a_high) <= T);
}

bool passesBy(const Segment& seen, double radius, const Shape& shape, double from, double until)
{
  const double s = from - seen.start;
  const Vector3d y = seen.position(s);
  const Vector3d u = seen.velocity(s);
  for (int i = 0; i < 3; ++i)
    if (staysOutside(y[i], u[i], seen.a_low[i], seen.a_high[i], shape.half_size[i] + radius, until - from)) return true;
  return false;
}

Detection meetShape(const Segment& path, double radius, const Shape& shape, double from, double until)
{
  const Segment seen = seenFrom(shape, path);
  if (passesBy(seen, radius, shape, from, until)) return {};
  const auto at = [&](double t) {
    const double s = t - seen.start;
    const Proximity near = proximityHere(shape, seen.position(s));
    return Look{near.distance - radius, near.normal.dot(seen.velocity(s)),
                leastAlong(near.normal, seen.a_low, seen.a_high)};
  };
  const auto presses = [&](double t) {
    const double s = t - seen.start;
    const Proximity near = proximityHere(shape, seen.position(s));
    const Vector3d u = seen.velocity(s);
    const double u1 = u.dot(near.t1);
    const double u2 = u.dot(near.normal.cross(near.t1));
    return near.normal.dot(seen.acceleration(s)) + near.k1 * u1 * u1 + near.k2 * u2 * u2 < 0.0;
  };
  return march(at, presses, from, until, touchTolerance(path.position(from - path.start), radius));
}
}  // namespace

Shape placed(Shape shape, const Pose& X_WB)
{
  const Matrix3d R_WB = X_WB.q.toRotationMatrix();
  shape.p_BS = R_WB * shape.p_BS + X_WB.p;
  shape.R_BS = R_WB * shape.R_BS;
  return shape;
}

Detection firstContact(const Segment& path, double radius, const Shape& placed, double from, double until)
{
  count(meeting(placed.kind));
  until = std::min(until, path.end);
  if (from > until) return {};
  return placed.kind == ShapeKind::HalfSpace ? meetPlane(path, radius, placed, from, until)
                                             : meetShape(path, radius, placed, from, until);
}
}  // namespace ping_pong
