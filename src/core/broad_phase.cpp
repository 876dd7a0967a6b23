#include "broad_phase.h"

#include <cmath>

#include "count.h"
#include "take_memory.h"

namespace ping_pong
{
namespace
{
constexpr double kCellsPerBox = 0.5;  // cells of the grid for each box, at most
constexpr double kFinest = 0.5;       // edge of a cell, by the longest box in it
constexpr double kManyCells = 64.0;   // a box over more cells than this is in no list of a cell
constexpr double kSpread = 3.0;     // the grid covers so many standard deviations; boxes outside are in its outer cells
constexpr double kLongEdges = 3.0;  // longer than the mean along an axis by so many standard deviations: in no cell

double deviation(double sum, double sum_of_squares, double n)
{
  const double mean = sum / n;
  return std::sqrt(std::max(sum_of_squares / n - mean * mean, 0.0));
}
}  // namespace

void BroadPhase::reserve(std::size_t boxes)
{
  takeMemory(start_, static_cast<std::size_t>(kCellsPerBox * static_cast<double>(boxes)) + 64);
  takeMemory(index_, boxes);
  takeMemory(entries_, boxes);
  takeMemory(last_link_, start_.capacity());
  takeMemory(links_, 16 * boxes);
  takeMemory(everywhere_, boxes);
}

void BroadPhase::layOut(const Sums& sums, std::size_t count)
{
  const double n = std::max(sums.n, 1.0);
  std::array<double, 3> width{}, longest{}, size{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    longest[i] = sums.edge[i] / n + kLongEdges * deviation(sums.edge[i], sums.edge_squared[i], n) + 1e-9;
    size[i] = kFinest * longest[i];
    const double mean = sums.low[i] / n, spread = kSpread * deviation(sums.low[i], sums.low_squared[i], n);
    origin_[i] = sums.n > 0.0 ? std::max(sums.least[i], mean - spread) : 0.0;
    width[i] = sums.n > 0.0 ? std::max(std::min(sums.greatest[i], mean + spread) - origin_[i], 0.0) : 0.0;
  }
  // Fewer and larger cells, until there are not many more than boxes, and all corners have a number.
  const double most_cells = static_cast<double>(kFieldMask) / kUnits - 2.0;
  for (;; size = {1.125 * size[0], 1.125 * size[1], 1.125 * size[2]})
  {
    double cells = 1.0, longest_row = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      cells *= std::floor(width[i] / size[i]) + 1.0;
      longest_row = std::max(longest_row, width[i] / size[i]);
    }
    if (cells <= kCellsPerBox * static_cast<double>(count) + 1.0 && longest_row < most_cells) break;
  }
  longest_ = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    units_per_metre_[i] = kUnits / size[i];
    longest_ |= (static_cast<Corner>(std::ceil(std::min(longest[i] * units_per_metre_[i], 1e6))) + 1) << (kField * static_cast<int>(i));
    count_[i] = static_cast<int>(width[i] / size[i]) + 1;
    last_[i] = kUnits * count_[i] - 1;
  }
  entries_.resize(count);
  index_.resize(count);
}

bool BroadPhase::fits(const Extent& extent) const
{
  const Corner edges = (extent.high & ~kBorrows) - extent.low;  // of each axis: none borrows
  return (((longest_ | kBorrows) - edges) & kBorrows) == kBorrows;
}

void BroadPhase::addToLists(const Extent& extent, std::uint32_t index)
{
  const Cell first = cellAt(extent.low), last = cellAt(extent.high);
  const double cells = (last[0] - first[0] + 1.0) * (last[1] - first[1] + 1.0) * (last[2] - first[2] + 1.0);
  if (cells > kManyCells) return everywhere_.push_back({extent, index, kNoLink});
  if (links_.empty()) last_link_.assign(start_.size(), kNoLink);
  eachCell(first, last,
           [&](int x, int y, int z)
           {
             std::uint32_t& link = last_link_[cell(x, y, z)];
             links_.push_back({extent, index, link});
             link = static_cast<std::uint32_t>(links_.size() - 1);
           });
}

// The cell, or one of two more ranges after the last cell: of those in no cell, and of the empty ones.
std::size_t BroadPhase::rangeOf(const Extent& extent) const
{
  const std::size_t cells = start_.size() - 3;
  return extent.low == kEmpty ? cells + 1 : fits(extent) ? cellOf(extent.low) : cells;
}

void BroadPhase::sort()
{
  count(Law::BroadPhase);
  links_.clear();
  everywhere_.clear();
  start_.assign(cell(0, 0, count_[2]) + 3, 0);
  for (const Extent& extent : entries_) ++start_[rangeOf(extent)];
  std::uint32_t total = 0;
  for (std::uint32_t& start : start_)
    start = total += start;  // ends of the ranges; filled from behind they become starts
  for (std::size_t i = entries_.size(); i-- > 0;) index_[--start_[rangeOf(entries_[i])]] = static_cast<std::uint32_t>(i);
  in_cells_ = start_[start_.size() - 3];
  boxes_ = start_[start_.size() - 2];
  // Entries follow: each hole is filled by who belongs there, until a cycle is closed.
  for (std::size_t p = 0; p < entries_.size(); ++p)
  {
    if (entries_[p].low & kMoved)
    {
      entries_[p].low &= ~kMoved;
      continue;
    }
    const Extent first = entries_[p];
    std::size_t hole = p;
    for (std::size_t from = index_[p]; from != p; hole = from, from = index_[from])
    {
      entries_[hole] = entries_[from];
      entries_[hole].low |= kMoved;
    }
    entries_[hole] = first;
    if (hole == p) continue;
    entries_[hole].low |= kMoved;
    entries_[p].low &= ~kMoved;
  }
  for (std::size_t p = in_cells_; p < boxes_; ++p) addToLists(entries_[p], index_[p]);
}
}  // namespace ping_pong
