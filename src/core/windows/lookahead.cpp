#include "windows/lookahead.h"

#include <algorithm>

#include "windows/encounters.h"
#include "windows/islands.h"
#include "windows/window_state.h"

namespace ping_pong
{
namespace
{
constexpr double kMostChanges = 0.25;  // by ball: additions are in lists, slower to search than the grid
constexpr std::size_t kListed = 8;     // balls for which is listed who is near, before the first one is looked at

bool unchanged(const WorldWithWindows& world, const PredictedContact& contact)
{
  const BallCache& cache = world.islands.cache;
  return cache[contact.first].version == contact.first_version &&
         cache[contact.second].version == contact.second_version;
}

void note(const WorldWithWindows& world, IslandWork& work, std::uint32_t i, std::uint32_t k, double t)
{
  const BallCache& cache = world.islands.cache;
  work.predicted.push_back({floatBefore(t), i, k, cache[i].version, cache[k].version});
}

void noteOutcome(const WorldWithWindows& world, const WorkerWindow& window, IslandWork& work, std::uint32_t i,
                 std::uint32_t k)
{
  const PairOutcome outcome = outcomeOf(world, window, i, k);
  if (outcome.met)
    work.met.push_back({i, k});
  else if (outcome.next <= window.lookahead)
    note(world, work, i, k, outcome.next);
}

// On the paths that they are on: what they did in the window is known.
void noteNext(const WorldWithWindows& world, const WorkerWindow& window, std::uint32_t i, std::uint32_t k)
{
  ++window.work->near_pairs;
  const double t = firstPairContact(world, i, k, window.lookahead);
  if (t <= window.lookahead) note(world, *window.work, i, k, t);
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

void predictNext(const WorldWithWindows& world, const WorkerWindow& window, const std::uint32_t* balls,
                 std::size_t count)
{
  eachNearOf(
      balls, count, world.islands, window.work->near,
      [&](std::uint32_t i) { return boxAhead(world.balls[i], window.end, window.lookahead); },
      [&](std::uint32_t i, std::uint32_t k) { noteNext(world, window, i, k); });
}
}  // namespace

Box boxAhead(const BallRecord& ball, double from, double to)
{
  return boxOf(ball, from, std::max(std::min(to, ball.path.end), from));
}

void beginLookahead(WorldWithWindows& world, const WorkerWindow& window)
{
  IslandRecords& islands = world.islands;
  Lookahead& lookahead = islands.lookahead;
  lookahead.start = window.start;
  lookahead.end = window.lookahead;
  for (IslandWork& work : islands.work)
  {
    work.predicted.clear();
    for (const std::uint32_t i : work.added) islands.cache[i].added = false;
    work.added.clear();
    for (const std::uint32_t i : work.due) islands.cache[i].due = false;
    work.due.clear();
  }
  lookahead.near_pairs = lookahead.pair_searches = lookahead.events = 0;
}

void predictPair(const WorldWithWindows& world, const WorkerWindow& window, std::uint32_t i, std::uint32_t k)
{
  ++window.work->near_pairs;
  noteOutcome(world, window, *window.work, i, k);
}

void predictAround(WorldWithWindows& world, const WorkerWindow& window, const std::uint32_t* balls, std::size_t count)
{
  const IslandRecords& islands = world.islands;
  eachNearOf(
      balls, count, islands, window.work->near,
      [&](std::uint32_t i) -> const CoarseBox& { return islands.busy(i).swept; },
      [&](std::uint32_t i, std::uint32_t k)
      {
        if (!islands.isBusy(k) || islands.busy(k).root != islands.busy(i).root) return predictPair(world, window, i, k);
        if (k < i && islands.busy(k).met) return;  // it looks for this one
        noteNext(world, window, i, k);
      });
}

void takeDueContacts(IslandWork& list, const BallCache& cache, double end)
{
  list.due_contacts.clear();
  std::size_t kept = 0;
  for (const PredictedContact& contact : list.predicted)
  {
    if (static_cast<double>(contact.time) > end)
    {
      list.predicted[kept++] = contact;
      continue;
    }
    list.due_contacts.push_back(contact);
    cache.fetchToChange(contact.first);
    cache.fetchToChange(contact.second);
  }
  list.predicted.resize(kept);
}

// It may be later: the time was rounded, or the search for it had ended without an answer.
void checkDueContacts(const WorldWithWindows& world, const WorkerWindow& window,
                      const std::vector<PredictedContact>& predicted)
{
  for (const PredictedContact& contact : predicted)
    if (unchanged(world, contact)) noteOutcome(world, window, *window.work, contact.first, contact.second);
}

// A ball that was in an island, but has not been hit, was thought to have met another: what comes after that is not predicted.
void predictUnhit(WorldWithWindows& world, const WorkerWindow& window, const IslandWork& list)
{
  std::vector<std::uint32_t>& unhit = window.work->deflected;
  unhit.clear();
  for (const IslandWork::Busy& busy : list.busy)
    if (busy.run > 0 && !busy.met && !world.islands.cache.away(busy.ball)) unhit.push_back(busy.ball);
  predictNext(world, window, unhit.data(), unhit.size());
}

void endIfManyChanged(WorldWithWindows& world, const WorkerWindow& window)
{
  std::size_t added = 0;
  for (const IslandWork& work : world.islands.work) added += work.added.size();
  if (static_cast<double>(added) > kMostChanges * static_cast<double>(world.balls.size()))
    world.islands.lookahead.end = window.end;
}
}  // namespace ping_pong
