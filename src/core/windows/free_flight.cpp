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
  const Glance& glance = world.islands.glances[i];
  switch (world.islands.glances.kindOf(glance).how)
  {
    case GlanceKind::How::Away:
      return false;
    case GlanceKind::How::AskRecord:
      return soonest(world.balls[i]).time <= end;
    case GlanceKind::How::Flies:
    case GlanceKind::How::Lies:
      break;
  }
  return glance.next() <= end && soonest(world.balls[i]).time <= end;
}

// What it sweeps if nothing happens to it.
Box quietBox(const WorldWithWindows& world, const WorkerWindow& window, std::size_t i)
{
  const Glance& glance = world.islands.glances[i];
  const GlanceKind& kind = world.islands.glances.kindOf(glance);
  if (kind.how == GlanceKind::How::Away) return {};
  if (kind.how == GlanceKind::How::AskRecord) return boxAhead(world.balls[i], window.start, window.outlook);
  return boxOf(viewOf(glance, kind), kind.radius, window.start, window.outlook);
}

void runAlone(WorldWithWindows& world, WorkerWindow& window, std::size_t i)
{
  window.count = 1;
  save(world, *window.work, i);
  forgetFlown(world.islands, i);
  window.members = &i;
  runLogged(world, window);
  noteLast(world, window, i);
}

void lookAtPairs(const WorldWithWindows& world, const WorkerWindow& window, const BroadPhase::Pair* pairs,
                 std::size_t count)
{
  for (std::size_t p = 0; p < count; ++p) lookAtPair(world, window, pairs[p][0], pairs[p][1]);
}

// Whose event may be until then.
void takeDue(IslandWork& list, Glances& glances, double end)
{
  list.turn.clear();
  std::size_t kept = 0;
  for (const std::uint32_t i : list.due)
    if (static_cast<double>(glances[i].next()) <= end)
    {
      glances[i].due = false;
      list.turn.push_back(i);
    }
    else
      list.due[kept++] = i;
  list.due.resize(kept);
}

// Whoever has left its path stays in the list.
void runInTurn(WorldWithWindows& world, const WorkerWindow& window, IslandWork& list)
{
  IslandRecords& islands = world.islands;
  std::size_t bent = 0;
  inTurn(
      list.turn.data(), list.turn.size(), [&world](std::uint32_t i) { world.fetch(i); },
      [&](std::uint32_t i)
      {
        if (!hasEvents(world, i, window.end)) return islands.noteDue(list, i);  // later: its time was rounded
        WorkerWindow its = window;
        runAlone(world, its, i);
        if (!islands.glances[i].bent) return;
        islands.announce(*window.work, i);
        list.turn[bent++] = i;
      });
  list.turn.resize(bent);
}
}  // namespace

bool isDue(const IslandRecords& islands, std::size_t i)
{
  return static_cast<double>(islands.glances[i].next()) <= islands.outlook.end;
}

bool seesAhead(const WorldWithWindows& world, double end)
{
  const IslandRecords& islands = world.islands;
  return islands.glances.known(world.edits) && islands.outlook.end >= end;
}

void flyAnew(WorldWithWindows& world, const WorkerWindow& window)
{
  IslandRecords& islands = world.islands;
  BroadPhase& grid = islands.broad_phase;
  const bool ahead = window.outlook > window.end;
  beginOutlook(world, window);
  grid.layOut(world.balls.size(), [&](std::size_t i) { return quietBox(world, window, i); });
  grid.putAll(
      world.workers, [&islands](std::uint32_t i) { islands.glances.fetch(i); },
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
                         islands.glances.fetch(i);
                         islands.glances.fetch(k);
                       };
                       grid.eachPairs(begin, end, fetch,
                                      [&](const BroadPhase::Pair* pairs, std::size_t count)
                                      { lookAtPairs(world, its, pairs, count); });
                     });
}

void flyOn(WorldWithWindows& world, const WorkerWindow& window)
{
  eachList(world, window,
           [](WorldWithWindows& its_world, const WorkerWindow& its, IslandWork& list)
           {
             takeDue(list, its_world.islands.glances, its.end);
             runInTurn(its_world, its, list);
             takeMeetings(list, its_world.islands.glances, its.end);
           });
  world.islands.addToGrid(world.workers);
  eachList(world, window,
           [](WorldWithWindows& its_world, const WorkerWindow& its, const IslandWork& list)
           {
             lookAround(its_world, its, list.turn.data(), list.turn.size());
             lookAtMeetings(its_world, its, list.due_meetings);
           });
}
}  // namespace ping_pong
