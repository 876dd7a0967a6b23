// Templates of BroadPhase: how boxes come into the grid.
#pragma once

#include "detect/broad_phase.h"

namespace ping_pong
{
struct BroadPhase::Addition
{
  PackedAabb packed;
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
  putAll(
      workers, [](std::uint32_t) {},
      [&](std::size_t place, std::uint32_t index, std::size_t) { put(place, box(index)); });
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
BroadPhase::PackedPoint BroadPhase::packPoint(const AnyBox& p) const
{
  PackedPoint point = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Axis& axis = axes_[static_cast<std::size_t>(i)];
    const double units = (p[i] - axis.origin) * axis.units_per_metre;
    point |= static_cast<PackedPoint>(static_cast<std::int32_t>(std::max(std::min(units, axis.last), axis.first)))
             << axis.shift;
  }
  return point;
}

template <class AnyBox>
[[gnu::always_inline]] inline BroadPhase::PackedAabb BroadPhase::pack(const AnyBox& box) const
{
  return {0u - packPoint(box.low), packPoint(box.high) | borrows_};
}

inline bool BroadPhase::fits(const PackedAabb& packed) const
{
  const PackedPoint edges = (packed.high & ~borrows_) + packed.minus_low;  // of each axis: none borrows
  return (((longest_ | borrows_) - edges) & borrows_) == borrows_;
}

template <class AnyBox>
[[gnu::always_inline]] inline void BroadPhase::put(std::size_t place, const AnyBox& box)
{
  std::size_t range = slices_ + 1;
  if (!box.empty())
  {
    const PackedAabb packed = placed_[place] = pack(box);
    range = fits(packed) ? sliceOf(packed.low()) : slices_;
  }
  range_[place] = static_cast<std::uint32_t>(range);
}

inline LaneMask BroadPhase::overlaps(const PackedAabb* entries, const Query& query) const
{
  PackedPoints two, others;
  std::memcpy(&two, entries, sizeof(two));
  std::memcpy(&others, entries + 2, sizeof(others));
  two += query.both;
  others += query.both;
  const PackedPoints borrows{borrows_, borrows_, borrows_, borrows_};
  return (pick<0, 2, 4, 6>(two, others) & pick<1, 3, 5, 7>(two, others) & borrows) == borrows;
}
}  // namespace ping_pong
