// Which boxes overlap: a uniform grid, made for many small balls of about one size. Each box is in the cell of its
// lower corner and no longer than a cell, so that it overlaps boxes of that cell and its neighbours only. The few that
// are longer are in no cell, and look at all cells in their way.
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
  template <class Action>
  void eachPair(std::size_t begin, std::size_t end, const Action& action) const;
  /// Calls action(index) for each that overlaps this box.
  template <class Action>
  void eachOverlapping(const CoarseBox& box, const Action& action) const;

  /// Until the next build() this box is there, too, under an index of the caller's. The boxes of the last build() say
  /// where cells are, so that looking for it does not mean looking at all that were added.
  void add(std::uint32_t index, const CoarseBox& box);
  /// Calls action(index) for all added boxes in the cells of this box: all that overlap it, some that do not, some
  /// twice.
  template <class Action>
  void eachAdded(const CoarseBox& box, const Action& action) const;

private:
  static constexpr std::uint32_t kNoEntry = ~0u;
  static constexpr std::uint32_t kNoCell = ~0u;
  static constexpr double kManyCells = 64.0;  ///< an added box over more cells than this is in none
  struct Entry
  {
    CoarseBox box;
    std::uint32_t index;
  };
  struct Added
  {
    std::uint32_t index, next;  // of the box; of the next entry of the same cell
  };
  struct Range
  {
    std::array<int, 3> low, high;
    double cells() const;
  };
  struct Sums;

  void layOut(const std::vector<CoarseBox>& boxes, Workers& workers);
  void fill(const std::vector<CoarseBox>& boxes, Workers& workers);
  std::uint32_t cellOf(const CoarseBox& box) const;
  int cellAt(double x, int axis) const;
  Range cellsOf(const CoarseBox& box, double before = 0.0) const;
  std::size_t cell(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(count_[0]) +
           static_cast<std::size_t>(x);
  }
  template <class Action>
  void eachOfRow(int x0, int x1, int y, int z, const CoarseBox& box, const Action& action) const;
  template <class Action>
  void eachAhead(std::size_t p, std::size_t c, const Action& action) const;
  template <class Action>
  void eachInCells(const CoarseBox& box, const Action& action) const;

  std::array<double, 3> origin_{};
  double cells_per_metre_ = 1.0;
  float longest_ = 0.0f;  ///< edge of a box in a cell [m]
  std::array<int, 3> count_{1, 1, 1};
  std::size_t large_ = 0;                   ///< boxes in no cell: the last of entries_
  std::vector<std::uint32_t> start_;        ///< of each cell in entries_
  std::vector<std::uint32_t> cell_;         ///< of each box
  std::vector<Entry> entries_;              ///< by cell
  std::vector<std::uint32_t> added_start_;  ///< of each cell: its last entry
  std::vector<Added> added_;
  std::vector<std::uint32_t> added_large_;
};

template <class Action>
void BroadPhase::eachOfRow(int x0, int x1, int y, int z, const CoarseBox& box, const Action& action) const
{
  const std::size_t end = start_[cell(x1, y, z) + 1];
  for (std::size_t q = start_[cell(x0, y, z)]; q < end; ++q)
    if (entries_[q].box.overlaps(box)) action(entries_[q].index);
}

// Those after box p in its own cell c and in the 13 neighbours with a greater number.
template <class Action>
void BroadPhase::eachAhead(std::size_t p, std::size_t c, const Action& action) const
{
  const CoarseBox& box = entries_[p].box;
  const int x = static_cast<int>(c % static_cast<std::size_t>(count_[0]));
  const int yz = static_cast<int>(c / static_cast<std::size_t>(count_[0]));
  const int y = yz % count_[1], z = yz / count_[1];
  const int x0 = std::max(x - 1, 0), x1 = std::min(x + 1, count_[0] - 1);
  const std::size_t end = start_[cell(x1, y, z) + 1];
  for (std::size_t q = p + 1; q < end; ++q)
    if (entries_[q].box.overlaps(box)) action(entries_[q].index);
  if (y + 1 < count_[1]) eachOfRow(x0, x1, y + 1, z, box, action);
  if (z + 1 == count_[2]) return;
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, count_[1] - 1); ++row)
    eachOfRow(x0, x1, row, z + 1, box, action);
}

// Boxes in cells that overlap this one.
template <class Action>
void BroadPhase::eachInCells(const CoarseBox& box, const Action& action) const
{
  const Range r = cellsOf(box, 1.000001 * longest_);  // they begin no earlier than their length before it
  for (int z = r.low[2]; z <= r.high[2]; ++z)
    for (int y = r.low[1]; y <= r.high[1]; ++y) eachOfRow(r.low[0], r.high[0], y, z, box, action);
}

template <class Action>
void BroadPhase::eachPair(std::size_t begin, std::size_t end, const Action& action) const
{
  const std::size_t in_cells = entries_.size() - large_;
  for (std::size_t p = begin; p < end; ++p)
  {
    const Entry& entry = entries_[p];
    const auto pairUp = [&](std::uint32_t other) { action(entry.index, other); };
    if (p < in_cells)
    {
      eachAhead(p, cell_[entry.index], pairUp);
      continue;
    }
    eachInCells(entry.box, pairUp);
    for (std::size_t q = p + 1; q < entries_.size(); ++q)
      if (entries_[q].box.overlaps(entry.box)) pairUp(entries_[q].index);
  }
}

template <class Action>
void BroadPhase::eachOverlapping(const CoarseBox& box, const Action& action) const
{
  if (box.empty()) return;
  eachInCells(box, action);
  for (std::size_t q = entries_.size() - large_; q < entries_.size(); ++q)
    if (entries_[q].box.overlaps(box)) action(entries_[q].index);
}

template <class Action>
void BroadPhase::eachAdded(const CoarseBox& box, const Action& action) const
{
  for (const std::uint32_t index : added_large_) action(index);
  if (added_.empty()) return;
  const Range r = cellsOf(box);
  for (int z = r.low[2]; z <= r.high[2]; ++z)
    for (int y = r.low[1]; y <= r.high[1]; ++y)
      for (int x = r.low[0]; x <= r.high[0]; ++x)
        for (std::uint32_t e = added_start_[cell(x, y, z)]; e != kNoEntry; e = added_[e].next) action(added_[e].index);
}
}  // namespace ping_pong
