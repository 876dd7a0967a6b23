#include "ping_pong_sim/room.h"

#include <cmath>

namespace ping_pong
{
namespace
{
// Exact entries, so that walls are exactly upright: the plane's z is the given direction of an axis.
Shape plane(int axis, double sign, const Vector3d& p_BS, MaterialId material)
{
  Shape shape;
  shape.kind = ShapeKind::HalfSpace;
  shape.material = material;
  shape.p_BS = p_BS;
  shape.R_BS.setZero();
  shape.R_BS((axis + 1) % 3, 0) = 1.0;
  shape.R_BS((axis + 2) % 3, 1) = sign;
  shape.R_BS(axis, 2) = sign;
  return shape;
}
}  // namespace

std::vector<Shape> roomShapes(const Vector3d& size, MaterialId material)
{
  std::vector<Shape> shapes;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0})  // the plane at the low end looks up its axis
    {
      Vector3d p_BS = Vector3d::Zero();
      p_BS[axis] = axis == 2 ? (sign > 0.0 ? 0.0 : size.z()) : -0.5 * sign * size[axis];
      shapes.push_back(plane(axis, sign, p_BS, material));
    }
  return shapes;
}

std::optional<Vector3d> roomSize(const Body& body)
{
  if (body.shapes.size() != 6) return std::nullopt;
  Vector3d size;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Shape &low = body.shapes[2 * static_cast<std::size_t>(axis)],
                &high = body.shapes[2 * static_cast<std::size_t>(axis) + 1];
    if (low.kind != ShapeKind::HalfSpace || high.kind != ShapeKind::HalfSpace) return std::nullopt;
    size[axis] = high.p_BS[axis] - low.p_BS[axis];
  }
  return size;
}
}  // namespace ping_pong
