#include "ping_pong_sim/separation.h"

#include <array>
#include <cmath>
#include <limits>

namespace ping_pong
{
namespace
{
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
        q = h.x() * m;
        break;
      case ShapeKind::HalfSpace:
        break;
    }
    return R * q + p;
  }

  // Point of the shape nearest to Q: exact for an axis of separation when Q is a point of the other shape.
  Vector3d nearest(const Vector3d& Q) const
  {
    const Vector3d q = R.transpose() * (Q - p);
    Shape at_origin = shape;
    at_origin.R_BS.setIdentity();
    at_origin.p_BS.setZero();
    const Proximity near = proximity(at_origin, q);
    return near.distance > 0.0 ? Vector3d(R * (q - near.distance * near.normal) + p) : Q;
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

// Alternating projections walk towards the nearest points of two convex shapes.
void tryNearestPoints(const Placed& a, const Placed& b, AxisSearch& search)
{
  Vector3d on_a = a.p;
  for (int i = 0; i < 8; ++i)
  {
    const Vector3d on_b = b.nearest(on_a);
    on_a = a.nearest(on_b);
    search.tryAxis(on_a - on_b);
  }
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
  tryNearestPoints(a, b, search);
  return search.best();
}
}  // namespace ping_pong
