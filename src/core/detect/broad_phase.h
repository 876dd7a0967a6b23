// Which boxes overlap: a uniform grid, made for many small balls of about one size. A box is in the cell of its lower corner and
// no longer than a cell, so that it overlaps only what is in the 27 cells around; of those, only rows that it reaches are
// searched, from the slice of a cell in which a box may begin to the one in which it ends. The few that are longer, and those
// that come later, are in lists of all cells that they reach.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/simd4.h"
#include "base/thread_pool.h"
#include "geometry/aabb.h"

namespace ping_pong
{
/// Points are rounded to small parts of a cell, so that boxes that nearly overlap may be taken to do so, and beyond the grid
/// those that do not; the caller looks at them anyway. What it answers is the same for any number of workers.
class BroadPhase
{
public:
  static constexpr std::uint32_t kAdded = 1u << 31;  ///< of the index of a box that was added
  using Pair = std::array<std::uint32_t, 2>;         ///< indices of boxes
  struct Addition;

  void reserve(std::size_t boxes, std::size_t workers);

  /// Sorts `count` boxes into cells: `box(i)` is that of i, by any worker, and for some asked twice.
  template <class BoxOf>
  void build(std::size_t count, const BoxOf& box, Workers& workers);

  /// The same in three steps: cells for boxes like these; visit(place, index, worker) for all, which calls put() with this
  /// place; sort(). If there are several workers, those who had neighbouring cells last time have neighbouring places now: as a
  /// rule it is the same worker who puts them, sorts them, and finds their pairs, and they stay in the cache of its core. Then
  /// ahead(index) is called some time before a visit, too: what it fetches has come by then.
  template <class BoxOf>
  void layOut(std::size_t count, const BoxOf& box);
  template <class Ahead, class Visit>
  void putAll(Workers& workers, const Ahead& ahead, const Visit& visit);
  template <class AnyBox>
  void put(std::size_t place, const AnyBox& box);
  void sort(Workers& workers);

  /// Those that are not empty, in the order of their cells.
  std::size_t boxes() const { return boxes_; }
  /// Calls ahead(a, b) with every two boxes that overlap, in no order, and some pairs later action(pairs, how_many), for some
  /// at a time: what ahead() fetches has come by then. Of all pairs that part of which [begin, end) is of boxes(): parts that
  /// cover boxes() once give each pair once.
  template <class Ahead, class Action>
  void eachPairs(std::size_t begin, std::size_t end, const Ahead& ahead, const Action& action) const;
  /// Calls action(a, b) with every two of all.
  template <class Action>
  void eachPair(const Action& action) const;

  /// What add() needs to know of boxes, by parts of the grid.
  using Additions = std::vector<std::vector<Addition>>;
  /// By any worker, for a list of its own.
  template <class AnyBox>
  void deferInsertion(std::uint32_t index, const AnyBox& box, Additions& list) const;
  /// Those of lists with this member are there, too, until the boxes are sorted again; the lists are empty then.
  template <class List>
  void add(std::vector<List>& lists, Additions List::*member, Workers& workers);
  /// Appends the index of each that overlaps this box, once, with kAdded for those that were.
  template <class AnyBox>
  void listOverlapping(const AnyBox& box, std::vector<std::uint32_t>& list) const;

private:
  static constexpr std::uint32_t kNoLink = ~0u;
  static constexpr std::uint32_t kLinkBits = 26;  ///< of an entry in the list of a part; the part is above them
  static constexpr int kPlaceBits = 29;           ///< of the three places in a packed point,
  static constexpr int kLeastUnitBits = 2;        ///< of which along each axis at least so many are of units in a cell
  static constexpr std::size_t kFirst = 2 * kLanes;  ///< entries of a range that are compared in any case
  static constexpr int kSliceBits = 1;
  static constexpr std::size_t kSlices =
      1u << kSliceBits;                       ///< of a cell along x: where a row is searched, ends are cut off
  static constexpr std::size_t kBlock = 256;  ///< places that a worker takes at a time
  static constexpr std::size_t kAhead = 8;    ///< places, at most kFirst

