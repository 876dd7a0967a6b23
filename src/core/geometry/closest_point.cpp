#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/closest_point_here.h"
#include "ping_pong_sim/shape.h"

namespace ping_pong
{
namespace
{
// All functions below: Q and the answer in the shape's own frame.

Proximity flatFace(double distance, int axis, double side)
{
  Proximity found;
  found.distance = distance;
  found.normal = side * Vector3d::Unit(axis);
  found.t1 = Vector3d::Unit((axis + 1) % 3);
  return found;
}

Proximity insideBox(const Vector3d& half, const Vector3d& q)
{
  int axis = 0;
  const Vector3d depth = half - q.cwiseAbs();
  depth.minCoeff(&axis);
  return flatFace(-depth[axis], axis, q[axis] < 0.0 ? -1.0 : 1.0);
}

// Ericson, Real-Time Collision Detection (2005), 5.1.3: clamp Q to the box; what is left over points to Q.
Proximity toBox(const Vector3d& half, const Vector3d& q)
{
  const Vector3d over = q - q.cwiseMax(-half).cwiseMin(half);
  const int outside = (over.array() != 0.0).count();
  if (outside == 0) return insideBox(half, q);
  int axis = 0;
  if (outside == 1)
  {
    const double distance = over.cwiseAbs().maxCoeff(&axis);
    return flatFace(distance, axis, over[axis] < 0.0 ? -1.0 : 1.0);
  }
  Proximity found;
  found.distance = over.norm();
  found.normal = over / found.distance;
  found.k1 = 1.0 / found.distance;
  if (outside == 2)
  {
    over.cwiseAbs().minCoeff(&axis);  // along the edge
    found.t1 = found.normal.cross(Vector3d::Unit(axis));
  }
  else
  {
    found.t1 = found.normal.unitOrthogonal();
    found.k2 = found.k1;
  }
  return found;
}

Proximity toSphere(double radius, const Vector3d& q)
{
  Proximity found;
  const double norm = q.norm();
  found.distance = norm - radius;
  if (norm == 0.0) return found;  // any normal will do at the centre
  found.normal = q / norm;
  found.t1 = found.normal.unitOrthogonal();
  found.k1 = found.k2 = 1.0 / norm;
  return found;
}

Proximity toCylinderSide(double distance, const Vector3d& radial, double rho)
{
  Proximity found;
  found.distance = distance;
  found.normal = radial;
  found.t1 = Vector3d::UnitZ().cross(radial);
  found.k1 = rho > 0.0 ? 1.0 / rho : 0.0;
  return found;
}

// The surface at distance d from the rim is a torus: curvature 1/d in the meridian, (n.radial)/rho around the axis.
Proximity toCylinderRim(double over_radius, double over_end, double side, const Vector3d& radial, double rho)
{
  Proximity found;
  found.distance = std::sqrt(over_radius * over_radius + over_end * over_end);
  const double cos_n = over_radius / found.distance;
  const double sin_n = over_end / found.distance;
  found.normal = cos_n * radial + side * sin_n * Vector3d::UnitZ();
  found.t1 = -sin_n * radial + side * cos_n * Vector3d::UnitZ();
  found.k1 = 1.0 / found.distance;
  found.k2 = cos_n / rho;
  return found;
}

Proximity toCylinder(double radius, double half_length, const Vector3d& q)
{
  const double rho = std::sqrt(q.x() * q.x() + q.y() * q.y());
  const Vector3d radial = rho > 0.0 ? Vector3d(q.x() / rho, q.y() / rho, 0.0) : Vector3d::UnitX();
  const double side = q.z() < 0.0 ? -1.0 : 1.0;
  const double over_radius = rho - radius;
  const double over_end = std::abs(q.z()) - half_length;
  if (over_radius > 0.0 && over_end > 0.0) return toCylinderRim(over_radius, over_end, side, radial, rho);
  if (over_end >= over_radius) return flatFace(over_end, 2, side);
  return toCylinderSide(over_radius, radial, rho);
}

double supportInShapeFrame(const Shape& shape, const Vector3d& n)
{
  switch (shape.kind)
  {
    case ShapeKind::Box:
      return shape.half_size.dot(n.cwiseAbs());
    case ShapeKind::Cylinder:
      return shape.half_size.x() * std::hypot(n.x(), n.y()) + shape.half_size.z() * std::abs(n.z());
    case ShapeKind::Sphere:
      return shape.half_size.x() * n.norm();
    case ShapeKind::HalfSpace:
      break;
  }
  // Bounded in one direction only.
  return n.x() == 0.0 && n.y() == 0.0 && n.z() >= 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
}
}  // namespace

Proximity proximityHere(const Shape& shape, const Vector3d& q)
{
  switch (shape.kind)
  {
    case ShapeKind::Box:
      return toBox(shape.half_size, q);
    case ShapeKind::Cylinder:
      return toCylinder(shape.half_size.x(), shape.half_size.z(), q);
    case ShapeKind::Sphere:
      return toSphere(shape.half_size.x(), q);
    case ShapeKind::HalfSpace:
      break;
  }
  return flatFace(q.z(), 2, 1.0);
}

Proximity proximity(const Shape& shape, const Vector3d& p_BQ)
{
  if (shape.kind == ShapeKind::HalfSpace)
  {
    Proximity found;
    found.normal = shape.R_BS.col(2);
    found.t1 = shape.R_BS.col(0);
    found.distance = found.normal.dot(p_BQ - shape.p_BS);
    return found;
  }
  Proximity found = proximityHere(shape, shape.R_BS.transpose() * (p_BQ - shape.p_BS));
  found.normal = shape.R_BS * found.normal;
  found.t1 = shape.R_BS * found.t1;
  return found;
}

double boundingRadius(const Shape& shape)
{
  switch (shape.kind)
  {
    case ShapeKind::Box:
      return shape.half_size.norm();
    case ShapeKind::Cylinder:
      return std::hypot(shape.half_size.x(), shape.half_size.z());
    case ShapeKind::Sphere:
      return shape.half_size.x();
    case ShapeKind::HalfSpace:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

double supportDistance(const Shape& shape, const Vector3d& n_B)
{
  return n_B.dot(shape.p_BS) + supportInShapeFrame(shape, shape.R_BS.transpose() * n_B);
}
}  // namespace ping_pong
