#include "detect/broad_phase.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/law_counter.h"
#include "base/prefault.h"

namespace ping_pong
{
namespace
{
constexpr double kCellsPerBox = 0.7;  // at most, but for empty ones at the border,
constexpr double kMostCells = 1.5;    // and with these
constexpr double kFewCells = 64.0;    // more than that
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

void BroadPhase::reserve(std::size_t boxes, std::size_t workers)
{
  const auto cells = static_cast<std::size_t>(kMostCells * static_cast<double>(boxes) + kFewCells);
  takeMemory(start_, kSlices * cells + 4);
  takeMemory(index_, boxes + kFirst);
  takeMemory(at_, boxes + kFirst);
  takeMemory(range_, boxes);
  takeMemory(blocks_, boxes / kBlock + 1);
  takeMemory(placed_, boxes);
  takeMemory(entries_, boxes + kFirst);
  takeMemory(last_link_, cells);
  first_.reserve(workers + 1);
  links_.resize(std::max(links_.size(), workers));
  for (std::vector<Listed>& links : links_) takeMemory(links, 16 * boxes / workers);
  takeMemory(everywhere_, boxes);
}

// Cells are as long as the longest box in one, or longer: until there are not too many, and a packed point has room for all.
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
  layOutPackedPoints(cell_bits);
  if (count != count_)
    takePlaces(count);
  else if (shared_)
    at_.swap(index_);
  start_.resize(slices_ + 3);
}

// All in the order of their indices.
void BroadPhase::takePlaces(std::size_t count)
{
  count_ = count;
  placed_.resize(count);
  range_.resize(count);
  blocks_.assign((count + kBlock - 1) / kBlock, Block());
  entries_.resize(count + kFirst);
  index_.assign(count + kFirst, 0);
  at_.assign(count + kFirst, 0);
  std::iota(at_.begin(), at_.begin() + static_cast<std::ptrdiff_t>(count), 0u);
}

// What bits are left after the numbers of cells are for units in them.
void BroadPhase::layOutPackedPoints(const std::array<int, 3>& cell_bits)
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
    axis.mask = (PackedPoint{1} << bits) - 1;
    axis.cell_bits = axis.mask >> axis.unit_bits << axis.unit_bits << shift;
    borrows_ |= PackedPoint{1} << (shift + bits);
    longest_ |= PackedPoint{1} << (shift + axis.unit_bits);
    shift += bits + 1;
  }
  slice_shift_ = axes_[0].shift + axes_[0].unit_bits - kSliceBits;
  slice_mask_ = axes_[0].mask >> (axes_[0].unit_bits - kSliceBits);
  // Parts of the room are cut across y or z, whichever is longer: fewer boxes are near a border.
  const auto x = static_cast<std::size_t>(axes_[0].cells), y = static_cast<std::size_t>(axes_[1].cells),
             z = static_cast<std::size_t>(axes_[2].cells);
  row_ = y > z ? x * z : x;
  layer_ = y > z ? x : x * y;
  cells_ = x * y * z;
  slices_ = kSlices * cells_;
}

