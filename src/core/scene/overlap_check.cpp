#include "scene/overlap_check.h"

#include <cmath>

namespace ping_pong
{
namespace
{
/// Not a number, from sizes near the end of the number range, counts as an overlap.
bool isOverlap(double depth)
{
  return !(depth <= kOverlapTolerance);
}

bool isDeeper(double depth, const std::optional<Overlap>& deepest)
{
  return isOverlap(depth) && (!deepest || depth > deepest->depth);
}
}  // namespace

std::size_t OverlapFinder::CubeHash::operator()(const Cube& cube) const
{
  std::size_t hash = 0;
  for (const double index : cube) hash = hash * 1000003u + std::hash<double>()(index);
  return hash;
}

OverlapFinder::OverlapFinder(const std::vector<Body>& bodies, double largest_radius)
    : bodies_(bodies), cube_size_(2.0 * largest_radius)
{
}

OverlapFinder::Cube OverlapFinder::cubeOf(const Vector3d& p_WB) const
{
  // Indices stay floating point: far away they lose digits, where an integer would overflow.
  return {std::floor(p_WB.x() / cube_size_), std::floor(p_WB.y() / cube_size_), std::floor(p_WB.z() / cube_size_)};
}

void OverlapFinder::addBall(const Vector3d& p_WB, double radius)
{
  cubes_[cubeOf(p_WB)].push_back(balls_.size());
  balls_.push_back({p_WB, radius});
}

template <class Action>
bool OverlapFinder::anyNear(const Vector3d& p_WB, const Action& action) const
{
  const Cube centre = cubeOf(p_WB);
  for (int neighbour = 0; neighbour < 27; ++neighbour)
  {
    const Cube cube = {centre[0] + neighbour % 3 - 1, centre[1] + neighbour / 3 % 3 - 1, centre[2] + neighbour / 9 - 1};
    const auto found = cubes_.find(cube);
    if (found == cubes_.end()) continue;
    for (const std::size_t i : found->second)
      if (action(i)) return true;
  }
  return false;
}

void OverlapFinder::findBodies(const Vector3d& p_WB, double radius, std::optional<Overlap>& deepest) const
{
  for (const Body& body : bodies_)
  {
    const Vector3d p_BQ = body.pose.toB(p_WB);
    for (const Shape& shape : body.shapes)
    {
      const double depth = radius - proximity(shape, p_BQ).distance;
      if (isDeeper(depth, deepest)) deepest = Overlap{body.name, depth};
    }
  }
}

void OverlapFinder::findBalls(const Vector3d& p_WB, double radius, std::optional<Overlap>& deepest) const
{
  anyNear(p_WB,
          [&](std::size_t i)
          {
            const double depth = radius + balls_[i].radius - (p_WB - balls_[i].p_WB).norm();
            if (isDeeper(depth, deepest)) deepest = Overlap{"ball_" + std::to_string(i), depth};
            return false;
          });
}

std::optional<Overlap> OverlapFinder::find(const Vector3d& p_WB, double radius) const
{
  std::optional<Overlap> deepest;
  findBodies(p_WB, radius, deepest);
  findBalls(p_WB, radius, deepest);
  return deepest;
}

bool OverlapFinder::free(const Vector3d& p_WB, double radius) const
{
  const bool hit = anyNear(
      p_WB, [&](std::size_t i) { return isOverlap(radius + balls_[i].radius - (p_WB - balls_[i].p_WB).norm()); });
  if (hit) return false;
  std::optional<Overlap> with_body;
  findBodies(p_WB, radius, with_body);
  return !with_body;
}
}  // namespace ping_pong
