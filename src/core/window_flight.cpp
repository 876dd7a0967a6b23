#include "window_flight.h"

#include <algorithm>

#include "flown.h"
#include "island_runs.h"

namespace ping_pong
{
namespace
{
constexpr std::size_t kBalls = 256;  // that a worker takes at a time

bool hasEvents(const WorldState& world, std::size_t i, double end)
{
  const Glance& glance = world.islands.glances[i];
  switch (world.islands.glances.kindOf(glance).how)
  {
    case GlanceKind::How::Away:
      return false;
    case GlanceKind::How::AskRecord:
      return soonest(world.balls[i]).time <= end;
    default:
      return glance.next <= end && soonest(world.balls[i]).time <= end;
  }
}

// What it sweeps if nothing happens to it.
Box quietBox(const WorldState& world, const Window& window, std::size_t i)
{
  const Glance& glance = world.islands.glances[i];
  const GlanceKind& kind = world.islands.glances.kindOf(glance);
  if (kind.how == GlanceKind::How::Away) return {};
  if (kind.how == GlanceKind::How::AskRecord) return boxAhead(world.balls[i], window.start, window.outlook);
  return boxOf(viewOf(glance, kind), kind.radius, window.start, window.outlook);
}

void runAlone(WorldState& world, Window& window, std::size_t i)
{
  window.count = 1;
  save(world, *window.work, i);
  forgetFlown(world.islands, i);
  window.members = &i;
  runTogether(world, window);
  noteLast(world, window, i);
}

// Calls action(ball, its window) for all balls.
template <class Action>
void eachBall(WorldState& world, const Window& window, const Action& action)
{
  world.workers.each(world.balls.size(), kBalls,
                     [&](std::size_t begin, std::size_t end, std::size_t worker)
                     {
                       Window its = ofWorker(world, window, worker);
                       for (std::size_t i = begin; i < end; ++i) action(static_cast<std::uint32_t>(i), its);
                     });
}

void lookAtPairs(const WorldState& world, const Window& window, const BroadPhase::Pair* pairs, std::size_t count)
{
  for (std::size_t p = 0; p < count; ++p) lookAtPair(world, window, pairs[p][0], pairs[p][1]);
}

void gatherDue(IslandRecords& islands)
{
  islands.due.clear();
  for (IslandWork& work : islands.work)
  {
    islands.due.insert(islands.due.end(), work.due.begin(), work.due.end());
    work.due.clear();
  }
}

// Those whose event may be until then, each once.
void takeDue(WorldState& world, double end, std::vector<std::uint32_t>& list)
{
  IslandRecords& islands = world.islands;
  list.clear();
  std::size_t kept = 0;
  for (const std::uint32_t i : islands.due)
    if (static_cast<double>(islands.glances[i].next) <= end)
      list.push_back(i);
    else
      islands.due[kept++] = i;
  islands.due.resize(kept);
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}
}  // namespace

bool isDue(const IslandRecords& islands, std::size_t i)
{
  return static_cast<double>(islands.glances[i].next) <= islands.outlook.end;
}

bool seesAhead(const IslandRecords& islands, double end)
{
  return islands.glances.known() && islands.outlook.end >= end;
}

void flyAnew(WorldState& world, const Window& window)
{
  IslandRecords& islands = world.islands;
  BroadPhase& grid = islands.broad_phase;
  const bool ahead = window.outlook > window.end;
  beginOutlook(world, window);
  grid.layOut(world.balls.size(), [&](std::size_t i) { return quietBox(world, window, i); });
  eachBall(world, window,
           [&](std::uint32_t i, Window& its)
           {
             if (hasEvents(world, i, window.end))
             {
               runAlone(world, its, i);
               grid.put(i, islands.busy(i).swept);
             }
             else
             {
               grid.put(i, quietBox(world, window, i));
               if (ahead && isDue(islands, i)) its.work->due.push_back(i);
             }
           });
  grid.sort();
  gatherDue(islands);
  world.workers.each(grid.boxes(), kBalls,
                     [&](std::size_t begin, std::size_t end, std::size_t worker)
                     {
                       const Window its = ofWorker(world, window, worker);
                       const auto fetch = [&](std::uint32_t i, std::uint32_t k)
                       {
                         islands.glances.fetch(i);
                         islands.glances.fetch(k);
                       };
                       grid.eachPairs(begin, end, fetch, [&](const BroadPhase::Pair* pairs, std::size_t count)
                                      { lookAtPairs(world, its, pairs, count); });
                     });
}

void flyOn(WorldState& world, const Window& window)
{
  IslandRecords& islands = world.islands;
  std::vector<std::uint32_t>& list = islands.near;
  takeDue(world, window.end, list);
  eachOf(list, world, window, [](const WorldState& its_world, std::uint32_t i) { its_world.fetch(i); },
         [](WorldState& its_world, Window its, std::uint32_t i)
         {
           if (hasEvents(its_world, i, its.end)) runAlone(its_world, its, i);
         });
  std::size_t bent = 0;
  for (const std::uint32_t i : list)
  {
    if (!islands.isBusy(i)) islands.due.push_back(i);  // later: its time was rounded
    if (!islands.glances[i].bent) continue;
    islands.addToGrid(i);
    list[bent++] = i;
  }
  list.resize(bent);
  partsOf(list, world, window, lookAround);
  takeMeetings(world, window);
}
}  // namespace ping_pong
