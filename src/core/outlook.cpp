#include "outlook.h"

#include <algorithm>

#include "exact_method.h"
#include "flown.h"

namespace ping_pong
{
namespace
{
constexpr std::size_t kBalls = 64;     // that a worker takes at a time
constexpr double kMostChanges = 0.25;  // by ball: then it is time for a new grid

bool unchanged(const WorldState& world, const Meeting& meeting)
{
  return world.balls[meeting.first].version == meeting.first_version &&
         world.balls[meeting.second].version == meeting.second_version;
}

void push(Outlook& outlook, const Meeting& meeting)
{
  outlook.meetings.push_back(meeting);
  std::push_heap(outlook.meetings.begin(), outlook.meetings.end());
}

void gather(IslandRecords& islands)
{
  for (IslandWork& work : islands.work)
  {
    for (const Meeting& meeting : work.meetings) push(islands.outlook, meeting);
    work.meetings.clear();
  }
}

void lookAround(const WorldState& world, const Window& window, IslandWork& work, std::uint32_t i)
{
  const IslandRecords& islands = world.islands;
  islands.eachNear(i,
                   [&](std::uint32_t k)
                   {
                     if (k < i && islands.saved_at[k] != IslandRecords::kNoEntry) return;  // it looks for this one
                     ++work.near_pairs;
                     noteMeeting(world, window, work, i, k);
                   });
}
}  // namespace

Box boxAhead(const BallRecord& ball, double from, double to)
{
  return boxOf(ball, from, std::max(std::min(to, ball.path.end), from));
}

void beginOutlook(WorldState& world, const Window& window)
{
  Outlook& outlook = world.islands.outlook;
  outlook.start = window.start;
  outlook.end = window.outlook;
  outlook.meetings.clear();
  for (IslandWork& work : world.islands.work) work.meetings.clear();
  outlook.changes = outlook.near_pairs = outlook.pair_searches = outlook.events = 0;
}

void noteMeeting(const WorldState& world, const Window& window, IslandWork& work, std::uint32_t i, std::uint32_t k)
{
  const double t = firstMeeting(world, i, k, window.outlook);
  if (!(t <= window.outlook)) return;
  work.meetings.push_back({floatBefore(t), i, k, world.balls[i].version, world.balls[k].version});
}

void takeMeetings(WorldState& world, const Window& window)
{
  IslandRecords& islands = world.islands;
  std::vector<Meeting>& heap = islands.outlook.meetings;
  std::vector<Meeting>& later = islands.work.front().meetings;
  for (; !heap.empty() && static_cast<double>(heap.front().time) <= window.end; heap.pop_back())
  {
    std::pop_heap(heap.begin(), heap.end());
    const Meeting meeting = heap.back();
    if (!unchanged(world, meeting)) continue;
    if (metInFlight(world, window, meeting.first, meeting.second))
      islands.work.front().met.push_back({meeting.first, meeting.second});
    else
      later.push_back(meeting);
  }
  // The time was rounded, or the search for it had ended without an answer.
  std::size_t kept = 0;
  for (const Meeting& meeting : later)
  {
    const double t = firstMeeting(world, meeting.first, meeting.second, window.outlook);
    if (!(t <= window.outlook)) continue;
    later[kept] = meeting;
    later[kept++].time = floatBefore(t);
  }
  later.resize(kept);
  gather(islands);
}

void lookAhead(WorldState& world, const Window& window)
{
  IslandRecords& islands = world.islands;
  std::vector<std::uint32_t>& changed = islands.near;
  changed.clear();
  for (const IslandWork& work : islands.work)
    for (const std::uint32_t i : work.changed)
    {
      const bool away = world.balls[i].away();
      islands.swept[i] = away ? CoarseBox() : CoarseBox(boxAhead(world.balls[i], window.end, window.outlook));
      if (away) continue;
      islands.broad_phase.add(i, islands.swept[i]);
      changed.push_back(i);
    }
  world.workers.each(changed.size(), kBalls,
                     [&](std::size_t begin, std::size_t end, std::size_t worker)
                     {
                       for (std::size_t c = begin; c < end; ++c) lookAround(world, window, islands.work[worker], changed[c]);
                     });
  gather(islands);
  islands.outlook.changes += changed.size();
  if (static_cast<double>(islands.outlook.changes) > kMostChanges * static_cast<double>(world.balls.size()))
    islands.outlook.end = window.end;
}
}  // namespace ping_pong
