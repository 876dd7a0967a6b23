// Features of a shape: face, edge, corner, round side, rim. On each of them distance, normal and curvature are smooth.
#pragma once

#include "ping_pong_sim/shape.h"

namespace ping_pong
{
/// The part of the surface that holds the closest point. By axis of the shape's own frame: +1 or -1 where the closest point
/// is on that border of the shape, 0 where it is between both. A cylinder's x stands for its round side.
struct Feature
{
  int x = 0, y = 0, z = 0;

  bool operator==(const Feature& other) const { return x == other.x && y == other.y && z == other.z; }
  bool operator!=(const Feature& other) const { return !(*this == other); }
};

/// A feature counts up to this much beyond its border: its normal is then off by 1e-11 m / r [m].
inline constexpr double kBorder = 1e-11;

/// Where the closest point to Q lies. Q inside the shape: on the face of least depth.
/// @param p_BQ  in the frame in which the shape is given [m]
Feature featureAt(const Shape& shape, const Vector3d& p_BQ);

/// As proximity(), as if the feature had no border: a face is a plane, an edge a line.
Proximity proximity(const Shape& shape, const Feature& feature, const Vector3d& p_BQ);

/// The closest point to Q lies on this feature, or at most kBorder beyond its border.
bool onFeature(const Shape& shape, const Feature& feature, const Vector3d& p_BQ);

/// Plane: a face of a box, an end of a cylinder, a half-space.
bool flat(const Shape& shape, const Feature& feature);
}  // namespace ping_pong