// Into those of this part, which is one of its parts.
void BroadPhase::addToLists(std::size_t part, const PackedAabb& packed, std::uint32_t index)
{
  const Cell first = cellAt(packed.low()), last = cellAt(packed.high);
  if (overManyCells(first, last)) return everywhere_.push_back({packed, index, kNoLink});
  std::vector<Listed>& links = links_[part];
  const std::size_t begin = firstCell(part), end = firstCell(part + 1);
  eachCell(first, last,
           [&](int x, int y, int z)
           {
             const std::size_t its = cell(x, y, z);
             if (its < begin || its >= end) return;
             links.push_back({packed, index, last_link_[its]});
             last_link_[its] = static_cast<std::uint32_t>(part << kLinkBits | (links.size() - 1));
           });
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

// Half of its boxes in cells come before.
std::uint32_t BroadPhase::middleOf(std::size_t block) const
{
  std::array<std::uint32_t, kBlock> ranges;
  const auto inCell = [this](std::uint32_t range) { return range < slices_; };
  const auto last = std::copy_if(range_.begin() + static_cast<std::ptrdiff_t>(block * kBlock),
                                 range_.begin() + static_cast<std::ptrdiff_t>(endOf(block)), ranges.begin(), inCell);
  const auto middle = ranges.begin() + (last - ranges.begin()) / 2;
  std::nth_element(ranges.begin(), middle, last);
  return middle == last ? 0 : *middle;
}

// So that each has about as many boxes: they are nearly sorted, as long as balls have not gone far.
void BroadPhase::cutIntoParts(std::size_t count)
{
  if (links_.size() < count) links_.resize(count);
  first_.assign(count + 1, 0);
  for (std::size_t part = 1; part < count; ++part)
    first_[part] = std::min(std::max(first_[part - 1], middleOf(part * blocks_.size() / count)),
                            static_cast<std::uint32_t>(slices_));
  first_[count] = static_cast<std::uint32_t>(slices_ + 2);
}

// Counting sort. Of the boxes before the part it is only known how many they are.
void BroadPhase::sortPart(std::size_t part)
{
  const std::uint32_t first = first_[part], last = first_[part + 1];
  const auto isHere = [&](std::uint32_t range) { return range >= first && range < last; };
  const auto anyHere = [&](const Block& block) { return block.greatest >= first && block.least < last; };
  const auto allHere = [&](const Block& block)
  { return parts() == 1 || (block.least >= first && block.greatest < last); };
  std::fill(start_.begin() + first, start_.begin() + last, 0u);
  std::uint32_t total = 0;
  for (std::size_t block = 0; block < blocks_.size(); ++block)
  {
    const std::size_t begin = block * kBlock, end = endOf(block);
    if (blocks_[block].greatest < first)
      total += static_cast<std::uint32_t>(end - begin);
    else if (allHere(blocks_[block]))
      for (std::size_t place = begin; place < end; ++place) ++start_[range_[place]];
    else if (anyHere(blocks_[block]))
      for (std::size_t place = begin; place < end; ++place)
      {
        total += range_[place] < first;
        if (isHere(range_[place])) ++start_[range_[place]];
      }
  }
  for (std::uint32_t range = first; range < last; ++range)
    start_[range] = total += start_[range];  // ends of the ranges; filled from behind they become starts
  const auto take = [&](std::size_t place)
  {
    const std::uint32_t to = --start_[range_[place]];
    index_[to] = at_[place];
    entries_[to] = placed_[place];
  };
  for (std::size_t block = blocks_.size(); block-- > 0;)
  {
    const std::size_t begin = block * kBlock, end = endOf(block);
    if (allHere(blocks_[block]))
      for (std::size_t place = end; place-- > begin;) take(place);
    else if (anyHere(blocks_[block]))
      for (std::size_t place = end; place-- > begin;)
        if (isHere(range_[place])) take(place);
  }
}

// Lists of cells are emptied by whom they will be filled.
void BroadPhase::sort(Workers& workers)
{
  count(Law::BroadPhase);
  any_link_ = false;
  everywhere_.clear();
  last_link_.resize(cells_);
  cutIntoParts(std::max<std::size_t>(std::min(workers.count(), blocks_.size()), 1));
  workers.each(parts(), 1,
               [&](std::size_t begin, std::size_t end, std::size_t)
               {
                 for (std::size_t part = begin; part < end; ++part)
                 {
                   sortPart(part);
                   links_[part].clear();
                   std::fill(last_link_.begin() + static_cast<std::ptrdiff_t>(firstCell(part)),
                             last_link_.begin() + static_cast<std::ptrdiff_t>(firstCell(part + 1)), kNoLink);
                 }
               });
  start_[slices_ + 2] = static_cast<std::uint32_t>(count_);
  shared_ = workers.count() > 1;
  in_cells_ = start_[slices_];
  boxes_ = start_[slices_ + 1];
  if (in_cells_ < boxes_) any_link_ = true;
  for (std::size_t p = in_cells_; p < boxes_; ++p)
    eachPartOf(entries_[p], [&](std::size_t part) { addToLists(part, entries_[p], index_[p]); });
}
}  // namespace ping_pong
