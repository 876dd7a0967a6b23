#include "windows/islands.h"

#include <algorithm>

#include "events/predict.h"
#include "windows/encounters.h"
#include "windows/solver_handover.h"
#include "windows/union_find.h"

namespace ping_pong
{
namespace
{
void listMembers(IslandRecords& islands, std::uint32_t root, std::vector<std::size_t>& members)
{
  members.clear();
  std::uint32_t i = root;
  do
  {
    members.push_back(i);
    islands.busy(i).root = root;
    i = islands.busy(i).next;
  } while (i != root);
  std::sort(members.begin(), members.end());  // ties go to the first ball, in whatever order they came in
}

void backToStart(WorldWithWindows& world, IslandWork& work, std::size_t i)
{
  IslandRecords& islands = world.islands;
  IslandWork::Busy& busy = islands.busy(i);
  if (busy.saved == IslandRecords::kNoEntry)
    save(world, work, i);
  else
    world.balls[i] = islands.saved(busy.saved);
  clearFlightLog(islands, i);
  busy.run = islands.runs;
  busy.met = busy.listed = false;
}

// Event by event, from the start of the window. Nobody outside is looked at.
void runIsland(WorldWithWindows& world, WorkerWindow window, std::uint32_t root)
{
  IslandWork& work = *window.work;
  const std::vector<std::size_t>& members = work.members;
  listMembers(world.islands, root, work.members);
  work.run = world.islands.runs;
  for (const std::size_t i : members) backToStart(world, work, i);
  for (std::size_t m = 0; m < members.size(); ++m)
    for (std::size_t n = m + 1; n < members.size(); ++n)
      predictBall(world, members[m], members[n], -kNever, window.end, work);
  window.members = members.data();
  window.count = members.size();
  window.most_events = mostEvents(world, members);
  if (!runLogged(world, window)) work.to_hand_off.insert(work.to_hand_off.end(), members.begin(), members.end());
  work.run = 0;
  for (const std::size_t i : members)
  {
    world.balls[i].expectNoBall();
    noteLast(world, window, i);
    if (world.islands.busy(i).met) world.islands.deferInsertion(work, static_cast<std::uint32_t>(i));
  }
}

// Inlined: of a function that only fetches, GCC sees no effect, and drops its calls.
[[gnu::always_inline]] inline void fetchIsland(const WorldWithWindows& world, std::uint32_t root)
{
  world.fetch(root);
  world.fetch(world.islands.busy(root).next);
}

void runIslandParts(WorldWithWindows& world, const WorkerWindow& window, const std::uint32_t* roots, std::size_t count)
{
  eachPrefetched(
      roots, count, [&world](std::uint32_t root) { fetchIsland(world, root); },
      [&](std::uint32_t root) { runIsland(world, window, root); });
}

// Calls action(ball) for each that was hit.
template <class Action>
void eachDeflected(const WorldWithWindows& world, std::uint32_t root, const Action& action)
{
  const IslandRecords& islands = world.islands;
  for (std::uint32_t i = islands.busy(root).next;;)
  {
    const IslandWork::Busy& busy = islands.busy(i);
    if (busy.met) action(i);
    if (i == root) return;
    i = busy.next;
  }
}

// Balls that were thrown off their path may come into the way of balls outside, islands of the same run among them.
void findWhoWasMet(WorldWithWindows& world, const WorkerWindow& window, const std::uint32_t* roots, std::size_t count)
{
  std::vector<std::uint32_t>& deflected = window.work->deflected;
  deflected.clear();
  for (std::size_t r = 0; r < count; ++r)
    eachDeflected(world, roots[r], [&deflected](std::uint32_t i) { deflected.push_back(i); });
  predictAround(world, window, deflected.data(), deflected.size());
}

// Calls action(world, its window, roots, how many) for parts of the lists of islands that have to run, those of a worker by
// itself, as a rule.
template <class Action>
void eachIsland(WorldWithWindows& world, const WorkerWindow& window, const Action& action)
{
  constexpr std::size_t kAtATime = 4;
  IslandRecords& islands = world.islands;
  islands.ends.clear();
  std::size_t count = 0;
  for (const IslandWork& list : islands.work) islands.ends.push_back(count += list.roots.size());
  world.workers.eachOfShares(islands.ends, kAtATime,
                             [&](std::size_t begin, std::size_t end, std::size_t worker)
                             {
                               for (std::size_t l = 0, first = 0; l < islands.work.size(); first = islands.ends[l++])
                               {
                                 const std::size_t from = std::max(begin, first), to = std::min(end, islands.ends[l]);
                                 const std::uint32_t* roots = islands.work[l].roots.data();
                                 if (from < to)
                                   action(world, ofWorker(world, window, worker), roots + (from - first), to - from);
                               }
                             });
}
}  // namespace

void save(WorldWithWindows& world, IslandWork& work, std::size_t i)
{
  std::uint32_t& saved = world.islands.makeBusy(work, i).saved;
  if (saved != IslandRecords::kNoEntry) return;
  saved = IslandRecords::entry(work, work.saved.size());
  work.saved.push_back(world.balls[i]);
}

void runIslandsOnce(WorldWithWindows& world, const WorkerWindow& window)
{
  IslandRecords& islands = world.islands;
  ++islands.runs;
  eachIsland(world, window, runIslandParts);
  islands.addToGrid(world.workers);
  eachIsland(world, window, findWhoWasMet);
  uniteWhoMet(world);
}
}  // namespace ping_pong
