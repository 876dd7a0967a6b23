// Boxes along the axes of W.
#pragma once

#include <algorithm>
#include <cmath>

#include "ping_pong_sim/types.h"

namespace ping_pong
{
/// Axis-aligned box in W [m].
struct Box
{
  Vector3d low = Vector3d::Constant(1e300);
  Vector3d high = Vector3d::Constant(-1e300);

  /// As it is made: it overlaps nothing.
  bool empty() const { return !(low.x() <= high.x()); }
  bool overlaps(const Box& other) const
  {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
  void add(const Box& other)
  {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
};

/// The same in half of the memory, and never smaller than the box that it is made of [m].
struct CoarseBox
{
  float low[3] = {1e30f, 1e30f, 1e30f};
  float high[3] = {-1e30f, -1e30f, -1e30f};

  CoarseBox() = default;
  /// Of a box that is not empty.
  explicit CoarseBox(const Box& box)
  {
    constexpr float kRounding = 2e-7f;  // more than that of the number and of the sum, 2^-24 each
    for (int i = 0; i < 3; ++i)
    {
      const auto l = static_cast<float>(box.low[i]), h = static_cast<float>(box.high[i]);
      low[i] = l - kRounding * std::abs(l);
      high[i] = h + kRounding * std::abs(h);
    }
  }

  bool empty() const { return !(low[0] <= high[0]); }
  bool overlaps(const CoarseBox& other) const
  {
    bool all = true;  // without branches: no comparison is likelier than another
    for (int i = 0; i < 3; ++i) all &= (low[i] <= other.high[i]) & (other.low[i] <= high[i]);
    return all;
  }
  void add(const CoarseBox& other)
  {
    for (int i = 0; i < 3; ++i)
    {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }
};
}  // namespace ping_pong
