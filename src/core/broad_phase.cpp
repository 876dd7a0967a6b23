#include "broad_phase.h"

#include <algorithm>
#include <cmath>

#include "count.h"

namespace ping_pong
{
namespace
{
constexpr int kManyCells = 64;         // a box over more cells than this is large
constexpr double kCellsPerBox = 2.0;   // cells of the grid for each box, at most
constexpr double kSpread = 3.0;        // the grid covers so many standard deviations; boxes outside are in its outer cells
constexpr double kCellInBoxes = 1.5;   // edge of a cell, in mean edges of a box

bool before(const BroadPhase::Pair& p, const BroadPhase::Pair& q)
{
  return p.a != q.a ? p.a < q.a : p.b < q.b;
}
}  // namespace

void BroadPhase::reserve(std::size_t boxes)
{
  start_.reserve(static_cast<std::size_t>(kCellsPerBox) * boxes + 3);
  entries_.reserve(8 * boxes);
  large_.reserve(boxes);
  ranges_.reserve(boxes);
  pairs_.reserve(8 * boxes);
  added_start_.reserve(start_.capacity());
  added_.reserve(16 * boxes);
  added_large_.reserve(boxes);
}

void BroadPhase::layOut(const std::vector<Box>& boxes)
{
  double n = 0.0;
  Vector3d sum = Vector3d::Zero();
  double edge = 0.0;
  for (const Box& box : boxes)
  {
    if (box.empty()) continue;
    n += 1.0;
    sum += box.low;
    edge += (box.high - box.low).maxCoeff();
  }
  n = std::max(n, 1.0);
  const Vector3d mean = sum / n;
  Vector3d square = Vector3d::Zero();
  for (const Box& box : boxes)
    if (!box.empty()) square += (box.low - mean).cwiseAbs2();
  const Vector3d half = kSpread * (square / n).cwiseSqrt();
  origin_ = mean - half;
  double size = std::max(kCellInBoxes * edge / n, 1e-9);
  // Fewer and larger cells, until there are not many more than boxes.
  for (;; size *= 1.25)
  {
    double cells = 1.0;
    for (int i = 0; i < 3; ++i) cells *= std::floor(2.0 * half[i] / size) + 1.0;
    if (cells <= kCellsPerBox * n + 1.0) break;
  }
  cells_per_metre_ = 1.0 / size;
  for (int i = 0; i < 3; ++i) count_[i] = static_cast<int>(2.0 * half[i] / size) + 1;
}

BroadPhase::Range BroadPhase::cellsOf(const Box& box) const
{
  if (box.empty()) return {{0, 0, 0}, {-1, -1, -1}};
  Range range;
  for (int i = 0; i < 3; ++i)
  {
    const double last = count_[i] - 1;
    range.low[i] = static_cast<int>(std::clamp((box.low[i] - origin_[i]) * cells_per_metre_, 0.0, last));
    range.high[i] = static_cast<int>(std::clamp((box.high[i] - origin_[i]) * cells_per_metre_, 0.0, last));
  }
  return range;
}

double BroadPhase::Range::cells() const
{
  return (high[0] - low[0] + 1.0) * (high[1] - low[1] + 1.0) * (high[2] - low[2] + 1.0);
}

template <class Action>
void BroadPhase::eachCell(const Range& r, const Action& action) const
{
  for (int z = r.low[2]; z <= r.high[2]; ++z)
    for (int y = r.low[1]; y <= r.high[1]; ++y)
      for (int x = r.low[0]; x <= r.high[0]; ++x) action(static_cast<std::size_t>(cell(x, y, z)));
}

void BroadPhase::fill(const std::vector<Box>& boxes)
{
  start_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2] + 1, 0);
  ranges_.resize(boxes.size());
  large_.clear();
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
  {
    ranges_[i] = cellsOf(boxes[i]);
    if (ranges_[i].cells() > kManyCells)
      large_.push_back(i);
    else
      eachCell(ranges_[i], [this](std::size_t c) { ++start_[c]; });
  }
  std::uint32_t total = 0;
  for (std::uint32_t& start : start_) start = total += start;  // ends of the cells; filled from behind they become starts
  entries_.resize(total);
  for (std::uint32_t i = static_cast<std::uint32_t>(boxes.size()); i-- > 0;)
    if (ranges_[i].cells() <= kManyCells) eachCell(ranges_[i], [&](std::size_t c) { entries_[--start_[c]] = i; });
}

const std::vector<BroadPhase::Pair>& BroadPhase::findPairs(const std::vector<Box>& boxes)
{
  count(Law::BroadPhase);
  layOut(boxes);
  fill(boxes);
  added_.clear();
  added_large_.clear();
  added_start_.assign(start_.size() - 1, kNoEntry);
  pairs_.clear();
  for (std::size_t c = 0; c + 1 < start_.size(); ++c)
    for (std::uint32_t p = start_[c]; p < start_[c + 1]; ++p)
      for (std::uint32_t q = p + 1; q < start_[c + 1]; ++q)
      {
        const std::uint32_t a = entries_[p], b = entries_[q];
        if (!boxes[a].overlaps(boxes[b])) continue;
        // Boxes that share cells tell of it in the first of them only.
        const Range &ra = ranges_[a], &rb = ranges_[b];
        const int first = cell(std::max(ra.low[0], rb.low[0]), std::max(ra.low[1], rb.low[1]),
                               std::max(ra.low[2], rb.low[2]));
        if (first == static_cast<int>(c)) pairs_.push_back({a, b});
      }
  for (std::size_t l = 0; l < large_.size(); ++l)
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
    {
      const std::uint32_t big = large_[l];
      if (i == big || !boxes[i].overlaps(boxes[big])) continue;
      const bool other_large = std::binary_search(large_.begin(), large_.end(), i);
      if (!other_large || i > big) pairs_.push_back({std::min(i, big), std::max(i, big)});
    }
  std::sort(pairs_.begin(), pairs_.end(), before);
  return pairs_;
}

void BroadPhase::findOverlapping(const Box& box, const std::vector<Box>& boxes, std::vector<std::uint32_t>& found) const
{
  found.clear();
  const Range r = cellsOf(box);
  for (int z = r.low[2]; z <= r.high[2]; ++z)
    for (int y = r.low[1]; y <= r.high[1]; ++y)
      for (int x = r.low[0]; x <= r.high[0]; ++x)
      {
        const std::size_t c = static_cast<std::size_t>(cell(x, y, z));
        for (std::uint32_t p = start_[c]; p < start_[c + 1]; ++p)
          if (boxes[entries_[p]].overlaps(box)) found.push_back(entries_[p]);
      }
  for (const std::uint32_t i : large_)
    if (boxes[i].overlaps(box)) found.push_back(i);
}

void BroadPhase::add(std::uint32_t index, const Box& box)
{
  const Range range = cellsOf(box);
  if (range.cells() > kManyCells) return added_large_.push_back(index);
  eachCell(range, [&](std::size_t c) {
    added_.push_back({index, added_start_[c]});
    added_start_[c] = static_cast<std::uint32_t>(added_.size() - 1);
  });
}

void BroadPhase::findAdded(const Box& box, std::vector<std::uint32_t>& found) const
{
  found = added_large_;
  eachCell(cellsOf(box), [&](std::size_t c) {
    for (std::uint32_t e = added_start_[c]; e != kNoEntry; e = added_[e].next) found.push_back(added_[e].index);
  });
}
}  // namespace ping_pong
