// Which boxes overlap: a uniform grid, made for many small balls of about one size. A box is in the cell of its lower corner,
// and no longer than so many cells along each axis: where others that overlap it begin is known to the cell. The few that
// are longer, and those that come later, are in lists of all cells that they reach.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "box.h"
#include "workers.h"

namespace ping_pong
{
/// Places are rounded to small parts of a cell, so that boxes that nearly overlap may be taken to do so, and beyond the grid
/// those that do not; whoever asks looks at them anyway. What it answers is the same for any number of workers.
class BroadPhase
{
public:
  void reserve(std::size_t boxes);

  /// Sorts `count` boxes into cells: `box(i)` is that of i, by any worker, and for some asked twice.
  template <class BoxOf>
  void build(std::size_t count, const BoxOf& box, Workers& workers);

  /// The same in three steps: cells for boxes like these; put() for each index, by any worker; sort().
  template <class BoxOf>
  void layOut(std::size_t count, const BoxOf& box);
  template <class AnyBox>
  void put(std::uint32_t index, const AnyBox& box);
  void sort();

  /// Those that are not empty, in the order of their cells.
  std::size_t boxes() const { return boxes_; }
  /// Calls action(a, b) with the indices of every two boxes that overlap, in no order; of all pairs that share of which
  /// [begin, end) is of boxes(). Shares that cover boxes() once give each pair once.
  template <class Action>
  void eachPair(std::size_t begin, std::size_t end, const Action& action) const;

  /// Until the boxes are sorted again this one is there, too, under an index of the caller's.
  template <class AnyBox>
  void add(std::uint32_t index, const AnyBox& box)
  {
    if (!box.empty()) addToLists(extentOf(box), index | kAdded);
  }
  /// Calls action(index, added) for each that overlaps this box, once; `added` is true for those that were.
  template <class AnyBox, class Action>
  void eachOverlapping(const AnyBox& box, const Action& action) const;

private:
  static constexpr std::uint32_t kNoLink = ~0u;
  static constexpr std::uint32_t kAdded = 1u << 31;  ///< of an index
  static constexpr int kUnitBits = 6;
  static constexpr int kUnits = 1 << kUnitBits;  ///< of length in a cell
  static constexpr int kBits = 20;               ///< of a place in units, along each axis

  /// A place in units from the origin of the grid, x, y and z in one number, below a bit that is zero each. What is
  /// beyond the grid is on its border.
  using Corner = std::uint64_t;
  static constexpr int kField = kBits + 1;
  static constexpr Corner kFieldMask = (Corner{1} << kBits) - 1;
  static constexpr Corner kBorrows =
      Corner{1} << kBits | Corner{1} << (kField + kBits) | Corner{1} << (2 * kField + kBits);
  static constexpr Corner kMoved = Corner{1} << 63;  ///< of a low corner, while entries are sorted
  static constexpr Corner kEmpty = ~kMoved;          ///< instead of a low corner
  static int field(Corner corner, int axis) { return static_cast<int>(corner >> (kField * axis) & kFieldMask); }

  /// Of a box, its high corner with all of kBorrows.
  struct Extent
  {
    Corner low, high;
    /// All three subtractions at once: none borrows if no coordinate is less than the other.
    bool overlaps(const Extent& other) const
    {
      return ((high - other.low) & (other.high - low) & kBorrows) == kBorrows;
    }
  };
  struct Listed
  {
    Extent extent;
    std::uint32_t index;
    std::uint32_t next;  ///< entry in links_ of the same cell
  };
  using Cell = std::array<int, 3>;  ///< x, y, z
  /// What cells are made for: some of the boxes stand for all.
  struct Sums
  {
    static constexpr std::size_t kMost = 256;  ///< boxes that are looked at, at most
    double n = 0.0;
    std::array<double, 3> edge{}, edge_squared{}, low{}, low_squared{};
    std::array<double, 3> least{1e30, 1e30, 1e30}, greatest{-1e30, -1e30, -1e30};

    template <class AnyBox>
    void add(const AnyBox& box);
  };

