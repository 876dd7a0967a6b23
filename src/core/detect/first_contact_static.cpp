// First contact with a shape that does not move: the path is taken into the shape's frame once, and searched there.
#include "base/law_counter.h"
#include "detect/fall_on_plane.h"
#include "detect/plane_crossing.h"
#include "evolve/polynomial.h"
#include "geometry/closest_point_here.h"

namespace ping_pong
{
namespace
{
double mostAlong(const Vector3d& n, const Vector3d& a_low, const Vector3d& a_high)
{
  return n.cwiseProduct(a_low).cwiseMax(n.cwiseProduct(a_high)).sum();
}

// Only the height above the plane matters.
Detection meetPlane(const Segment& path, double radius, const Shape& shape, double from, double until)
{
  const Vector3d n = shape.R_BS.col(2);
  if (path.degree == 2) return fallOnPlane(path, radius, n, shape, from, until);
  Height height;
  height.degree = path.degree;
  height.c[0] = n.dot(path.c[0] - shape.p_BS) - radius;
  for (int k = 1; k <= path.degree; ++k) height.c[k] = n.dot(path.coefficient(k));
  const Vector3d a_low = path.aLow(), a_high = path.aHigh();
  height.least_bend = leastAlong(n, a_low, a_high);
  height.most_bend = mostAlong(n, a_low, a_high);
  return crossesPlane(height, path.start, from, until, touchTolerance(path.position(from - path.start), radius));
}

// The path in the frame of a shape.
struct SeenPath
{
  double start;
  int degree;
  Vector3d c[Segment::kMaxDegree + 1], a_low, a_high;

  SeenPath(const Shape& shape, const Segment& path) : start(path.start), degree(path.degree)
  {
    const Matrix3d R_SW = shape.R_BS.transpose();
    c[0] = R_SW * (path.c[0] - shape.p_BS);
    for (int k = 1; k <= degree; ++k) c[k] = R_SW * path.coefficient(k);
    const Vector3d low = path.aLow(), high = path.aHigh();
    const Vector3d middle = R_SW * (0.5 * (low + high));
    const Vector3d spread = R_SW.cwiseAbs() * (0.5 * (high - low));
    a_low = middle - spread;
    a_high = middle + spread;
  }
  Vector3d position(double s) const { return polynomial().at(s); }
  Vector3d velocity(double s) const { return polynomial().derivativeAt(s); }
  Vector3d acceleration(double s) const { return polynomial().secondDerivativeAt(s); }

private:
  Polynomial polynomial() const { return {degree, c, c + 3}; }
};

// How far beyond each pair of faces of the shape's bounding box the ball is; negative where it is between them.
Vector3d beyondFaces(const Vector3d& y, double radius, const Shape& shape)
{
  return y.cwiseAbs() - shape.half_size - Vector3d::Constant(radius);
}

// Height above the face of the bounding box on this side.
Height heightOver(const SeenPath& seen, double radius, const Shape& shape, int axis, double side)
{
  Height height;
  height.degree = seen.degree;
  height.c[0] = side * seen.c[0][axis] - shape.half_size[axis] - radius;
  for (int k = 1; k <= seen.degree; ++k) height.c[k] = side * seen.c[k][axis];
  const double low = side * seen.a_low[axis], high = side * seen.a_high[axis];
  height.least_bend = std::min(low, high);
  height.most_bend = std::max(low, high);
  return height;
}

// Over the flat of a face, where the face is what the ball meets.
bool overFace(const Vector3d& y, const Shape& shape, int axis)
{
  if (shape.kind == ShapeKind::Cylinder)
    return axis == 2 && y.x() * y.x() + y.y() * y.y() <= shape.half_size.x() * shape.half_size.x();
  for (int i = 0; i < 3; ++i)
    if (i != axis && std::abs(y[i]) > shape.half_size[i]) return false;
  return shape.kind == ShapeKind::Box;
}

// As long as the ball is beyond a face of the bounding box there is no contact. Goes from face to face, the furthest first:
// a contact on the flat of a face is found like that with a plane. Undecided: none up to that time, when the ball may be at
// an edge, a corner or a round side.
Detection meetFaces(const SeenPath& seen, double radius, const Shape& shape, double from, double until,
                    double tolerance)
{
  constexpr int kMostFaces = 8;
  constexpr double kInside = 1e-12;  // a face that the ball has come to to rounding [m]
  for (int face = 0; face < kMostFaces; ++face)
  {
    const double s = from - seen.start;
    const Vector3d y = seen.position(s);
    int axis;
    const double gap = beyondFaces(y, radius, shape).maxCoeff(&axis);
    const double side = y[axis] < 0.0 ? -1.0 : 1.0;
    if (gap < -kInside || (gap <= kInside && !overFace(y, shape, axis))) return {from, true};
    const Detection found =
        crossesPlane(heightOver(seen, radius, shape, axis, side), seen.start, from, until, tolerance);
    if (!found.found() || found.undecided) return found;
    from = found.time;
    if (overFace(seen.position(from - seen.start), shape, axis)) return found;
  }
  return {from, true};
}

Detection meetShape(const Segment& path, double radius, const Shape& shape, double from, double until)
{
  const SeenPath seen(shape, path);
  const double tolerance = touchTolerance(path.position(from - path.start), radius);
  const Detection found = meetFaces(seen, radius, shape, from, until, tolerance);
  if (!found.undecided) return found;
  from = found.time;
  const auto at = [&](double t)
  {
    const double s = t - seen.start;
    const Proximity near = proximityHere(shape, seen.position(s));
    return GapSample{near.distance - radius, near.normal.dot(seen.velocity(s)),
                     leastAlong(near.normal, seen.a_low, seen.a_high)};
  };
  const auto presses = [&](double t)
  {
    const double s = t - seen.start;
    const Proximity near = proximityHere(shape, seen.position(s));
    const Vector3d u = seen.velocity(s);
    const double u1 = u.dot(near.t1);
    const double u2 = u.dot(near.normal.cross(near.t1));
    return near.normal.dot(seen.acceleration(s)) + near.k1 * u1 * u1 + near.k2 * u2 * u2 < 0.0;
  };
  return advanceConservatively(at, presses, from, until, tolerance);
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
  count(meetingLaw(placed.kind));
  until = std::min(until, path.end);
  if (from > until) return {};
  return placed.kind == ShapeKind::HalfSpace ? meetPlane(path, radius, placed, from, until)
                                             : meetShape(path, radius, placed, from, until);
}
}  // namespace ping_pong
