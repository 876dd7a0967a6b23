// Which boxes overlap: a uniform grid, made for many small balls of about one size. Its cells are as high and as wide as
// the boxes, which falling makes high. Each box is in the cell of its lower corner and no longer than a cell, so that it
// overlaps boxes of that cell and its neighbours only. The few that are longer are in no cell, and look at all cells in
// their way.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "box.h"
#include "workers.h"

namespace ping_pong
{
class BroadPhase
{
public:
  void reserve(std::size_t boxes);

  /// Sorts these boxes into cells; boxes() are those that are not empty, in the order of their cells.
  void build(const std::vector<CoarseBox>& boxes, Workers& workers);
  std::size_t boxes() const { return entries_.size(); }
  /// Calls action(a, b) with the indices of every two boxes that overlap, in no order; of all pairs that share of which
  /// [begin, end) is of boxes(). Shares that cover boxes() once give each pair once.
  /// @param boxes  those of the last build(): the grid has them rounded
  template <class Action>
  void eachPair(std::size_t begin, std::size_t end, const std::vector<CoarseBox>& boxes, const Action& action) const;
  /// Calls action(index) for each that overlaps this box.
  template <class Action>
  void eachOverlapping(const CoarseBox& box, const std::vector<CoarseBox>& boxes, const Action& action) const;

  /// Until the next build() this box is there, too, under an index of the caller's. The boxes of the last build() say
  /// where cells are, so that looking for it does not mean looking at all that were added.
  void add(std::uint32_t index, const CoarseBox& box);
  /// Calls action(index) for all added boxes in the cells of this box: all that overlap it and some that do not, each once.
  template <class Action>
  void eachAdded(const CoarseBox& box, const Action& action) const;

private:
  static constexpr std::uint32_t kNoEntry = ~0u;
  static constexpr std::uint32_t kEmpty = ~0u, kLarge = kEmpty - 1;  ///< instead of a cell, of boxes in none
  static constexpr double kManyCells = 64.0;  ///< an added box over more cells than this is in none
  static constexpr int kUnits = 64;           ///< of length in a cell
  static constexpr int kBits = 20;            ///< of a place in units, along each axis

  /// A corner in units from the origin of the grid, x, y and z in one number, below a bit that is zero each. What is
  /// beyond the grid is on its border.
  using Corner = std::uint64_t;
  static constexpr int kField = kBits + 1;
  static constexpr Corner kFieldMask = (Corner{1} << kBits) - 1;
  static constexpr Corner kBorrows =
      Corner{1} << kBits | Corner{1} << (kField + kBits) | Corner{1} << (2 * kField + kBits);
  static int field(Corner corner, int axis) { return static_cast<int>(corner >> (kField * axis) & kFieldMask); }

  struct Entry
  {
    Corner low, high;
    std::uint32_t index;
    /// All three subtractions at once: none borrows if no coordinate is less than the other.
    bool overlaps(Corner other_low, Corner other_high) const
    {
      return (((high | kBorrows) - other_low) & ((other_high | kBorrows) - low) & kBorrows) == kBorrows;
    }
  };
  struct Added
  {
    std::uint32_t index, next;  // of the box; of the next entry of the same cell
    std::array<int, 3> low;     // first cell of the box
  };
  struct Range
  {
    std::array<int, 3> low, high;
    double cells() const;
  };
  struct Sums;

  void layOut(const std::vector<CoarseBox>& boxes, Workers& workers);
  void fill(const std::vector<CoarseBox>& boxes, Workers& workers);
  bool fits(const CoarseBox& box) const;  ///< in a cell
  Corner cornerAt(const float* p) const;
  Range cellsOf(Corner low, Corner high, int cells_before) const;
  // Around the grid is a layer of empty cells.
  std::size_t cell(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z + 1) * static_cast<std::size_t>(count_[1] + 2) +
            static_cast<std::size_t>(y + 1)) *
               static_cast<std::size_t>(count_[0] + 2) +
           static_cast<std::size_t>(x + 1);
  }
  std::uint32_t cellOf(Corner low) const
  {
    return static_cast<std::uint32_t>(cell(field(low, 0) / kUnits, field(low, 1) / kUnits, field(low, 2) / kUnits));
  }
  template <class Action>
  void eachFrom(std::size_t begin, std::size_t end, Corner low, Corner high, const Action& action) const;
  template <class Action>
  void eachInCells(Corner low, Corner high, const Action& action) const;

  std::array<double, 3> origin_{};
  std::array<double, 3> units_per_metre_{1.0, 1.0, 1.0};
  std::array<float, 3> longest_{};  ///< edges of a box in a cell [m]
  std::array<int, 3> count_{1, 1, 1};
  std::array<double, 3> last_{};                ///< greatest coordinates, in units
  std::size_t large_ = 0;                       ///< boxes in no cell: the last of entries_
  std::vector<std::uint32_t> start_;            ///< of each cell in entries_
  std::vector<std::uint32_t> cell_of_;          ///< of each box
  std::vector<Entry> entries_;                  ///< by cell
  std::vector<std::uint32_t> added_start_;      ///< of each cell: its last entry
  std::vector<Added> added_;
  std::vector<std::uint32_t> added_large_;
};