  void layOut(const Sums& sums, std::size_t count);
  template <class AnyBox>
  Corner cornerAt(const AnyBox& p) const;  ///< rounded down, high corners too: what overlaps still does
  template <class AnyBox>
  Extent extentOf(const AnyBox& box) const;
  bool fits(const Extent& extent) const;  ///< in a cell
  std::size_t rangeOf(const Extent& extent) const;
  static Cell cellAt(Corner corner)
  {
    return {field(corner, 0) >> kUnitBits, field(corner, 1) >> kUnitBits, field(corner, 2) >> kUnitBits};
  }
  /// Where the first one that overlaps this box may begin.
  Cell firstBefore(Corner low) const
  {
    const auto before = [&](int axis) { return std::max(field(low, axis) - field(longest_, axis), 0) >> kUnitBits; };
    return {before(0), before(1), before(2)};
  }
  std::size_t cell(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(count_[0]) +
           static_cast<std::size_t>(x);
  }
  std::size_t cellOf(Corner low) const
  {
    const Cell c = cellAt(low);
    return cell(c[0], c[1], c[2]);
  }
  template <class Action>
  static void eachRow(const Cell& first, const Cell& last, const Action& action);  ///< action(y, z)
  template <class Action>
  static void eachCell(const Cell& first, const Cell& last, const Action& action);  ///< action(x, y, z)
  template <class Action>
  void eachFrom(std::size_t begin, std::size_t end, const Extent& extent, const Action& action) const;
  template <class Action>
  void eachInRows(const Cell& first, const Cell& last, const Extent& extent, const Action& action) const;
  template <class Action>
  void eachInCells(const Extent& extent, const Action& action) const;
  void addToLists(const Extent& extent, std::uint32_t index);
  template <class Action>
  void eachListed(const Extent& extent, const Action& action) const;

  std::array<double, 3> origin_{};
  std::array<double, 3> units_per_metre_{1.0, 1.0, 1.0};
  std::array<double, 3> last_{};                ///< greatest coordinates, in units
  Corner longest_ = 0;                          ///< edges of a box in a cell, in units
  std::array<int, 3> count_{1, 1, 1};           ///< of cells
  std::size_t boxes_ = 0;                       ///< that are not empty
  std::size_t in_cells_ = 0;                    ///< of these; those that are too long come after them
  std::vector<std::uint32_t> start_;            ///< of each cell in entries_
  std::vector<Extent> entries_;                 ///< by index, once they are sorted by cell
  std::vector<std::uint32_t> index_;            ///< of each entry
  std::vector<std::uint32_t> last_link_;        ///< of each cell
  std::vector<Listed> links_;
  std::vector<Listed> everywhere_;              ///< those in no list of a cell
};

template <class AnyBox>
void BroadPhase::Sums::add(const AnyBox& box)
{
  n += 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto i = static_cast<std::size_t>(axis);
    const double x = box.low[axis], e = box.high[axis] - box.low[axis];
    edge[i] += e;
    edge_squared[i] += e * e;
    low[i] += x;
    low_squared[i] += x * x;
    least[i] = std::min(least[i], x);
    greatest[i] = std::max(greatest[i], x);
  }
}

template <class BoxOf>
void BroadPhase::layOut(std::size_t count, const BoxOf& box)
{
  Sums sums;
  const std::size_t stride = 1 + count / Sums::kMost;
  for (std::size_t i = 0; i < count; i += stride)
  {
    const auto its = box(i);
    if (!its.empty()) sums.add(its);
  }
  layOut(sums, count);
}

template <class BoxOf>
void BroadPhase::build(std::size_t count, const BoxOf& box, Workers& workers)
{
  constexpr std::size_t kGrain = 512;  // boxes that a worker takes at a time
  layOut(count, box);
  workers.each(count, kGrain,
               [&](std::size_t begin, std::size_t end, std::size_t)
               {
                 for (std::size_t i = begin; i < end; ++i) put(static_cast<std::uint32_t>(i), box(i));
               });
  sort();
}

template <class AnyBox>
BroadPhase::Corner BroadPhase::cornerAt(const AnyBox& p) const
{
  Corner corner = 0;
  for (int i = 0; i < 3; ++i)
  {
    const auto axis = static_cast<std::size_t>(i);
    const double units = (p[i] - origin_[axis]) * units_per_metre_[axis];
    corner |= static_cast<Corner>(static_cast<std::int32_t>(std::max(std::min(units, last_[axis]), 0.0))) << (kField * i);
  }
  return corner;
}

