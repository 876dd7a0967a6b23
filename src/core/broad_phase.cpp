#include "broad_phase.h"

#include <algorithm>
#include <cmath>

#include "count.h"
#include "take_memory.h"

namespace ping_pong
{
namespace
{
constexpr double kCellsPerBox = 2.0;  // cells of the grid for each box, at most
constexpr double kSpread = 3.0;     // the grid covers so many standard deviations; boxes outside are in its outer cells
constexpr double kLongEdges = 4.0;  // longer than the mean along an axis by so many standard deviations: in no cell
constexpr double kShare = 0.99;     // of a cell, that a box in it is long: rounding puts nobody two cells away
constexpr std::size_t kGrain = 512;  // boxes that a worker takes at a time
}  // namespace

// What the cells are made for. Sums of workers are added in any order: cells may differ by rounding, pairs do not.
struct BroadPhase::Sums
{
  double n = 0.0;
  std::array<double, 3> edge{}, edge_squared{}, low{}, low_squared{};
  std::array<float, 3> least{1e30f, 1e30f, 1e30f}, greatest{-1e30f, -1e30f, -1e30f};

  void add(const CoarseBox& box)
  {
    n += 1.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double x = box.low[i], e = box.high[i] - box.low[i];
      edge[i] += e;
      edge_squared[i] += e * e;
      low[i] += x;
      low_squared[i] += x * x;
      least[i] = std::min(least[i], box.low[i]);
      greatest[i] = std::max(greatest[i], box.low[i]);
    }
  }
  void add(const Sums& other)
  {
    n += other.n;
    for (std::size_t i = 0; i < 3; ++i)
    {
      edge[i] += other.edge[i];
      edge_squared[i] += other.edge_squared[i];
      low[i] += other.low[i];
      low_squared[i] += other.low_squared[i];
      least[i] = std::min(least[i], other.least[i]);
      greatest[i] = std::max(greatest[i], other.greatest[i]);
    }
  }
};

namespace
{
double deviation(double sum, double sum_of_squares, double n)
{
  const double mean = sum / n;
  return std::sqrt(std::max(sum_of_squares / n - mean * mean, 0.0));
}
}  // namespace

void BroadPhase::reserve(std::size_t boxes)
{
  takeMemory(start_, static_cast<std::size_t>(4.0 * kCellsPerBox) * boxes + 64);  // with empty ones around the grid
  takeMemory(cell_of_, boxes);
  takeMemory(entries_, boxes);
  takeMemory(added_start_, start_.capacity());
  takeMemory(added_, 16 * boxes);
  takeMemory(added_large_, boxes);
}

void BroadPhase::layOut(const std::vector<CoarseBox>& boxes, Workers& workers)
{
  Sums sums;
  std::mutex adding;
  workers.each(boxes.size(), 8 * kGrain,
               [&](std::size_t begin, std::size_t end, std::size_t)
               {
                 Sums part;
                 for (std::size_t i = begin; i < end; ++i)
                   if (!boxes[i].empty()) part.add(boxes[i]);
                 const std::lock_guard<std::mutex> lock(adding);
                 sums.add(part);
               });
  const double n = std::max(sums.n, 1.0);
  std::array<double, 3> width{}, size{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    longest_[i] =
        static_cast<float>(sums.edge[i] / n + kLongEdges * deviation(sums.edge[i], sums.edge_squared[i], n)) + 1e-9f;
    size[i] = longest_[i] / kShare;
    const double mean = sums.low[i] / n, spread = kSpread * deviation(sums.low[i], sums.low_squared[i], n);
    origin_[i] = sums.n > 0.0 ? std::max<double>(sums.least[i], mean - spread) : 0.0;
    width[i] = sums.n > 0.0 ? std::max(std::min<double>(sums.greatest[i], mean + spread) - origin_[i], 0.0) : 0.0;
  }
  // Fewer and larger cells, until there are not many more than boxes, and the corners of all have a number.
  const double most_cells = static_cast<double>(kFieldMask) / kUnits - 2.0;
  for (;; size = {1.25 * size[0], 1.25 * size[1], 1.25 * size[2]})
  {
    double cells = 1.0, longest_row = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      cells *= std::floor(width[i] / size[i]) + 1.0;
      longest_row = std::max(longest_row, width[i] / size[i]);
    }
    if (cells <= kCellsPerBox * n + 1.0 && longest_row < most_cells) break;
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    units_per_metre_[i] = kUnits / size[i];
    count_[i] = static_cast<int>(width[i] / size[i]) + 1;
    last_[i] = kUnits * count_[i] - 1;
  }
}

