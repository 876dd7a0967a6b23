#include "broad_phase.h"

#include <cmath>
#include <numeric>

#include "count.h"
#include "take_memory.h"

namespace ping_pong
{
namespace
{
constexpr double kCellsPerBox = 0.7;  // at most, but for empty ones at the border,
constexpr double kMostCells = 1.5;    // and with these
constexpr double kFewCells = 64.0;    // more than that
constexpr double kManyCells = 64.0;   // a box over more cells than this is in no list of a cell
constexpr double kSpread = 3.0;     // the grid covers so many standard deviations; boxes outside are in its outer cells
constexpr double kLongEdges = 3.0;  // longer than the mean along an axis by so many standard deviations: in no cell

double deviation(double sum, double sum_of_squares, double n)
{
  const double mean = sum / n;
  return std::sqrt(std::max(sum_of_squares / n - mean * mean, 0.0));
}

int bitsFor(double count)
{
  int bits = 0;
  while (std::ldexp(1.0, bits) < count) ++bits;
  return bits;
}
}  // namespace

void BroadPhase::reserve(std::size_t boxes)
{
  const auto cells = static_cast<std::size_t>(kMostCells * static_cast<double>(boxes) + kFewCells);
  takeMemory(start_, kSlices * cells + 4);
  takeMemory(index_, boxes + kFirst);
  takeMemory(sorted_, boxes + kFirst);
  takeMemory(range_, boxes);
  takeMemory(blocks_, boxes / kBlock + 1);
  takeMemory(placed_, boxes);
  takeMemory(entries_, boxes + kFirst);
  takeMemory(last_link_, cells);
  takeMemory(links_, 16 * boxes);
  takeMemory(everywhere_, boxes);
}

// Cells are as long as the longest box in one, or longer: until there are not too many, and a corner has room for all.
void BroadPhase::layOut(const Sums& sums, std::size_t count)
{
  const double n = std::max(sums.n, 1.0), boxes = static_cast<double>(count);
  std::array<double, 3> origin{}, width{}, size{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    size[i] = sums.edge[i] / n + kLongEdges * deviation(sums.edge[i], sums.edge_squared[i], n) + 1e-9;
    const double mean = sums.low[i] / n, spread = kSpread * deviation(sums.low[i], sums.low_squared[i], n);
    origin[i] = sums.n > 0.0 ? std::max(sums.least[i], mean - spread) : 0.0;
    width[i] = sums.n > 0.0 ? std::max(std::min(sums.greatest[i], mean + spread) - origin[i], 0.0) : 0.0;
  }
  std::array<int, 3> cell_bits{};
  for (;; size = {1.04 * size[0], 1.04 * size[1], 1.04 * size[2]})
  {
    double inner = 1.0, cells = 1.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double row = std::floor(width[i] / size[i]) + 1.0;
      inner *= row;
      cells *= row + 2.0;
      cell_bits[i] = bitsFor(row + 2.0);
    }
    if (inner > kCellsPerBox * boxes + 1.0 || cells > kMostCells * boxes + kFewCells) continue;
    if (cell_bits[0] + cell_bits[1] + cell_bits[2] + 3 * kLeastUnitBits <= kPlaceBits) break;
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    axes_[i].cells = static_cast<int>(width[i] / size[i]) + 3;
    axes_[i].origin = origin[i] - size[i];
    axes_[i].units_per_metre = 1.0 / size[i];
  }
  layOutCorners(cell_bits);
  if (count != count_) takePlaces(count);
  start_.resize(slices_ + 3);
}

// All in the order of their indices.
void BroadPhase::takePlaces(std::size_t count)
{
  count_ = count;
  placed_.resize(count);
  range_.resize(count);
  blocks_.resize((count + kBlock - 1) / kBlock);
  entries_.resize(count + kFirst);
  index_.assign(count + kFirst, 0);
  sorted_.assign(count + kFirst, 0);
  std::iota(index_.begin(), index_.begin() + static_cast<std::ptrdiff_t>(count), 0u);
}

