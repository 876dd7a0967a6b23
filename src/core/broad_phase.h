// Which boxes overlap: a uniform grid, made for many small balls of about one size. A box is in the cell of its lower corner and
// no longer than a cell, so that it overlaps only what is in the 27 cells around; of those, only rows that it reaches are
// searched, from the slice of a cell in which a box may begin to the one in which it ends. The few that are longer, and those
// that come later, are in lists of all cells that they reach.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "box.h"
#include "lanes.h"
#include "workers.h"

namespace ping_pong
{
/// Corners are rounded to small parts of a cell, so that boxes that nearly overlap may be taken to do so, and beyond the grid
/// those that do not; whoever asks looks at them anyway. What it answers is the same for any number of workers.
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
  /// at a time: what ahead() fetches has come by then. Of all pairs that share of which [begin, end) is of boxes(): shares that
  /// cover boxes() once give each pair once.
  template <class Ahead, class Action>
  void eachPairs(std::size_t begin, std::size_t end, const Ahead& ahead, const Action& action) const;
  /// Calls action(a, b) with every two of all.
  template <class Action>
  void eachPair(const Action& action) const
  {
    eachPairs(0, boxes_, [](std::uint32_t, std::uint32_t) {},
              [&action](const Pair* pairs, std::size_t count)
              {
                for (std::size_t p = 0; p < count; ++p) action(pairs[p][0], pairs[p][1]);
              });
  }

  /// What add() needs to know of boxes, by parts of the grid.
  using Additions = std::vector<std::vector<Addition>>;
  /// By any worker, for a list of its own.
  template <class AnyBox>
  void announce(std::uint32_t index, const AnyBox& box, Additions& list) const;
  /// Those of lists with this member are there, too, until the boxes are sorted again; the lists are empty then.
  template <class List>
  void add(std::vector<List>& lists, Additions List::* member, Workers& workers);
  /// Appends the index of each that overlaps this box, once, with kAdded for those that were.
  template <class AnyBox>
  void listOverlapping(const AnyBox& box, std::vector<std::uint32_t>& list) const;

private:
  static constexpr std::uint32_t kNoLink = ~0u;
  static constexpr std::uint32_t kLinkBits = 26;  ///< of an entry in the list of a part; the part is above them
  static constexpr int kPlaceBits = 29;      ///< of the three places in a corner,
  static constexpr int kLeastUnitBits = 2;   ///< of which along each axis at least so many are of units in a cell
  static constexpr std::size_t kFirst = 2 * kLanes;  ///< entries of a range that are compared in any case
  static constexpr int kSliceBits = 1;
  static constexpr std::size_t kSlices = 1u << kSliceBits;  ///< of a cell along x: where a row is searched, ends are cut off
  static constexpr std::size_t kBlock = 256;                ///< places that a worker takes at a time
  static constexpr std::size_t kAhead = 8;                  ///< places, at most kFirst

  /// A place in units from the origin of the grid: x, y and z in one number, each below a bit that is zero. What is beyond
  /// the grid is on its border.
  using Corner = std::uint32_t;
  using Corners = Corner __attribute__((vector_size(16)));

  /// Of a grid along one axis, and of its places in a corner. Its first and its last cell are empty.
  struct Axis
  {
    double origin = 0.0, units_per_metre = 1.0;
    double first = 0.0, last = 0.0;  ///< least and greatest place [units]
    int cells = 3;
    int shift = 0;                   ///< of a place in a corner
    int unit_bits = 0;               ///< its lowest ones: units in a cell
    Corner cell_bits = 0;            ///< the others, where they are in a corner
    Corner mask = 0;                 ///< of a place, once it is shifted down

    int cellOf(Corner corner) const { return static_cast<int>((corner >> shift & mask) >> unit_bits); }
  };
  /// Of a box: less its low corner, so that sums are differences, and its high corner with all of borrows_.
  struct Extent
  {
    Corner minus_low, high;

    Corner low() const { return 0u - minus_low; }
  };
  static_assert(sizeof(Extent) == 8, "two of them in a vector");
  /// An extent that many are compared with.
  struct Question
  {
    Extent extent;
    Corners both;  ///< what to add to two extents

