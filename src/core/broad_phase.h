// Which boxes overlap: a uniform grid, made for many small balls of about one size.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

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
  bool contains(const Box& other) const
  {
    return (low.array() <= other.low.array()).all() && (other.high.array() <= high.array()).all();
  }
  void add(const Box& other)
  {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
};

class BroadPhase
{
public:
  struct Pair
  {
    std::uint32_t a, b;  ///< a < b
  };

  void reserve(std::size_t boxes);
  /// Every pair of boxes that overlap, once, sorted.
  const std::vector<Pair>& findPairs(const std::vector<Box>& boxes);
  /// Indices of those boxes of the last findPairs() that overlap this one, in no order; may tell one twice.
  void findOverlapping(const Box& box, const std::vector<Box>& boxes, std::vector<std::uint32_t>& found) const;

  /// Until the next findPairs() this box is there, too, under an index of the caller's. The boxes of the last findPairs() say
  /// where cells are, so that looking for it does not mean looking at all that were added.
  void add(std::uint32_t index, const Box& box);
  /// Indices of added boxes in the cells of this box: all that overlap it, some that do not, some twice.
  void findAdded(const Box& box, std::vector<std::uint32_t>& found) const;

private:
  static constexpr std::uint32_t kNoEntry = ~0u;
  struct Added
  {
    std::uint32_t index, next;  // of the box; of the next entry of the same cell
  };
  struct Range
  {
    std::array<int, 3> low, high;
    double cells() const;
  };

  void layOut(const std::vector<Box>& boxes);
  void fill(const std::vector<Box>& boxes);
  template <class Action>
  void eachCell(const Range& range, const Action& action) const;
  Range cellsOf(const Box& box) const;
  int cell(int x, int y, int z) const { return (z * count_[1] + y) * count_[0] + x; }

  Vector3d origin_ = Vector3d::Zero();
  double cells_per_metre_ = 1.0;
  std::array<int, 3> count_{1, 1, 1};
  std::vector<std::uint32_t> start_;  // of each cell in entries_
  std::vector<std::uint32_t> entries_;
  std::vector<std::uint32_t> large_;  // boxes over many cells, looked at by everyone
  std::vector<Range> ranges_;
  std::vector<Pair> pairs_;
  std::vector<std::uint32_t> added_start_;  // of each cell: its last entry
  std::vector<Added> added_;
  std::vector<std::uint32_t> added_large_;
};
}  // namespace ping_pong
