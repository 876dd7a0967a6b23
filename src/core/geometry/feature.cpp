#include "geometry/feature.h"

#include <cmath>

namespace ping_pong
{
namespace
{
// All functions below: Q and the answer in the shape's own frame.

int sideOf(double y, double half)
{
  return y > half ? 1 : y < -half ? -1 : 0;
}

Feature nearestFace(const Vector3d& half, const Vector3d& q)
{
  int axis = 0;
  (half - q.cwiseAbs()).minCoeff(&axis);
  const int side = q[axis] < 0.0 ? -1 : 1;
  return {axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0};
}

Feature featureOfBox(const Vector3d& half, const Vector3d& q)
{
  const Feature found{sideOf(q.x(), half.x()), sideOf(q.y(), half.y()), sideOf(q.z(), half.z())};
  return found == Feature() ? nearestFace(half, q) : found;
}

Feature featureOfCylinder(const Vector3d& half, const Vector3d& q)
{
  const double over_side = std::hypot(q.x(), q.y()) - half.x();
  const double over_end = std::abs(q.z()) - half.z();
  const int side = q.z() < 0.0 ? -1 : 1;
  if (over_side > 0.0 && over_end > 0.0) return {1, 0, side};
  return over_end >= over_side ? Feature{0, 0, side} : Feature{1, 0, 0};
}

Proximity toBorders(const Vector3d& half, const Feature& feature, const Vector3d& q)
{
  const Vector3d side(feature.x, feature.y, feature.z);
  const int count = (side.array() != 0.0).count();
  const Vector3d over = side.cwiseAbs().cwiseProduct(q - side.cwiseProduct(half));
  Proximity found;
  if (count == 1)
  {
    found.distance = over.dot(side);
    found.normal = side;
    found.t1 = Vector3d(side.y(), side.z(), side.x()).cwiseAbs();
    return found;
  }
  found.distance = over.norm();
  found.normal = over / found.distance;
  found.k1 = 1.0 / found.distance;
  if (count == 2)
    found.t1 = found.normal.cross(Vector3d(side.x() == 0.0, side.y() == 0.0, side.z() == 0.0));
  else
  {
    found.t1 = found.normal.unitOrthogonal();
    found.k2 = found.k1;
  }
  return found;
}

Proximity toRound(const Vector3d& half, const Feature& feature, const Vector3d& q)
{
  const double rho = std::hypot(q.x(), q.y());
  const Vector3d radial = rho > 0.0 ? Vector3d(q.x() / rho, q.y() / rho, 0.0) : Vector3d::UnitX();
  const double over_side = rho - half.x();
  Proximity found;
  if (feature.z == 0)
  {
    found.distance = over_side;
    found.normal = radial;
    found.t1 = Vector3d::UnitZ().cross(radial);
    found.k1 = rho > 0.0 ? 1.0 / rho : 0.0;
    return found;
  }
  const double over_end = feature.z * q.z() - half.z();
  found.distance = std::hypot(over_side, over_end);
  const double cosine = over_side / found.distance, sine = over_end / found.distance;
  found.normal = cosine * radial + feature.z * sine * Vector3d::UnitZ();
  found.t1 = -sine * radial + feature.z * cosine * Vector3d::UnitZ();
  found.k1 = 1.0 / found.distance;
  found.k2 = cosine / rho;  // torus: (n.radial) / rho around the axis
  return found;
}

Proximity proximityInShape(const Shape& shape, const Feature& feature, const Vector3d& q)
{
  switch (shape.kind)
  {
    case ShapeKind::Box:
      return toBorders(shape.half_size, feature, q);
    case ShapeKind::Cylinder:
      return feature.x == 0 ? toBorders(shape.half_size, feature, q) : toRound(shape.half_size, feature, q);
    case ShapeKind::Sphere:
    case ShapeKind::HalfSpace:
      break;
  }
  return {};
}

bool within(int side, double y, double half)
{
  return side == 0 ? std::abs(y) <= half + kBorder : side * y >= half - kBorder;
}

Vector3d inShape(const Shape& shape, const Vector3d& p_BQ)
{
  return shape.R_BS.transpose() * (p_BQ - shape.p_BS);
}

bool hasFeatures(const Shape& shape)
{
  return shape.kind == ShapeKind::Box || shape.kind == ShapeKind::Cylinder;
}
}  // namespace

Feature featureAt(const Shape& shape, const Vector3d& p_BQ)
{
  if (!hasFeatures(shape)) return {};
  const Vector3d q = inShape(shape, p_BQ);
  return shape.kind == ShapeKind::Box ? featureOfBox(shape.half_size, q) : featureOfCylinder(shape.half_size, q);
}

Proximity proximity(const Shape& shape, const Feature& feature, const Vector3d& p_BQ)
{
  if (!hasFeatures(shape)) return proximity(shape, p_BQ);
  Proximity found = proximityInShape(shape, feature, inShape(shape, p_BQ));
  found.normal = shape.R_BS * found.normal;
  found.t1 = shape.R_BS * found.t1;
  return found;
}

bool onFeature(const Shape& shape, const Feature& feature, const Vector3d& p_BQ)
{
  if (!hasFeatures(shape)) return true;
  const Vector3d q = inShape(shape, p_BQ);
  const Vector3d& half = shape.half_size;
  if (shape.kind == ShapeKind::Cylinder)
    return within(feature.x, std::hypot(q.x(), q.y()), half.x()) && within(feature.z, q.z(), half.z());
  const int count = (feature.x != 0) + (feature.y != 0) + (feature.z != 0);
  const auto side = [&](int border, double y, double its_half)
  { return count == 1 && border != 0 ? border * y > 0.0 : within(border, y, its_half); };
  return side(feature.x, q.x(), half.x()) && side(feature.y, q.y(), half.y()) && side(feature.z, q.z(), half.z());
}

bool flat(const Shape& shape, const Feature& feature)
{
  switch (shape.kind)
  {
    case ShapeKind::Box:
      return (feature.x != 0) + (feature.y != 0) + (feature.z != 0) == 1;
    case ShapeKind::Cylinder:
      return feature.x == 0;
    case ShapeKind::Sphere:
      return false;
    case ShapeKind::HalfSpace:
      break;
  }
  return true;
}
}  // namespace ping_pong