    explicit Question(const Extent& its) : extent(its), both{its.high, its.minus_low, its.high, its.minus_low} {}
  };
  /// Some entries.
  struct Range
  {
    std::uint32_t begin, end;
  };
  struct Listed
  {
    Extent extent;
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
  void layOutCorners(const std::array<int, 3>& cell_bits);
  void takePlaces(std::size_t count);
  template <class AnyBox>
  Corner cornerAt(const AnyBox& p) const;  ///< rounded down, high corners too: what overlaps still does
  template <class AnyBox>
  Extent extentOf(const AnyBox& box) const;
  bool fits(const Extent& extent) const;  ///< in a cell
  std::size_t cell(int x, int y, int z) const
  {
    return static_cast<std::size_t>(z) * layer_ + static_cast<std::size_t>(y) * row_ + static_cast<std::size_t>(x);
  }
  Cell cellAt(Corner corner) const { return {axes_[0].cellOf(corner), axes_[1].cellOf(corner), axes_[2].cellOf(corner)}; }
  std::size_t sliceAlong(Corner corner) const { return corner >> slice_shift_ & slice_mask_; }  ///< of its row
  std::size_t sliceOf(Corner corner) const
  {
    return kSlices * cell(0, axes_[1].cellOf(corner), axes_[2].cellOf(corner)) + sliceAlong(corner);
  }
  /// Of a box that fits, how far it reaches beyond the slice of its lower corner: slices, and cells.
  struct Reach
  {
    std::size_t x;
    bool y, z;
  };
  Reach reachOf(const Extent& extent) const
  {
    const Corner low = extent.low(), differ = low ^ extent.high;
    return {sliceAlong(extent.high) - sliceAlong(low), (differ & axes_[1].cell_bits) != 0, (differ & axes_[2].cell_bits) != 0};
  }
  /// All three subtractions at once: none borrows if no coordinate is less than the other.
  bool overlap(const Extent& a, const Extent& b) const
  {
    return ((a.high + b.minus_low) & (b.high + a.minus_low) & borrows_) == borrows_;
  }
  LaneMask overlaps(const Extent* entries, const Question& question) const;  ///< four of them
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
  void takeFrom(std::size_t begin, std::size_t end, const Question& question, const Take& take) const;
  template <std::size_t count, class Take>
  void takeFromRanges(const std::array<Range, count>& ranges, const Question& question, const Take& take) const;
  template <class Take>
  void takeAround(const Question& question, const Take& take) const;
  template <class Take>
  void takeFromCells(const Extent& extent, const Take& take) const;
  template <class Take>
  void takeFromLists(const Extent& extent, const Take& take) const;
  /// Then it is in no list of a cell, but in the care of the first part.
  static bool overManyCells(const Cell& first, const Cell& last)
  {
    constexpr double kManyCells = 64.0;
    return (last[0] - first[0] + 1.0) * (last[1] - first[1] + 1.0) * (last[2] - first[2] + 1.0) > kManyCells;
  }
  /// Calls action(part) for each part of the grid that has cells of this box, if it is in their lists.
  template <class Action>
  void eachPartOf(const Extent& extent, const Action& action) const;
  void addToLists(std::size_t part, const Extent& extent, std::uint32_t index);
  void noteBlock(std::size_t block);
  std::uint32_t middleOf(std::size_t block) const;
  std::size_t endOf(std::size_t block) const { return std::min((block + 1) * kBlock, count_); }
  std::size_t parts() const { return first_.size() - 1; }
  void cutIntoParts(std::size_t count);
  void sortPart(std::size_t part);
  std::size_t firstCell(std::size_t part) const { return part < parts() ? first_[part] / kSlices : cells_; }

