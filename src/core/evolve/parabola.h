// The path of a ball in free flight under a constant acceleration.
#pragma once

#include "evolve/segment.h"

namespace ping_pong
{
/// p + v s + half_a s^2 with s = t - start.
struct Parabola
{
  double start = 0.0;
  Vector3d p, v, half_a;
};

inline bool isParabola(const Segment& path)
{
  return path.degree == 2;
}

/// Of a path of degree 2.
inline Parabola asParabola(const Segment& path)
{
  return {path.start, path.c[0], path.c[1], path.c[2]};
}

/// The same without a copy.
struct ParabolaView
{
  double start;
  const Vector3d &p, &v, &half_a;

  ParabolaView(double its_start, const Vector3d& its_p, const Vector3d& its_v, const Vector3d& its_half_a)
      : start(its_start), p(its_p), v(its_v), half_a(its_half_a)
  {
  }
  ParabolaView(const Parabola& path) : start(path.start), p(path.p), v(path.v), half_a(path.half_a) {}
  /// Of a path of degree 2.
  explicit ParabolaView(const Segment& path) : start(path.start), p(path.c[0]), v(path.c[1]), half_a(path.c[2]) {}
};
}  // namespace ping_pong
