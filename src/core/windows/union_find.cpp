#include "windows/union_find.h"

#include <algorithm>

#include "windows/islands.h"

namespace ping_pong
{
namespace
{
using Busy = IslandWork::Busy;
constexpr std::size_t kFew = 4;    // pairs are not worth sharing
constexpr std::size_t kAhead = 8;  // pairs are asked for before they are claimed

std::uint32_t rootOf(IslandRecords& islands, std::uint32_t i)
{
  for (;;)
  {
    std::uint32_t& root = islands.busy(i).root;
    if (root == i) return i;
    i = root = islands.busy(root).root;
  }
}

// The same for a ball of this worker, if the way to the root leads over balls of this worker only; else nobody.
std::uint32_t rootAmongOwn(IslandRecords& islands, const IslandWork& work, std::uint32_t i)
{
  if (islands.work.size() == 1) return rootOf(islands, i);
  for (;;)
  {
    std::uint32_t& root = islands.busy(i).root;
    if (root == i) return i;
    if (!islands.isOf(work, root)) return IslandRecords::kNoEntry;
    const std::uint32_t its = islands.busy(root).root;
    if (!islands.isOf(work, its)) return IslandRecords::kNoEntry;
    i = root = its;
  }
}

std::size_t square(std::size_t size)
{
  return size * size;
}

// The islands of these roots, or the one of both, are one that has to run.
void joinAndList(IslandRecords& islands, IslandWork& work, std::uint32_t a, std::uint32_t b)
{
  Busy& root = islands.busy(std::min(a, b));
  if (root.listed) work.squares -= square(root.size);
  if (a != b)
  {
    Busy& other = islands.busy(std::max(a, b));
    if (other.listed) work.squares -= square(other.size);
    other.root = root.ball;
    std::swap(root.next, other.next);
    root.size += other.size;
  }
  work.squares += square(root.size);
  if (root.listed) return;
  root.listed = true;
  work.roots.push_back(root.ball);
}

// What concerns no ball of another worker; the rest is left over.
void uniteOwn(IslandRecords& islands, IslandWork& work)
{
  work.roots.clear();
  work.apart.clear();
  work.squares = 0;
  eachPrefetched<kAhead>(
      work.met.data(), work.met.size(),
      [&islands](const auto& pair)
      {
        for (const std::uint32_t i : pair) islands.cache.fetchToChange(i);
      },
      [&](const auto& pair)
      {
        const auto [i, k] = pair;
        const bool own_i = islands.claim(work, i), own_k = islands.claim(work, k);
        const std::uint32_t a = own_i && own_k ? rootAmongOwn(islands, work, i) : IslandRecords::kNoEntry;
        const std::uint32_t b = a != IslandRecords::kNoEntry ? rootAmongOwn(islands, work, k) : IslandRecords::kNoEntry;
        if (b == IslandRecords::kNoEntry)
          work.apart.push_back(pair);
        else
          joinAndList(islands, work, a, b);
      });
  work.met.clear();
  const auto joined = [&](std::uint32_t root) { return islands.busy(root).root != root; };
  work.roots.erase(std::remove_if(work.roots.begin(), work.roots.end(), joined), work.roots.end());
}

// At the borders between what is near the balls of one worker and of another.
void uniteOthers(IslandRecords& islands)
{
  std::vector<std::uint32_t>& joined = islands.near;
  joined.clear();
  for (IslandWork& work : islands.work)
    for (const auto& [i, k] : work.apart)
    {
      const std::uint32_t a = rootOf(islands, i), b = rootOf(islands, k);
      if (a != b) joined.push_back(std::max(a, b));
      joinAndList(islands, work, a, b);
    }
  if (joined.empty()) return;
  std::sort(joined.begin(), joined.end());
  const auto isJoined = [&joined](std::uint32_t root)
  { return std::binary_search(joined.begin(), joined.end(), root); };
  for (IslandWork& work : islands.work)
    work.roots.erase(std::remove_if(work.roots.begin(), work.roots.end(), isJoined), work.roots.end());
}
}  // namespace

// Roots are listed in the order of the workers who have found them: those are near each other in the room, and in the cache of
// a core. Nobody but a worker itself, in its turn, changes records of busy balls in its list.
void uniteWhoMet(WorldWithWindows& world)
{
  IslandRecords& islands = world.islands;
  std::size_t pairs = 0;
  for (const IslandWork& work : islands.work) pairs += work.met.size();
  world.workers.each(islands.work.size(), pairs <= kFew ? islands.work.size() : 1,
                     [&](std::size_t begin, std::size_t end, std::size_t)
                     {
                       for (std::size_t l = begin; l < end; ++l) uniteOwn(islands, islands.work[l]);
                     });
  uniteOthers(islands);
}
}  // namespace ping_pong