  std::array<Axis, 3> axes_;
  Corner borrows_ = 0;                          ///< the bits between places
  Corner longest_ = 0;                          ///< edges of a cell
  std::size_t row_ = 3, layer_ = 9, cells_ = 27;  ///< cells
  std::size_t slices_ = kSlices * 27;           ///< of all cells
  int slice_shift_ = 0;                         ///< of a slice along x in a corner
  std::size_t slice_mask_ = 0;
  std::size_t count_ = 0;                       ///< of all boxes
  std::size_t boxes_ = 0;                       ///< that are not empty
  std::size_t in_cells_ = 0;                    ///< of these; those that are too long come after them
  std::vector<Extent> placed_;                  ///< by place
  std::vector<std::uint32_t> range_;            ///< by place: its slice, slices_ if it is in none, or one more if it is empty
  std::vector<Block> blocks_;                   ///< of places
  std::vector<std::uint32_t> start_;            ///< of each range in entries_
  std::vector<Extent> entries_;                 ///< by range; some more after them, to be read but not told
  std::vector<std::uint32_t> index_;            ///< of each entry; some more after them
  std::vector<std::uint32_t> at_;               ///< index, by place; some more
  bool shared_ = false;                         ///< places are those of the entries before; else those of the indices
  std::vector<std::uint32_t> first_{0, 2};      ///< range of each part, and what comes after the last one
  std::vector<std::uint32_t> last_link_;        ///< of each cell: an entry in the list of its part
  std::vector<std::vector<Listed>> links_;      ///< by part
  std::vector<Listed> everywhere_;              ///< those in no list of a cell
  bool any_link_ = false;
};

struct BroadPhase::Addition
{
  Extent extent;
  std::uint32_t index;
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
  layOut(count, box);
  putAll(workers, [](std::uint32_t) {}, [&](std::size_t place, std::uint32_t index, std::size_t) { put(place, box(index)); });
  sort(workers);
}

template <class Ahead, class Visit>
void BroadPhase::putAll(Workers& workers, const Ahead& ahead, const Visit& visit)
{
  const auto putBlock = [&](std::size_t block, std::size_t worker)
  {
    for (std::size_t place = block * kBlock; place < endOf(block); ++place)
    {
      if (shared_) ahead(at_[place + kAhead]);
      visit(place, at_[place], worker);
    }
    if (workers.count() > 1) noteBlock(block);
  };
  workers.each(blocks_.size(), 1,
               [&](std::size_t begin, std::size_t end, std::size_t worker)
               {
                 for (std::size_t block = begin; block < end; ++block) putBlock(block, worker);
               });
}

template <class AnyBox>
BroadPhase::Corner BroadPhase::cornerAt(const AnyBox& p) const
{
  Corner corner = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Axis& axis = axes_[static_cast<std::size_t>(i)];
    const double units = (p[i] - axis.origin) * axis.units_per_metre;
    corner |= static_cast<Corner>(static_cast<std::int32_t>(std::max(std::min(units, axis.last), axis.first))) << axis.shift;
  }
  return corner;
}

template <class AnyBox>
[[gnu::always_inline]] inline BroadPhase::Extent BroadPhase::extentOf(const AnyBox& box) const
{
  return {0u - cornerAt(box.low), cornerAt(box.high) | borrows_};
}

inline bool BroadPhase::fits(const Extent& extent) const
{
  const Corner edges = (extent.high & ~borrows_) + extent.minus_low;  // of each axis: none borrows
  return (((longest_ | borrows_) - edges) & borrows_) == borrows_;
}

template <class AnyBox>
[[gnu::always_inline]] inline void BroadPhase::put(std::size_t place, const AnyBox& box)
{
  std::size_t range = slices_ + 1;
  if (!box.empty())
  {
    const Extent extent = placed_[place] = extentOf(box);
    range = fits(extent) ? sliceOf(extent.low()) : slices_;
  }
  range_[place] = static_cast<std::uint32_t>(range);
}

inline LaneMask BroadPhase::overlaps(const Extent* entries, const Question& question) const
{
  Corners two, others;
  std::memcpy(&two, entries, sizeof(two));
  std::memcpy(&others, entries + 2, sizeof(others));
  two += question.both;
  others += question.both;
  const Corners borrows{borrows_, borrows_, borrows_, borrows_};
  return (pick<0, 2, 4, 6>(two, others) & pick<1, 3, 5, 7>(two, others) & borrows) == borrows;
}

template <class Action>
void BroadPhase::eachCell(const Cell& first, const Cell& last, const Action& action) const
{
  for (int z = first[2]; z <= last[2]; ++z)
    for (int y = first[1]; y <= last[1]; ++y)
      for (int x = first[0]; x <= last[0]; ++x) action(x, y, z);
}

