#include "geometry/separating_axis.h"

#include <array>
#include <cmath>
#include <limits>

#include "geometry/gjk.h"
#include "geometry/tangential.h"

namespace ping_pong
{
namespace
{
// Round shapes nearer than this by their axes are looked at closely.
constexpr double kNear = 1e-3;  // [m]
constexpr int kMaxClimb = 60;   // 20 halvings of the step lead from 0.1 rad to the least one; the rest are steps uphill
constexpr double kLeastClimb = 1e-7;  // [rad]

// A shape with its axes in the world.
struct Placed
{
  const Shape& shape;
  Matrix3d R;
  Vector3d p;

  Placed(const Shape& s, const Pose& X) : shape(s), R(X.q.toRotationMatrix() * s.R_BS), p(X.q * s.p_BS + X.p) {}

  Vector3d furthest(const Vector3d& n) const
  {
    const Vector3d m = R.transpose() * n;
    const Vector3d& h = shape.half_size;
    Vector3d q = Vector3d::Zero();
    switch (shape.kind)
    {
      case ShapeKind::Box:
        for (int i = 0; i < 3; ++i) q[i] = m[i] < 0.0 ? -h[i] : h[i];
        break;
      case ShapeKind::Cylinder:
      {
        const double radial = std::hypot(m.x(), m.y());
        if (radial > 0.0) q.head<2>() = h.x() / radial * m.head<2>();
        q.z() = m.z() < 0.0 ? -h.z() : h.z();
        break;
      }
      case ShapeKind::Sphere:
        q = h.x() * m.normalized();
        break;
      case ShapeKind::HalfSpace:
        break;
    }
    return R * q + p;
  }
};

class AxisSearch
{
public:
  AxisSearch(const Placed& a, const Placed& b) : a_(a), b_(b) { best_.gap = -std::numeric_limits<double>::infinity(); }

  void tryAxis(const Vector3d& axis)
  {
    const double length = axis.norm();
    if (length < 1e-9) return;  // parallel edges: the face normals cover them
    tryDirection(axis / length);
    tryDirection(-axis / length);
  }
  void tryDirection(const Vector3d& n)
  {
    const Vector3d point = a_.furthest(-n);
    const double gap = n.dot(point - b_.furthest(n));
    if (gap > best_.gap) best_ = {gap, n, point};
  }
  Separation best() const { return best_; }

  // The gap over all directions has its greatest value along the line of nearest points; the difference of the two support
  // points is its gradient. Steepest ascent with a step that grows and shrinks.
  void climb()
  {
    double step = 0.1;
    for (int i = 0; i < kMaxClimb && step > kLeastClimb; ++i)
    {
      const Vector3d n = best_.n_W;
      const Vector3d d = best_.p_WC - b_.furthest(n);
      const Vector3d uphill = tangential(d, n);
      const double slope = uphill.norm();
      if (!(slope > 0.0)) return;
      const double before = best_.gap;
      tryDirection((n + step / slope * uphill).normalized());
      step *= best_.gap > before ? 1.5 : 0.5;
    }
  }

private:
  const Placed& a_;
  const Placed& b_;
  Separation best_;
};

int axesOf(const Shape& shape)
{
  return shape.kind == ShapeKind::Box ? 3 : shape.kind == ShapeKind::Cylinder ? 1 : 0;
}

// The axis of a cylinder is its z, the axes of a box are x, y and z.
Vector3d axis(const Placed& placed, int i)
{
  return placed.R.col(placed.shape.kind == ShapeKind::Cylinder ? 2 : i);
}

}  // namespace

Separation separation(const Shape& shape_a, const Pose& X_WA, const Shape& shape_b, const Pose& X_WB)
{
  const Placed a(shape_a, X_WA);
  const Placed b(shape_b, X_WB);
  AxisSearch search(a, b);
  if (shape_b.kind == ShapeKind::HalfSpace)
  {
    search.tryDirection(b.R.col(2));
    return search.best();
  }
  for (int i = 0; i < axesOf(shape_a); ++i) search.tryAxis(axis(a, i));
  for (int i = 0; i < axesOf(shape_b); ++i) search.tryAxis(axis(b, i));
  for (int i = 0; i < axesOf(shape_a); ++i)
    for (int k = 0; k < axesOf(shape_b); ++k) search.tryAxis(axis(a, i).cross(axis(b, k)));
  const bool boxes = shape_a.kind == ShapeKind::Box && shape_b.kind == ShapeKind::Box;
  if (boxes || search.best().gap > kNear) return search.best();
  const auto support = [&](const Vector3d& n) -> Vector3d { return a.furthest(n) - b.furthest(-n); };
  AxisSearch along_nearest(a, b);
  along_nearest.tryAxis(shortestDifference(support, a.p - b.p));
  along_nearest.climb();
  if (along_nearest.best().gap > search.best().gap) return along_nearest.best();
  return search.best();
}
}  // namespace ping_pong
