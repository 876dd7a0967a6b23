#include "geometry/gjk.h"

#include <Eigen/LU>
#include <array>

namespace ping_pong
{
namespace
{
constexpr int kMaxSteps = 64;            // a bound: rounding may keep the last step from being the last
constexpr double kTouching = 1e-12;      // [m]
constexpr double kRelativeGain = 1e-12;  // an improvement below this part of the squared distance is none
constexpr double kDegenerate = 1e-24;    // determinant / product of squared edges of a simplex without extent

struct Simplex
{
  std::array<Vector3d, 4> points{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  int count = 0;
};

// Point nearest to the origin of the affine hull of N + 1 points; false if it is outside of their simplex.
template <int N>
bool nearestInside(const std::array<Vector3d, 4>& p, Vector3d& nearest)
{
  // p0 + E x with E^T (p0 + E x) = 0.
  Eigen::Matrix<double, 3, N> edges;
  for (int i = 0; i < N; ++i) edges.col(i) = p[i + 1] - p[0];
  const Eigen::Matrix<double, N, N> gram = edges.transpose() * edges;
  if (!(gram.determinant() > kDegenerate * gram.diagonal().prod())) return false;
  const Eigen::Matrix<double, N, 1> x = gram.inverse() * (-edges.transpose() * p[0]);
  if ((x.array() < 0.0).any() || x.sum() > 1.0) return false;
  nearest = p[0] + edges * x;
  return true;
}

bool nearestOn(const Simplex& simplex, unsigned choice, Vector3d& nearest)
{
  std::array<Vector3d, 4> p = simplex.points;
  int n = 0;
  for (int i = 0; i < simplex.count; ++i)
    if (choice >> i & 1u) p[n++] = simplex.points[i];
  nearest = p[0];
  if (n == 1) return true;
  if (n == 2) return nearestInside<1>(p, nearest);
  if (n == 3) return nearestInside<2>(p, nearest);
  return nearestInside<3>(p, nearest);  // of four points at most
}

// Keeps the part of the simplex that is nearest to the origin.
Vector3d reduce(Simplex& simplex)
{
  Vector3d best = Vector3d::Constant(1e300);
  unsigned best_choice = 1;
  for (unsigned choice = 1; choice < 1u << simplex.count; ++choice)
  {
    Vector3d nearest;
    if (!nearestOn(simplex, choice, nearest) || !(nearest.squaredNorm() < best.squaredNorm())) continue;
    best = nearest;
    best_choice = choice;
  }
  int kept = 0;
  for (int i = 0; i < simplex.count; ++i)
    if (best_choice >> i & 1u) simplex.points[kept++] = simplex.points[i];
  simplex.count = kept;
  return best;
}
}  // namespace

Vector3d shortestDifference(const DifferenceSupport& support, const Vector3d& start)
{
  Simplex simplex;
  Vector3d nearest = start;
  for (int step = 0; step < kMaxSteps; ++step)
  {
    const double distance2 = nearest.squaredNorm();
    if (distance2 < kTouching * kTouching) return Vector3d::Zero();
    const Vector3d point = support(-nearest);
    if (step > 0 && distance2 - nearest.dot(point) <= kRelativeGain * distance2) return nearest;
    simplex.points[simplex.count++] = point;
    const Vector3d next = reduce(simplex);
    if (step > 0 && !(next.squaredNorm() < distance2)) return nearest;  // rounding has the last word
    if (simplex.count == 4) return Vector3d::Zero();                    // the origin is inside
    nearest = next;
  }
  return nearest;
}
}  // namespace ping_pong