  /// A place in units from the origin of the grid: x, y and z in one number, each below a bit that is zero. What is beyond
  /// the grid is on its border.
  using PackedPoint = std::uint32_t;
  using PackedPoints = PackedPoint __attribute__((vector_size(16)));

  /// Of a grid along one axis, and of its places in a packed point. Its first and its last cell are empty.
  struct Axis
  {
    double origin = 0.0, units_per_metre = 1.0;
    double first = 0.0, last = 0.0;  ///< least and greatest place [units]
    int cells = 3;
    int shift = 0;              ///< of a place in a packed point
    int unit_bits = 0;          ///< its lowest ones: units in a cell
    PackedPoint cell_bits = 0;  ///< the others, where they are in a packed point
    PackedPoint mask = 0;       ///< of a place, once it is shifted down

    int cellOf(PackedPoint point) const { return static_cast<int>((point >> shift & mask) >> unit_bits); }
  };
  /// Of a box: less its low corner, so that sums are differences, and its high corner with all of borrows_.
  struct PackedAabb
  {
    PackedPoint minus_low, high;

    PackedPoint low() const { return 0u - minus_low; }
  };
  static_assert(sizeof(PackedAabb) == 8, "two of them in a vector");
  /// A box that many are compared with.
  struct Query
  {
    PackedAabb packed;
    PackedPoints both;  ///< what to add to two boxes

    explicit Query(const PackedAabb& its) : packed(its), both{its.high, its.minus_low, its.high, its.minus_low} {}
  };
  /// Some entries.
  struct Range
  {
    std::uint32_t begin, end;
  };
  struct Listed
  {
    PackedAabb packed;
    std::uint32_t index;
    std::uint32_t next;  ///< of the same cell
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

  /// Ranges of some places are between these.
  struct Block
  {
    std::uint32_t least = 0, greatest = ~0u;
  };

  void layOut(const Sums& sums, std::size_t count);
  void layOutPackedPoints(const std::array<int, 3>& cell_bits);
  void takePlaces(std::size_t count);
  template <class AnyBox>
  PackedPoint packPoint(const AnyBox& p) const;  ///< rounded down, high corners too: what overlaps still does
  template <class AnyBox>
  PackedAabb pack(const AnyBox& box) const;
  bool fits(const PackedAabb& packed) const;  ///< in a cell
  std::size_t cell(int x, int y, int z) const
  {
    return static_cast<std::size_t>(z) * layer_ + static_cast<std::size_t>(y) * row_ + static_cast<std::size_t>(x);
  }
  Cell cellAt(PackedPoint point) const
  {
    return {axes_[0].cellOf(point), axes_[1].cellOf(point), axes_[2].cellOf(point)};
  }
  std::size_t sliceAlong(PackedPoint point) const { return point >> slice_shift_ & slice_mask_; }  ///< of its row
  std::size_t sliceOf(PackedPoint point) const
  {
    return kSlices * cell(0, axes_[1].cellOf(point), axes_[2].cellOf(point)) + sliceAlong(point);
  }
  /// Of a box that fits, how far it reaches beyond the slice of its lower corner: slices, and cells.
  struct Reach
  {
    std::size_t x;
    bool y, z;
  };
  Reach reachOf(const PackedAabb& packed) const
  {
    const PackedPoint low = packed.low(), differ = low ^ packed.high;
    return {sliceAlong(packed.high) - sliceAlong(low), (differ & axes_[1].cell_bits) != 0,
            (differ & axes_[2].cell_bits) != 0};
  }
  /// All three subtractions at once: none borrows if no coordinate is less than the other.
  bool overlap(const PackedAabb& a, const PackedAabb& b) const
  {
    return ((a.high + b.minus_low) & (b.high + a.minus_low) & borrows_) == borrows_;
  }
  LaneMask overlaps(const PackedAabb* entries, const Query& query) const;  ///< four of them
  /// Of one row, those that a box may overlap whose lower corner is in this slice and which reaches so far; or none.
  Range inRow(std::size_t slice, std::size_t reach, bool any) const
  {
    const std::uint32_t begin = start_[slice - kSlices], end = start_[slice + reach + 1];
    return {begin, any ? end : begin};
  }
  template <class Action>
  void eachCell(const Cell& first, const Cell& last, const Action& action) const;  ///< action(x, y, z)