// What bits are left after the numbers of cells are for units in them.
void BroadPhase::layOutCorners(const std::array<int, 3>& cell_bits)
{
  const int left = kPlaceBits - cell_bits[0] - cell_bits[1] - cell_bits[2];
  int shift = 0;
  borrows_ = longest_ = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    Axis& axis = axes_[i];
    axis.shift = shift;
    axis.unit_bits = (left + static_cast<int>(i)) / 3;
    const double units = std::ldexp(1.0, axis.unit_bits);
    axis.units_per_metre *= units;
    axis.first = units;
    axis.last = units * (axis.cells - 1) - 1.0;
    const int bits = cell_bits[i] + axis.unit_bits;
    axis.mask = (Corner{1} << bits) - 1;
    axis.cell_bits = axis.mask >> axis.unit_bits << axis.unit_bits << shift;
    borrows_ |= Corner{1} << (shift + bits);
    longest_ |= Corner{1} << (shift + axis.unit_bits);
    shift += bits + 1;
  }
  slice_shift_ = axes_[0].shift + axes_[0].unit_bits - kSliceBits;
  slice_mask_ = axes_[0].mask >> (axes_[0].unit_bits - kSliceBits);
  row_ = static_cast<std::size_t>(axes_[0].cells);
  layer_ = row_ * static_cast<std::size_t>(axes_[1].cells);
  cells_ = layer_ * static_cast<std::size_t>(axes_[2].cells);
  slices_ = kSlices * cells_;
}

void BroadPhase::addToLists(const Extent& extent, std::uint32_t index)
{
  const Cell first = cellAt(extent.low()), last = cellAt(extent.high);
  const double cells = (last[0] - first[0] + 1.0) * (last[1] - first[1] + 1.0) * (last[2] - first[2] + 1.0);
  if (cells > kManyCells) return everywhere_.push_back({extent, index, kNoLink});
  if (links_.empty()) last_link_.assign(cells_, kNoLink);
  eachCell(first, last,
           [&](int x, int y, int z)
           {
             std::uint32_t& link = last_link_[cell(x, y, z)];
             links_.push_back({extent, index, link});
             link = static_cast<std::uint32_t>(links_.size() - 1);
           });
}

void BroadPhase::add(const std::vector<Addition>& list)
{
  for (const Addition& one : list) addToLists(one.extent, one.index);
}

void BroadPhase::noteBlock(std::size_t block)
{
  Block& noted = blocks_[block] = {~0u, 0u};
  for (std::size_t place = block * kBlock; place < endOf(block); ++place)
  {
    noted.least = std::min(noted.least, range_[place]);
    noted.greatest = std::max(noted.greatest, range_[place]);
  }
}

// So that each part has about as many boxes: they are nearly sorted, as long as balls have not gone far.
std::uint32_t BroadPhase::firstRange(std::size_t part, std::size_t parts) const
{
  if (part == parts) return static_cast<std::uint32_t>(slices_ + 2);
  std::uint32_t first = 0;
  for (std::size_t p = 1; p <= part; ++p)
  {
    const Block& block = blocks_[p * blocks_.size() / parts];
    first = std::max(first, block.least + (block.greatest - block.least) / 2);
  }
  return first;
}

// Counting sort of the boxes from the first range to before the last. What comes before them is counted only.
void BroadPhase::sortRanges(std::uint32_t first, std::uint32_t last)
{
  const auto isHere = [&](std::uint32_t range) { return range >= first && range < last; };
  std::fill(start_.begin() + first, start_.begin() + last, 0u);
  std::uint32_t total = 0;
  for (std::size_t block = 0; block < blocks_.size(); ++block)
  {
    const std::size_t begin = block * kBlock, end = endOf(block);
    if (blocks_[block].least >= last) continue;
    if (blocks_[block].greatest < first)
      total += static_cast<std::uint32_t>(end - begin);
    else
      for (std::size_t place = begin; place < end; ++place)
      {
        total += range_[place] < first;
        if (isHere(range_[place])) ++start_[range_[place]];
      }
  }
  for (std::uint32_t range = first; range < last; ++range)
    start_[range] = total += start_[range];  // ends of the ranges; filled from behind they become starts
  for (std::size_t block = blocks_.size(); block-- > 0;)
  {
    if (blocks_[block].least >= last || blocks_[block].greatest < first) continue;
    for (std::size_t place = endOf(block); place-- > block * kBlock;)
    {
      if (!isHere(range_[place])) continue;
      const std::uint32_t to = --start_[range_[place]];
      sorted_[to] = index_[place];
      entries_[to] = placed_[place];
    }
  }
}

void BroadPhase::sort(Workers& workers)
{
  count(Law::BroadPhase);
  links_.clear();
  everywhere_.clear();
  const std::size_t parts = std::max<std::size_t>(std::min(workers.count(), blocks_.size()), 1);
  workers.each(parts, 1,
               [&](std::size_t begin, std::size_t end, std::size_t)
               {
                 for (std::size_t part = begin; part < end; ++part) sortRanges(firstRange(part, parts), firstRange(part + 1, parts));
               });
  start_[slices_ + 2] = static_cast<std::uint32_t>(count_);
  index_.swap(sorted_);
  in_cells_ = start_[slices_];
  boxes_ = start_[slices_ + 1];
  for (std::size_t p = in_cells_; p < boxes_; ++p) addToLists(entries_[p], index_[p]);
}
}  // namespace ping_pong
