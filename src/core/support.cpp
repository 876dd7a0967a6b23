#include "ping_pong_sim/support.h"

#include <Eigen/LU>

namespace ping_pong
{
namespace
{
// Loads and accelerations below this fraction of the free acceleration are rounding.
constexpr double kRounding = 1e-12;

// free + sum of loads along the chosen normals such that n_i.a = b_i for each; false if the normals are dependent or a
// surface would have to pull.
template <int N>
bool solveActive(const Vector3d& free, AccelerationBounds& bounds, const std::array<std::size_t, 3>& active,
                 Vector3d& a)
{
  Eigen::Matrix<double, 3, N> n;
  Eigen::Matrix<double, N, 1> missing;
  for (int i = 0; i < N; ++i)
  {
    n.col(i) = bounds.list[active[i]].n;
    missing[i] = bounds.list[active[i]].b - n.col(i).dot(free);
  }
  const Eigen::Matrix<double, N, N> gram = n.transpose() * n;
  if (gram.determinant() < kRounding) return false;
  const Eigen::Matrix<double, N, 1> load = gram.inverse() * missing;
  if ((load.array() < 0.0).any()) return false;
  bounds.load.fill(0.0);
  for (int i = 0; i < N; ++i) bounds.load[active[i]] = load[i];
  a = free + n * load;
  return true;
}

bool respectsAll(const Vector3d& a, const AccelerationBounds& bounds, double slack)
{
  for (std::size_t i = 0; i < bounds.count; ++i)
    if (bounds.list[i].n.dot(a) < bounds.list[i].b - slack) return false;
  return true;
}

bool solveActive(const Vector3d& free, AccelerationBounds& bounds, const std::array<std::size_t, 3>& active, int count,
                 Vector3d& a)
{
  switch (count)
  {
    case 0:
      bounds.load.fill(0.0);
      a = free;
      return true;
    case 1:
      return solveActive<1>(free, bounds, active, a);
    case 2:
      return solveActive<2>(free, bounds, active, a);
    default:
      return solveActive<3>(free, bounds, active, a);
  }
}

// Next increasing choice of `count` out of n; false after the last.
bool nextChoice(std::array<std::size_t, 3>& active, int count, std::size_t n)
{
  for (int i = count - 1; i >= 0; --i)
    if (active[i] + 1 + (count - 1 - i) < n)
    {
      ++active[i];
      for (int k = i + 1; k < count; ++k) active[k] = active[k - 1] + 1;
      return true;
    }
  return false;
}

double scaleOf(const Vector3d& free, const AccelerationBounds& bounds)
{
  double scale = free.norm();
  for (std::size_t i = 0; i < bounds.count; ++i) scale = std::max(scale, std::abs(bounds.list[i].b));
  return scale;
}
}  // namespace

namespace
{
Supports::Surface surface(std::size_t body, std::size_t shape)
{
  return {static_cast<std::uint16_t>(body), static_cast<std::uint16_t>(shape)};
}
}  // namespace

bool Supports::List::has(std::size_t body, std::size_t shape) const
{
  for (std::size_t i = 0; i < count; ++i)
    if (surfaces[i].body == body && surfaces[i].shape == shape) return true;
  return false;
}

void Supports::add(std::size_t body, std::size_t shape)
{
  List& list = list_.make();
  if (list.count < kMax && !list.has(body, shape)) list.surfaces[list.count++] = surface(body, shape);
}

void Supports::remove(std::size_t index)
{
  List& list = *list_;
  for (std::size_t i = index; i + 1 < list.count; ++i) list.surfaces[i] = list.surfaces[i + 1];
  if (--list.count == 0) list_.reset();
}

void Supports::pass(std::size_t body, std::size_t shape, double until)
{
  List& list = list_.make();
  list.passing = surface(body, shape);
  list.passing_until = until;
}

void Supports::passNone()
{
  if (list_) list_->passing_until = -kNever;
}

double Supports::passesUntil(std::size_t body, std::size_t shape, double from) const
{
  if (!list_ || list_->passing.body != body || list_->passing.shape != shape) return from;
  return std::max(from, list_->passing_until);
}

Vector3d constrainedAcceleration(const Vector3d& free, AccelerationBounds& bounds)
{
  const double slack = kRounding * scaleOf(free, bounds);
  Vector3d a = free;
  for (int count = 0; count <= 3 && static_cast<std::size_t>(count) <= bounds.count; ++count)
  {
    std::array<std::size_t, 3> active{0, 1, 2};
    do
    {
      if (!solveActive(free, bounds, active, count, a) || !respectsAll(a, bounds, slack)) continue;
      for (std::size_t i = 0; i < bounds.count; ++i)
        bounds.loaded[i] = count > 0 && bounds.list[i].n.dot(a) <= bounds.list[i].b + slack;
      return a;
    } while (nextChoice(active, count, bounds.count));
  }
  bounds.load.fill(0.0);
  bounds.loaded.fill(true);  // wedged: no acceleration respects all; stay with the least bad one
  return Vector3d::Zero();
}
}  // namespace ping_pong