  // Calling take(index) for each that overlaps:
  template <class Take>
  void takeFrom(std::size_t begin, std::size_t end, const Query& query, const Take& take) const;
  template <std::size_t count, class Take>
  void takeFromRanges(const std::array<Range, count>& ranges, const Query& query, const Take& take) const;
  template <class Take>
  void takeAround(const Query& query, const Take& take) const;
  template <class Take>
  void takeFromCells(const PackedAabb& packed, const Take& take) const;
  template <class Take>
  void takeFromLists(const PackedAabb& packed, const Take& take) const;
  /// Then it is in no list of a cell, but in the care of the first part.
  static bool overManyCells(const Cell& first, const Cell& last)
  {
    constexpr double kManyCells = 64.0;
    return (last[0] - first[0] + 1.0) * (last[1] - first[1] + 1.0) * (last[2] - first[2] + 1.0) > kManyCells;
  }
  /// Calls action(part) for each part of the grid that has cells of this box, if it is in their lists.
  template <class Action>
  void eachPartOf(const PackedAabb& packed, const Action& action) const;
  void addToLists(std::size_t part, const PackedAabb& packed, std::uint32_t index);
  void noteBlock(std::size_t block);
  std::uint32_t middleOf(std::size_t block) const;
  std::size_t endOf(std::size_t block) const { return std::min((block + 1) * kBlock, count_); }
  std::size_t parts() const { return first_.size() - 1; }
  void cutIntoParts(std::size_t count);
  void sortPart(std::size_t part);
  std::size_t firstCell(std::size_t part) const { return part < parts() ? first_[part] / kSlices : cells_; }

  std::array<Axis, 3> axes_;
  PackedPoint borrows_ = 0;                       ///< the bits between places
  PackedPoint longest_ = 0;                       ///< edges of a cell
  std::size_t row_ = 3, layer_ = 9, cells_ = 27;  ///< cells
  std::size_t slices_ = kSlices * 27;             ///< of all cells
  int slice_shift_ = 0;                           ///< of a slice along x in a packed point
  std::size_t slice_mask_ = 0;
  std::size_t count_ = 0;             ///< of all boxes
  std::size_t boxes_ = 0;             ///< that are not empty
  std::size_t in_cells_ = 0;          ///< of these; those that are too long come after them
  std::vector<PackedAabb> placed_;    ///< by place
  std::vector<std::uint32_t> range_;  ///< by place: its slice, slices_ if it is in none, or one more if it is empty
  std::vector<Block> blocks_;         ///< of places
  std::vector<std::uint32_t> start_;  ///< of each range in entries_
  std::vector<PackedAabb> entries_;   ///< by range; some more after them, to be read but not told
  std::vector<std::uint32_t> index_;  ///< of each entry; some more after them
  std::vector<std::uint32_t> at_;     ///< index, by place; some more
  bool shared_ = false;               ///< places are those of the entries before; else those of the indices
  std::vector<std::uint32_t> first_{0, 2};  ///< range of each part, and what comes after the last one
  std::vector<std::uint32_t> last_link_;    ///< of each cell: an entry in the list of its part
  std::vector<std::vector<Listed>> links_;  ///< by part
  std::vector<Listed> everywhere_;          ///< those in no list of a cell
  bool any_link_ = false;
};
}  // namespace ping_pong

#include "detect/broad_phase_build.h"
#include "detect/broad_phase_search.h"