template <class Action>
void BroadPhase::eachFrom(std::size_t begin, std::size_t end, Corner low, Corner high, const Action& action) const
{
  for (std::size_t q = begin; q < end; ++q)
    if (entries_[q].overlaps(low, high)) action(entries_[q].index);
}

// Boxes in cells that overlap this one: they begin no earlier than a cell before it.
template <class Action>
void BroadPhase::eachInCells(Corner low, Corner high, const Action& action) const
{
  const Range r = cellsOf(low, high, 1);
  for (int z = r.low[2]; z <= r.high[2]; ++z)
    for (int y = r.low[1]; y <= r.high[1]; ++y)
      eachFrom(start_[cell(r.low[0], y, z)], start_[cell(r.high[0], y, z) + 1], low, high, action);
}

template <class Action>
void BroadPhase::eachPair(std::size_t begin, std::size_t end, const std::vector<CoarseBox>& boxes,
                          const Action& action) const
{
  const std::size_t in_cells = entries_.size() - large_;
  const std::size_t row = cell(0, 1, 0) - cell(0, 0, 0), layer = cell(0, 0, 1) - cell(0, 0, 0);
  const std::array<std::size_t, 5> rows = {0, row, layer - row, layer, layer + row};
  for (std::size_t p = begin; p < std::min(end, in_cells); ++p)
  {
    const Entry entry = entries_[p];
    const std::size_t c = cellOf(entry.low);
    // The rest of its cell and of the next one; the rows of three cells beside, above and diagonally above.
    std::size_t q = p + 1;
    for (std::size_t k = 0;;)
    {
      for (const std::size_t stop = start_[c + rows[k] + 2]; q < stop; ++q)
        if (entries_[q].overlaps(entry.low, entry.high) && boxes[entries_[q].index].overlaps(boxes[entry.index]))
          action(entry.index, entries_[q].index);
      if (++k == rows.size()) break;
      q = start_[c + rows[k] - 1];
    }
  }
  for (std::size_t p = std::max(begin, in_cells); p < end; ++p)
  {
    const Entry large = entries_[p];
    const auto pairUp = [&](std::uint32_t other)
    {
      if (boxes[other].overlaps(boxes[large.index])) action(large.index, other);
    };
    eachInCells(large.low, large.high, pairUp);
    eachFrom(p + 1, entries_.size(), large.low, large.high, pairUp);
  }
}

template <class Action>
void BroadPhase::eachOverlapping(const CoarseBox& box, const std::vector<CoarseBox>& boxes, const Action& action) const
{
  if (box.empty()) return;
  const Corner low = cornerAt(box.low), high = cornerAt(box.high);
  const auto lookAt = [&](std::uint32_t index)
  {
    if (boxes[index].overlaps(box)) action(index);
  };
  eachInCells(low, high, lookAt);
  eachFrom(entries_.size() - large_, entries_.size(), low, high, lookAt);
}

template <class Action>
void BroadPhase::eachAdded(const CoarseBox& box, const Action& action) const
{
  for (const std::uint32_t index : added_large_) action(index);
  if (added_.empty()) return;
  const Range r = cellsOf(cornerAt(box.low), cornerAt(box.high), 0);
  for (int z = r.low[2]; z <= r.high[2]; ++z)
    for (int y = r.low[1]; y <= r.high[1]; ++y)
      for (int x = r.low[0]; x <= r.high[0]; ++x)
        for (std::uint32_t e = added_start_[cell(x, y, z)]; e != kNoEntry; e = added_[e].next)
        {
          const std::array<int, 3>& low = added_[e].low;  // of all cells that both are in, the first one tells
          if (x == std::max(r.low[0], low[0]) && y == std::max(r.low[1], low[1]) && z == std::max(r.low[2], low[2]))
            action(added_[e].index);
        }
}
}  // namespace ping_pong
