// Templates of BroadPhase: who overlaps whom.
#pragma once

#include "detect/broad_phase.h"

namespace ping_pong
{
template <class Action>
void BroadPhase::eachCell(const Cell& first, const Cell& last, const Action& action) const
{
  for (int z = first[2]; z <= last[2]; ++z)
    for (int y = first[1]; y <= last[1]; ++y)
      for (int x = first[0]; x <= last[0]; ++x) action(x, y, z);
}

template <class Take>
inline void BroadPhase::takeFrom(std::size_t begin, std::size_t end, const Query& query, const Take& take) const
{
  for (std::size_t q = begin; q < end; q += kLanes)
  {
    unsigned found = lanesIn(overlaps(entries_.data() + q, query)) & lowestBits(std::min(end - q, kLanes));
    for (; found != 0; found &= found - 1u) take(index_[q + static_cast<std::size_t>(__builtin_ctz(found))]);
  }
}

// How many there are in a range and how many of them overlap is hard to predict for a processor: so the first eight of every
// range are compared, whether they are there or not, and branches are taken for those that overlap and for what is left only.
template <std::size_t count, class Take>
inline void BroadPhase::takeFromRanges(const std::array<Range, count>& ranges, const Query& query,
                                       const Take& take) const
{
  static_assert(count * kFirst <= 64, "a bit for each");
  std::uint64_t found = 0;
  bool more = false;
  for (std::size_t r = 0; r < count; ++r)
  {
    const std::uint32_t size = ranges[r].end - ranges[r].begin;
    const PackedAabb* first = entries_.data() + ranges[r].begin;
    const unsigned here = lanesIn(overlaps(first, query)) | lanesIn(overlaps(first + kLanes, query)) << kLanes;
    found |= std::uint64_t{here & lowestBits(std::min<std::size_t>(size, kFirst))} << (kFirst * r);
    more |= size > kFirst;
  }
  for (; found != 0; found &= found - 1u)
  {
    const auto bit = static_cast<std::size_t>(__builtin_ctzll(found));
    take(index_[ranges[bit / kFirst].begin + bit % kFirst]);
  }
  if (!more) return;
  for (const Range& range : ranges) takeFrom(range.begin + kFirst, range.end, query, take);
}

template <class Take>
void BroadPhase::takeAround(const Query& query, const Take& take) const
{
  const std::size_t row = kSlices * row_, layer = kSlices * layer_;
  const std::size_t slice = sliceOf(query.packed.low());
  const Reach reach = reachOf(query.packed);
  std::array<std::array<Range, 3>, 3> rows;
  for (std::size_t z = 0; z < 3; ++z)
    for (std::size_t y = 0; y < 3; ++y)
    {
      rows[z][y] = inRow(slice + z * layer + y * row - layer - row, reach.x, (z < 2 || reach.z) && (y < 2 || reach.y));
      __builtin_prefetch(entries_.data() + rows[z][y].begin);
    }
  for (const std::array<Range, 3>& its : rows) takeFromRanges(its, query, take);
}

template <class Take>
void BroadPhase::takeFromCells(const PackedAabb& packed, const Take& take) const
{
  const Query query(packed);
  if (fits(packed)) return takeAround(query, take);
  const Cell low = cellAt(packed.low()), high = cellAt(packed.high);
  const std::size_t first = sliceAlong(packed.low()) - kSlices, last = sliceAlong(packed.high);
  for (int z = low[2] - 1; z <= high[2]; ++z)
    for (int y = low[1] - 1; y <= high[1]; ++y)
    {
      const std::size_t row = kSlices * cell(0, y, z);
      takeFrom(start_[row + first], start_[row + last + 1], query, take);
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
    const Query query(entries_[p]);
    own = index_[p];
    const std::size_t slice = sliceOf(entries_[p].low()), above = slice + layer;
    const Reach reach = reachOf(entries_[p]);
    // Of two boxes the one whose cell comes first looks for the other: further on in its row, in the row behind, in the layer above.
    const Range higher{static_cast<std::uint32_t>(p + 1), start_[slice + reach.x + 1]};
    takeFromRanges(std::array{higher, inRow(slice + row, reach.x, reach.y), inRow(above - row, reach.x, reach.z),
                              inRow(above, reach.x, reach.z), inRow(above + row, reach.x, reach.y && reach.z)},
                   query, take);
  }
  for (std::size_t p = std::max(begin, in_cells_); p < end; ++p)
  {
    own = index_[p];
    takeFromCells(entries_[p], take);
    takeFrom(p + 1, boxes_, Query(entries_[p]), take);
  }
  action(pairs.data(), count);
}

template <class Take>
void BroadPhase::takeFromLists(const PackedAabb& packed, const Take& take) const
{
  for (const Listed& box : everywhere_)
    if (overlap(box.packed, packed)) take(box.index);
  if (!any_link_) return;
  const Cell first = cellAt(packed.low()), last = cellAt(packed.high);
  const Listed* only = parts() == 1 ? links_.front().data() : nullptr;
  const auto takeFromList = [&](int x, int y, int z)
  {
    for (std::uint32_t link = last_link_[cell(x, y, z)]; link != kNoLink;)
    {
      const Listed& box = only ? only[link] : links_[link >> kLinkBits][link & ((1u << kLinkBits) - 1u)];
      link = box.next;
      const Cell its = cellAt(box.packed.low());  // of all cells that both are in, the first one tells
      const bool tells =
          (x == std::max(first[0], its[0])) & (y == std::max(first[1], its[1])) & (z == std::max(first[2], its[2]));
      if (overlap(box.packed, packed) & tells) take(box.index);
    }
  };
  eachCell(first, last, takeFromList);
}

template <class Action>
void BroadPhase::eachPartOf(const PackedAabb& packed, const Action& action) const
{
  if (parts() == 1) return action(0);
  const Cell low = cellAt(packed.low()), high = cellAt(packed.high);
  if (overManyCells(low, high)) return action(0);
  const std::size_t first = cell(low[0], low[1], low[2]), last = cell(high[0], high[1], high[2]);
  for (std::size_t part = 0; part < parts(); ++part)
    if (first < firstCell(part + 1) && last >= firstCell(part)) action(part);
}

template <class AnyBox>
void BroadPhase::deferInsertion(std::uint32_t index, const AnyBox& box, Additions& list) const
{
  if (box.empty()) return;
  if (list.size() < parts()) list.resize(parts());
  const Addition addition{pack(box), index | kAdded};
  eachPartOf(addition.packed, [&](std::size_t part) { list[part].push_back(addition); });
}

// Each part of the grid is one worker's.
template <class List>
void BroadPhase::add(std::vector<List>& lists, Additions List::*member, Workers& workers)
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
                     for (const Addition& one : (list.*member)[part]) addToLists(part, one.packed, one.index);
                     (list.*member)[part].clear();
                   }
               });
}

template <class AnyBox>
void BroadPhase::listOverlapping(const AnyBox& box, std::vector<std::uint32_t>& list) const
{
  if (box.empty()) return;
  const PackedAabb packed = pack(box);
  const auto take = [&list](std::uint32_t index) { list.push_back(index); };
  takeFromCells(packed, take);
  takeFromLists(packed, take);
}

template <class Action>
void BroadPhase::eachPair(const Action& action) const
{
  eachPairs(
      0, boxes_, [](std::uint32_t, std::uint32_t) {},
      [&action](const Pair* pairs, std::size_t count)
      {
        for (std::size_t p = 0; p < count; ++p) action(pairs[p][0], pairs[p][1]);
      });
}
}  // namespace ping_pong
