#include "windows/lookahead.h"

#include <algorithm>

#include "windows/encounters.h"
#include "windows/islands.h"
#include "windows/window_state.h"

namespace ping_pong
{
namespace
{
constexpr double kMostChanges = 0.25;  // by ball: then it is time for a new grid
constexpr std::size_t kListed = 8;     // balls for which is listed who is near, before the first one is looked at

bool unchanged(const WorldWithWindows& world, const Meeting& meeting)
{
  const Glances& glances = world.islands.glances;
  return glances[meeting.first].version == meeting.first_version &&
         glances[meeting.second].version == meeting.second_version;
}

void note(const WorldWithWindows& world, IslandWork& work, std::uint32_t i, std::uint32_t k, double t)
{
  const Glances& glances = world.islands.glances;
  work.meetings.push_back({floatBefore(t), i, k, glances[i].version, glances[k].version});
}

void noteEncounter(const WorldWithWindows& world, const WorkerWindow& window, IslandWork& work, std::uint32_t i,
                   std::uint32_t k)
{
  const Encounter encounter = encounterOf(world, window, i, k);
  if (encounter.met)
    work.met.push_back({i, k});
  else if (encounter.next <= window.outlook)
    note(world, work, i, k, encounter.next);
}

// On the paths that they are on: what they did in the window is known.
void noteNext(const WorldWithWindows& world, const WorkerWindow& window, std::uint32_t i, std::uint32_t k)
{
  ++window.work->near_pairs;
  const double t = firstMeeting(world, i, k, window.outlook);
  if (t <= window.outlook) note(world, *window.work, i, k, t);
}

// Calls action(i, k) for each of these balls i and every other ball k whose box overlaps box(i); for some k twice.
template <class BoxOfBall, class Action>
void eachNearOf(const std::uint32_t* balls, std::size_t count, const IslandRecords& islands, NearList& near,
                const BoxOfBall& box, const Action& action)
{
  for (std::size_t begin = 0; begin < count; begin += kListed)
  {
    const std::size_t end = std::min(begin + kListed, count);
    near.clear();
    for (std::size_t b = begin; b < end; ++b) islands.listNear(box(balls[b]), near);
    for (std::size_t b = begin; b < end; ++b)
      islands.eachNear(balls[b], near, b - begin, [&](std::uint32_t k) { action(balls[b], k); });
  }
}

void lookForNext(const WorldWithWindows& world, const WorkerWindow& window, const std::uint32_t* balls,
                 std::size_t count)
{
  eachNearOf(
      balls, count, world.islands, window.work->near,
      [&](std::uint32_t i) { return boxAhead(world.balls[i], window.end, window.outlook); },
      [&](std::uint32_t i, std::uint32_t k) { noteNext(world, window, i, k); });
}
}  // namespace

Box boxAhead(const BallRecord& ball, double from, double to)
{
  return boxOf(ball, from, std::max(std::min(to, ball.path.end), from));
}

void beginOutlook(WorldWithWindows& world, const WorkerWindow& window)
{
  IslandRecords& islands = world.islands;
  Outlook& outlook = islands.outlook;
  outlook.start = window.start;
  outlook.end = window.outlook;
  for (IslandWork& work : islands.work)
  {
    work.meetings.clear();
    for (const std::uint32_t i : work.added) islands.glances[i].added = false;
    work.added.clear();
    for (const std::uint32_t i : work.due) islands.glances[i].due = false;
    work.due.clear();
  }
  outlook.near_pairs = outlook.pair_searches = outlook.events = 0;
}

void lookAtPair(const WorldWithWindows& world, const WorkerWindow& window, std::uint32_t i, std::uint32_t k)
{
  ++window.work->near_pairs;
  noteEncounter(world, window, *window.work, i, k);
}

void lookAround(WorldWithWindows& world, const WorkerWindow& window, const std::uint32_t* balls, std::size_t count)
{
  const IslandRecords& islands = world.islands;
  eachNearOf(
      balls, count, islands, window.work->near,
      [&](std::uint32_t i) -> const CoarseBox& { return islands.busy(i).swept; },
      [&](std::uint32_t i, std::uint32_t k)
      {
        if (!islands.isBusy(k) || islands.busy(k).root != islands.busy(i).root) return lookAtPair(world, window, i, k);
        if (k < i && islands.busy(k).met) return;  // it looks for this one
        noteNext(world, window, i, k);
      });
}

void takeMeetings(IslandWork& list, const Glances& glances, double end)
{
  list.due_meetings.clear();
  std::size_t kept = 0;
  for (const Meeting& meeting : list.meetings)
  {
    if (static_cast<double>(meeting.time) > end)
    {
      list.meetings[kept++] = meeting;
      continue;
    }
    list.due_meetings.push_back(meeting);
    glances.fetchToChange(meeting.first);
    glances.fetchToChange(meeting.second);
  }
  list.meetings.resize(kept);
}

// It may be later: the time was rounded, or the search for it had ended without an answer.
void lookAtMeetings(const WorldWithWindows& world, const WorkerWindow& window, const std::vector<Meeting>& meetings)
{
  for (const Meeting& meeting : meetings)
    if (unchanged(world, meeting)) noteEncounter(world, window, *window.work, meeting.first, meeting.second);
}

// Whoever was in an island, but has not been hit, was thought to have met someone: what comes after that has not been looked for.
void lookAhead(WorldWithWindows& world, const WorkerWindow& window, const IslandWork& list)
{
  std::vector<std::uint32_t>& unhit = window.work->thrown;
  unhit.clear();
  for (const IslandWork::Busy& busy : list.busy)
    if (busy.run > 0 && !busy.met && !world.islands.glances.away(busy.ball)) unhit.push_back(busy.ball);
  lookForNext(world, window, unhit.data(), unhit.size());
}

void endIfManyChanged(WorldWithWindows& world, const WorkerWindow& window)
{
  std::size_t added = 0;
  for (const IslandWork& work : world.islands.work) added += work.added.size();
  if (static_cast<double>(added) > kMostChanges * static_cast<double>(world.balls.size()))
    world.islands.outlook.end = window.end;
}
}  // namespace ping_pong