template <class Take>
inline void BroadPhase::takeFrom(std::size_t begin, std::size_t end, const Question& question, const Take& take) const
{
  for (std::size_t q = begin; q < end; q += kLanes)
  {
    unsigned found = lanesIn(overlaps(entries_.data() + q, question)) & lowestBits(std::min(end - q, kLanes));
    for (; found != 0; found &= found - 1u) take(index_[q + static_cast<std::size_t>(__builtin_ctz(found))]);
  }
}

// How many there are in a range and how many of them overlap is hard to foresee for a processor: so the first eight of every
// range are compared, whether they are there or not, and branches are taken for those that overlap and for what is left only.
template <std::size_t count, class Take>
inline void BroadPhase::takeFromRanges(const std::array<Range, count>& ranges, const Question& question, const Take& take) const
{
  static_assert(count * kFirst <= 64, "a bit for each");
  std::uint64_t found = 0;
  bool more = false;
  for (std::size_t r = 0; r < count; ++r)
  {
    const std::uint32_t size = ranges[r].end - ranges[r].begin;
    const Extent* first = entries_.data() + ranges[r].begin;
    const unsigned here = lanesIn(overlaps(first, question)) | lanesIn(overlaps(first + kLanes, question)) << kLanes;
    found |= std::uint64_t{here & lowestBits(std::min<std::size_t>(size, kFirst))} << (kFirst * r);
    more |= size > kFirst;
  }
  for (; found != 0; found &= found - 1u)
  {
    const auto bit = static_cast<std::size_t>(__builtin_ctzll(found));
    take(index_[ranges[bit / kFirst].begin + bit % kFirst]);
  }
  if (!more) return;
  for (const Range& range : ranges) takeFrom(range.begin + kFirst, range.end, question, take);
}

template <class Take>
void BroadPhase::takeAround(const Question& question, const Take& take) const
{
  const std::size_t row = kSlices * row_, layer = kSlices * layer_;
  const std::size_t slice = sliceOf(question.extent.low());
  const Reach reach = reachOf(question.extent);
  std::array<std::array<Range, 3>, 3> rows;
  for (std::size_t z = 0; z < 3; ++z)
    for (std::size_t y = 0; y < 3; ++y)
    {
      rows[z][y] = inRow(slice + z * layer + y * row - layer - row, reach.x, (z < 2 || reach.z) && (y < 2 || reach.y));
      __builtin_prefetch(entries_.data() + rows[z][y].begin);
    }
  for (const std::array<Range, 3>& its : rows) takeFromRanges(its, question, take);
}

template <class Take>
void BroadPhase::takeFromCells(const Extent& extent, const Take& take) const
{
  const Question question(extent);
  if (fits(extent)) return takeAround(question, take);
  const Cell low = cellAt(extent.low()), high = cellAt(extent.high);
  const std::size_t first = sliceAlong(extent.low()) - kSlices, last = sliceAlong(extent.high);
  for (int z = low[2] - 1; z <= high[2]; ++z)
    for (int y = low[1] - 1; y <= high[1]; ++y)
    {
      const std::size_t row = kSlices * cell(0, y, z);
      takeFrom(start_[row + first], start_[row + last + 1], question, take);
    }
}