template <class AnyBox>
BroadPhase::Extent BroadPhase::extentOf(const AnyBox& box) const
{
  return {cornerAt(box.low), cornerAt(box.high) | kBorrows};
}

template <class AnyBox>
void BroadPhase::put(std::uint32_t index, const AnyBox& box)
{
  entries_[index] = box.empty() ? Extent{kEmpty, 0} : extentOf(box);
}

template <class Action>
void BroadPhase::eachFrom(std::size_t begin, std::size_t end, const Extent& extent, const Action& action) const
{
  for (std::size_t q = begin; q < end; ++q)
    if (entries_[q].overlaps(extent)) action(index_[q]);
}

template <class Action>
void BroadPhase::eachRow(const Cell& first, const Cell& last, const Action& action)
{
  for (int z = first[2]; z <= last[2]; ++z)
    for (int y = first[1]; y <= last[1]; ++y) action(y, z);
}

template <class Action>
void BroadPhase::eachCell(const Cell& first, const Cell& last, const Action& action)
{
  eachRow(first, last,
          [&](int y, int z)
          {
            for (int x = first[0]; x <= last[0]; ++x) action(x, y, z);
          });
}

template <class Action>
void BroadPhase::eachInRows(const Cell& first, const Cell& last, const Extent& extent, const Action& action) const
{
  eachRow(first, last,
          [&](int y, int z) { eachFrom(start_[cell(first[0], y, z)], start_[cell(last[0], y, z) + 1], extent, action); });
}

template <class Action>
void BroadPhase::eachInCells(const Extent& extent, const Action& action) const
{
  const Cell first = firstBefore(extent.low), last = cellAt(extent.high);
  eachRow(first, last, [&](int y, int z) { __builtin_prefetch(entries_.data() + start_[cell(first[0], y, z)]); });
  eachInRows(first, last, extent, action);
}

template <class Action>
void BroadPhase::eachPair(std::size_t begin, std::size_t end, const Action& action) const
{
  for (std::size_t p = begin; p < std::min(end, in_cells_); ++p)
  {
    const Extent extent = entries_[p];
    const auto pairUp = [&, index = index_[p]](std::uint32_t other) { action(index, other); };
    // Of two boxes the one whose cell comes first looks for the other: further on in its row, in rows behind, in layers above.
    const Cell own = cellAt(extent.low), first = firstBefore(extent.low), last = cellAt(extent.high);
    eachFrom(p + 1, start_[cell(last[0], own[1], own[2]) + 1], extent, pairUp);
    eachInRows({first[0], own[1] + 1, own[2]}, {last[0], last[1], own[2]}, extent, pairUp);
    eachInRows({first[0], first[1], own[2] + 1}, last, extent, pairUp);
  }
  for (std::size_t p = std::max(begin, in_cells_); p < end; ++p)
  {
    const Extent extent = entries_[p];
    const auto pairUp = [&, index = index_[p]](std::uint32_t other) { action(index, other); };
    eachInCells(extent, pairUp);
    eachFrom(p + 1, boxes_, extent, pairUp);
  }
}

template <class Action>
void BroadPhase::eachListed(const Extent& extent, const Action& action) const
{
  const auto tell = [&](const Listed& box) { action(box.index & ~kAdded, (box.index & kAdded) != 0); };
  for (const Listed& box : everywhere_)
    if (box.extent.overlaps(extent)) tell(box);
  if (links_.empty()) return;
  const Cell first = cellAt(extent.low), last = cellAt(extent.high);
  const auto tellOf = [&](int x, int y, int z)
  {
    for (std::uint32_t link = last_link_[cell(x, y, z)]; link != kNoLink; link = links_[link].next)
    {
      const Listed& box = links_[link];
      if (!box.extent.overlaps(extent)) continue;
      const Cell its = cellAt(box.extent.low);  // of all cells that both are in, the first one tells
      if (x == std::max(first[0], its[0]) && y == std::max(first[1], its[1]) && z == std::max(first[2], its[2])) tell(box);
    }
  };
  eachCell(first, last, tellOf);
}

template <class AnyBox, class Action>
void BroadPhase::eachOverlapping(const AnyBox& box, const Action& action) const
{
  if (box.empty()) return;
  const Extent extent = extentOf(box);
  eachInCells(extent, [&](std::uint32_t index) { action(index, false); });
  eachListed(extent, action);
}
}  // namespace ping_pong
