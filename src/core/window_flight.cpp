#include "window_flight.h"

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
CoarseBox quietBox(const WorldState& world, const Window& window, std::size_t i)
{
  const Glance& glance = world.islands.glances[i];
  const GlanceKind& kind = world.islands.glances.kindOf(glance);
  if (kind.how == GlanceKind::How::Away) return {};
  if (kind.how == GlanceKind::How::AskRecord) return CoarseBox(boxAhead(world.balls[i], window.start, window.outlook));
  return CoarseBox(boxOf(viewOf(glance, kind), kind.radius, window.start, window.outlook));
}

void runAlone(WorldState& world, Window& window, std::size_t i)
{
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
                       its.count = 1;
                       for (std::size_t i = begin; i < end; ++i) action(i, its);
                     });
}
}  // namespace

bool seesAhead(const IslandRecords& islands, double end)
{
  return islands.glances.known() && islands.outlook.end >= end;
}

void flyAnew(WorldState& world, const Window& window)
{
  IslandRecords& islands = world.islands;
  const bool ahead = window.outlook > window.end;
  beginOutlook(world, window);
  eachBall(world, window,
           [&](std::size_t i, Window& its)
           {
             if (hasEvents(world, i, window.end))
               runAlone(world, its, i);
             else
               islands.swept[i] = quietBox(world, window, i);
           });
  islands.broad_phase.build(islands.swept, world.workers);
  world.workers.each(islands.broad_phase.boxes(), kBalls,
                     [&](std::size_t begin, std::size_t end, std::size_t worker)
                     {
                       IslandWork& its = islands.work[worker];
                       islands.broad_phase.eachPair(begin, end, islands.swept,
                                                    [&](std::uint32_t a, std::uint32_t b)
                                                    {
                                                      ++its.near_pairs;
                                                      if (metInFlight(world, window, a, b))
                                                        its.met.push_back({a, b});
                                                      else if (ahead)
                                                        noteMeeting(world, window, its, a, b);
                                                    });
                     });
}

void flyOn(WorldState& world, const Window& window)
{
  IslandRecords& islands = world.islands;
  eachBall(world, window,
           [&](std::size_t i, Window& its)
           {
             if (hasEvents(world, i, window.end)) runAlone(world, its, i);
           });
  std::vector<std::uint32_t>& bent = islands.near;
  bent.clear();
  for (const IslandWork& work : islands.work)
    for (const std::uint32_t i : work.changed)
      if (islands.glances[i].bent) bent.push_back(i);
  for (const std::uint32_t i : bent) islands.broad_phase.add(i, islands.swept[i]);
  eachOf(bent, world, window, findWhoWasMetBy);
  takeMeetings(world, window);
}
}  // namespace ping_pong