template <class Ahead, class Action>
void BroadPhase::eachPairs(std::size_t begin, std::size_t end, const Ahead& ahead, const Action& action) const
{
  constexpr std::size_t kAtATime = 16;
  std::array<Pair, 2 * kAtATime> pairs;  // those in front wait until the others are there
  std::size_t count = 0;
  std::uint32_t own = 0;
  const std::size_t row = kSlices * row_, layer = kSlices * layer_;
  const auto take = [&](std::uint32_t other)
  {
    ahead(own, other);
    pairs[count] = {own, other};
    if (++count < pairs.size()) return;
    action(pairs.data(), kAtATime);
    std::copy(pairs.begin() + kAtATime, pairs.end(), pairs.begin());
    count = kAtATime;
  };
  for (std::size_t p = begin; p < std::min(end, in_cells_); ++p)
  {
    const Question question(entries_[p]);
    own = index_[p];
    const std::size_t slice = sliceOf(entries_[p].low()), above = slice + layer;
    const Reach reach = reachOf(entries_[p]);
    // Of two boxes the one whose cell comes first looks for the other: further on in its row, in the row behind, in the layer above.
    const Range further{static_cast<std::uint32_t>(p + 1), start_[slice + reach.x + 1]};
    takeFromRanges(std::array{further, inRow(slice + row, reach.x, reach.y), inRow(above - row, reach.x, reach.z),
                              inRow(above, reach.x, reach.z), inRow(above + row, reach.x, reach.y && reach.z)},
                   question, take);
  }
  for (std::size_t p = std::max(begin, in_cells_); p < end; ++p)
  {
    own = index_[p];
    takeFromCells(entries_[p], take);
    takeFrom(p + 1, boxes_, Question(entries_[p]), take);
  }
  action(pairs.data(), count);
}

template <class Take>
void BroadPhase::takeFromLists(const Extent& extent, const Take& take) const
{
  for (const Listed& box : everywhere_)
    if (overlap(box.extent, extent)) take(box.index);
  if (!any_link_) return;
  const Cell first = cellAt(extent.low()), last = cellAt(extent.high);
  const Listed* only = parts() == 1 ? links_.front().data() : nullptr;
  const auto takeFromList = [&](int x, int y, int z)
  {
    for (std::uint32_t link = last_link_[cell(x, y, z)]; link != kNoLink;)
    {
      const Listed& box = only ? only[link] : links_[link >> kLinkBits][link & ((1u << kLinkBits) - 1u)];
      link = box.next;
      const Cell its = cellAt(box.extent.low());  // of all cells that both are in, the first one tells
      const bool tells = (x == std::max(first[0], its[0])) & (y == std::max(first[1], its[1])) & (z == std::max(first[2], its[2]));
      if (overlap(box.extent, extent) & tells) take(box.index);
    }
  };
  eachCell(first, last, takeFromList);
}

template <class Action>
void BroadPhase::eachPartOf(const Extent& extent, const Action& action) const
{
  if (parts() == 1) return action(0);
  const Cell low = cellAt(extent.low()), high = cellAt(extent.high);
  if (overManyCells(low, high)) return action(0);
  const std::size_t first = cell(low[0], low[1], low[2]), last = cell(high[0], high[1], high[2]);
  for (std::size_t part = 0; part < parts(); ++part)
    if (first < firstCell(part + 1) && last >= firstCell(part)) action(part);
}

template <class AnyBox>
void BroadPhase::announce(std::uint32_t index, const AnyBox& box, Additions& list) const
{
  if (box.empty()) return;
  if (list.size() < parts()) list.resize(parts());
  const Addition addition{extentOf(box), index | kAdded};
  eachPartOf(addition.extent, [&](std::size_t part) { list[part].push_back(addition); });
}

// Each part of the grid is one worker's.
template <class List>
void BroadPhase::add(std::vector<List>& lists, Additions List::* member, Workers& workers)
{
  constexpr std::size_t kFew = 8;  // are not worth sharing
  std::size_t count = 0;
  for (const List& list : lists)
    for (const std::vector<Addition>& its : list.*member) count += its.size();
  if (count == 0) return;
  any_link_ = true;
  workers.each(parts(), count <= kFew ? parts() : 1,
               [&](std::size_t begin, std::size_t end, std::size_t)
               {
                 for (std::size_t part = begin; part < end; ++part)
                   for (List& list : lists)
                   {
                     if (part >= (list.*member).size()) continue;
                     for (const Addition& one : (list.*member)[part]) addToLists(part, one.extent, one.index);
                     (list.*member)[part].clear();
                   }
               });
}

template <class AnyBox>
void BroadPhase::listOverlapping(const AnyBox& box, std::vector<std::uint32_t>& list) const
{
  if (box.empty()) return;
  const Extent extent = extentOf(box);
  const auto take = [&list](std::uint32_t index) { list.push_back(index); };
  takeFromCells(extent, take);
  takeFromLists(extent, take);
}
}  // namespace ping_pong