bool BroadPhase::fits(const CoarseBox& box) const
{
  bool all = true;
  for (std::size_t i = 0; i < 3; ++i) all &= box.high[i] - box.low[i] <= longest_[i];
  return all;
}

// Rounded down, high corners too: what overlaps still does.
BroadPhase::Corner BroadPhase::cornerAt(const float* p) const
{
  Corner corner = 0;
  for (int i = 0; i < 3; ++i)
  {
    const auto axis = static_cast<std::size_t>(i);
    const double units = (p[i] - origin_[axis]) * units_per_metre_[axis];
    corner |= static_cast<Corner>(static_cast<std::int32_t>(std::clamp(units, 0.0, last_[axis]))) << (kField * i);
  }
  return corner;
}

BroadPhase::Range BroadPhase::cellsOf(Corner low, Corner high, int cells_before) const
{
  Range range;
  for (int i = 0; i < 3; ++i)
  {
    range.low[static_cast<std::size_t>(i)] = std::max(field(low, i) / kUnits - cells_before, 0);
    range.high[static_cast<std::size_t>(i)] = field(high, i) / kUnits;
  }
  return range;
}

double BroadPhase::Range::cells() const
{
  return (high[0] - low[0] + 1.0) * (high[1] - low[1] + 1.0) * (high[2] - low[2] + 1.0);
}

void BroadPhase::fill(const std::vector<CoarseBox>& boxes, Workers& workers)
{
  const auto n = static_cast<std::uint32_t>(boxes.size());
  cell_of_.resize(n);
  workers.each(n, kGrain,
               [&](std::size_t begin, std::size_t end, std::size_t)
               {
                 for (std::size_t i = begin; i < end; ++i)
                   cell_of_[i] = boxes[i].empty() ? kEmpty : fits(boxes[i]) ? cellOf(cornerAt(boxes[i].low)) : kLarge;
               });
  start_.assign(cell(count_[0], count_[1], count_[2]) + 2, 0);
  large_ = 0;
  for (const std::uint32_t cell : cell_of_)
    if (cell < kLarge)
      ++start_[cell];
    else
      large_ += cell == kLarge;
  std::uint32_t total = 0;
  for (std::uint32_t& start : start_)
    start = total += start;  // ends of the cells; filled from behind they become starts
  entries_.resize(total + large_);
  std::size_t next_large = entries_.size();
  for (std::uint32_t i = n; i-- > 0;)
  {
    if (cell_of_[i] < kLarge)
      entries_[--start_[cell_of_[i]]].index = i;
    else if (cell_of_[i] == kLarge)
      entries_[--next_large].index = i;
  }
  workers.each(entries_.size(), kGrain,
               [&](std::size_t begin, std::size_t end, std::size_t)
               {
                 for (std::size_t p = begin; p < end; ++p)
                 {
                   const CoarseBox& box = boxes[entries_[p].index];
                   entries_[p].low = cornerAt(box.low);
                   entries_[p].high = cornerAt(box.high);
                 }
               });
}

void BroadPhase::build(const std::vector<CoarseBox>& boxes, Workers& workers)
{
  count(Law::BroadPhase);
  layOut(boxes, workers);
  fill(boxes, workers);
  added_.clear();
  added_large_.clear();
}

void BroadPhase::add(std::uint32_t index, const CoarseBox& box)
{
  const Range range = cellsOf(cornerAt(box.low), cornerAt(box.high), 0);
  if (range.cells() > kManyCells) return added_large_.push_back(index);
  if (added_.empty()) added_start_.assign(start_.size() - 1, kNoEntry);
  for (int z = range.low[2]; z <= range.high[2]; ++z)
    for (int y = range.low[1]; y <= range.high[1]; ++y)
      for (int x = range.low[0]; x <= range.high[0]; ++x)
      {
        const std::size_t c = cell(x, y, z);
        added_.push_back({index, added_start_[c], range.low});
        added_start_[c] = static_cast<std::uint32_t>(added_.size() - 1);
      }
}
}  // namespace ping_pong
