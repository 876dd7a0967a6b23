// Collision shapes: box, cylinder, sphere, fixed in a body frame; and the half-space of the floor.
#pragma once

#include "ping_pong_sim/types.h"

namespace ping_pong
{
enum class ShapeKind
{
  Box,
  Cylinder,  ///< axis along its own z
  Sphere,
  HalfSpace  ///< everything below its own z = 0
};

struct Shape
{
  ShapeKind kind = ShapeKind::Box;
  Vector3d half_size = Vector3d::Zero();  ///< Box: half edges; Cylinder: (R, R, half length); Sphere: (R, R, R) [m]
  Matrix3d R_BS = Matrix3d::Identity();   ///< shape axes in the body frame B
  Vector3d p_BS = Vector3d::Zero();       ///< shape origin in B [m]
  MaterialId material = 0;
};

/// Nearest surface point of a shape as seen from a point Q, and how the surface of equal distance through Q bends.
/// All vectors in the frame in which the shape and Q were given.
struct Proximity
{
  double distance = 0.0;                ///< from the surface to Q, negative inside [m]
  Vector3d normal = Vector3d::UnitZ();  ///< unit, from the surface to Q: the gradient of distance
  Vector3d t1 = Vector3d::UnitX();      ///< first principal direction of the equal-distance surface
  double k1 = 0.0;                      ///< its curvature [1/m]; second derivative of distance along t1
  double k2 = 0.0;                      ///< curvature along normal x t1 [1/m]

  bool flat() const { return k1 == 0.0 && k2 == 0.0; }
};

/// Closest point on a face, edge, corner, rim or curved side. Q inside: the face of least depth.
/// @param p_BQ  the point, in the body frame [m]
Proximity proximity(const Shape& shape, const Vector3d& p_BQ);

/// Radius of the sphere about the shape's own origin that contains it [m]; infinite for a half-space.
double boundingRadius(const Shape& shape);

/// Support function: the largest n.x over the points x of the shape, in the body frame [m].
double supportDistance(const Shape& shape, const Vector3d& n_B);
}  // namespace ping_pong
