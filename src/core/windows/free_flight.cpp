#include "windows/free_flight.h"

#include <algorithm>

#include "windows/encounters.h"
#include "windows/islands.h"

namespace ping_pong
{
namespace
{
constexpr std::size_t kBoxes = 256;  // that a worker takes at a time

bool hasEvents(const WorldWithWindows& world, std::size_t i, double end)
{
  const CachedBall& cached = world.islands.cache[i];
  switch (world.islands.cache.typeOf(cached).how)
  {
    case CachedType::How::Away:
      return false;
    case CachedType::How::AskRecord:
      return nextEvent(world.balls[i]).time <= end;
    case CachedType::How::Flies:
    case CachedType::How::Lies:
      break;
  }
  return cached.next() <= end && nextEvent(world.balls[i]).time <= end;
}

// What it sweeps if nothing happens to it.
Box quietBox(const WorldWithWindows& world, const WorkerWindow& window, std::size_t i)
{
  const CachedBall& cached = world.islands.cache[i];
  const CachedType& type = world.islands.cache.typeOf(cached);
  if (type.how == CachedType::How::Away) return {};
  if (type.how == CachedType::How::AskRecord) return boxAhead(world.balls[i], window.start, window.lookahead);
  return boxOf(viewOf(cached, type), type.radius, window.start, window.lookahead);
}

void runAlone(WorldWithWindows& world, WorkerWindow& window, std::size_t i)
{
  window.count = 1;
  save(world, *window.work, i);
  clearFlightLog(world.islands, i);
  window.members = &i;
  runLogged(world, window);
  noteLast(world, window, i);
}

void predictPairs(const WorldWithWindows& world, const WorkerWindow& window, const BroadPhase::Pair* pairs,
                  std::size_t count)
{
  for (std::size_t p = 0; p < count; ++p) predictPair(world, window, pairs[p][0], pairs[p][1]);
}

// Whose event may be until then.
void takeDue(IslandWork& list, BallCache& cache, double end)
{
  list.due_now.clear();
  std::size_t kept = 0;
  for (const std::uint32_t i : list.due)
    if (static_cast<double>(cache[i].next()) <= end)
    {
      cache[i].due = false;
      list.due_now.push_back(i);
    }
    else
      list.due[kept++] = i;
  list.due.resize(kept);
}

// Balls that have left their paths stay in the list.
void runDue(WorldWithWindows& world, const WorkerWindow& window, IslandWork& list)
{
  IslandRecords& islands = world.islands;
  std::size_t left_path = 0;
  eachPrefetched(
      list.due_now.data(), list.due_now.size(), [&world](std::uint32_t i) { world.fetch(i); },
      [&](std::uint32_t i)
      {
        if (!hasEvents(world, i, window.end)) return islands.noteDue(list, i);  // later: its time was rounded
        WorkerWindow its = window;
        runAlone(world, its, i);
        if (!islands.cache[i].left_path) return;
        islands.deferInsertion(*window.work, i);
        list.due_now[left_path++] = i;
      });
  list.due_now.resize(left_path);
}
}  // namespace

bool isDue(const IslandRecords& islands, std::size_t i)
{
  return static_cast<double>(islands.cache[i].next()) <= islands.lookahead.end;
}

bool seesAhead(const WorldWithWindows& world, double end)
{
  const IslandRecords& islands = world.islands;
  return islands.cache.known(world.edits) && islands.lookahead.end >= end;
}

void flyAll(WorldWithWindows& world, const WorkerWindow& window)
{
  IslandRecords& islands = world.islands;
  BroadPhase& grid = islands.broad_phase;
  const bool ahead = window.lookahead > window.end;
  beginLookahead(world, window);
  grid.layOut(world.balls.size(), [&](std::size_t i) { return quietBox(world, window, i); });
  grid.putAll(
      world.workers, [&islands](std::uint32_t i) { islands.cache.fetch(i); },
      [&](std::size_t place, std::uint32_t i, std::size_t worker)
      {
        if (!hasEvents(world, i, window.end))
        {
          grid.put(place, quietBox(world, window, i));
          if (ahead && isDue(islands, i)) islands.noteDue(islands.work[worker], i);
          return;
        }
        WorkerWindow its = ofWorker(world, window, worker);
        runAlone(world, its, i);
        grid.put(place, islands.busy(i).swept);
      });
  grid.sort(world.workers);
  world.workers.each(grid.boxes(), kBoxes,
                     [&](std::size_t begin, std::size_t end, std::size_t worker)
                     {
                       const WorkerWindow its = ofWorker(world, window, worker);
                       const auto fetch = [&](std::uint32_t i, std::uint32_t k)
                       {
                         islands.cache.fetch(i);
                         islands.cache.fetch(k);
                       };
                       grid.eachPairs(begin, end, fetch,
                                      [&](const BroadPhase::Pair* pairs, std::size_t count)
                                      { predictPairs(world, its, pairs, count); });
                     });
}

void flyDue(WorldWithWindows& world, const WorkerWindow& window)
{
  eachList(world, window,
           [](WorldWithWindows& its_world, const WorkerWindow& its, IslandWork& list)
           {
             takeDue(list, its_world.islands.cache, its.end);
             runDue(its_world, its, list);
             takeDueContacts(list, its_world.islands.cache, its.end);
           });
  world.islands.addToGrid(world.workers);
  eachList(world, window,
           [](WorldWithWindows& its_world, const WorkerWindow& its, const IslandWork& list)
           {
             predictAround(its_world, its, list.due_now.data(), list.due_now.size());
             checkDueContacts(its_world, its, list.due_contacts);
           });
}
}  // namespace ping_pong
