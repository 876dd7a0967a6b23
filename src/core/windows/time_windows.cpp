#include "windows/time_windows.h"

#include <algorithm>
#include <cmath>

#include "windows/free_flight.h"
#include "windows/islands.h"
#include "windows/solver_handover.h"
#include "windows/union_find.h"
#include "windows/window_contacts.h"

namespace ping_pong
{
namespace
{
constexpr double kTooManySearches = 4.0;  // of pairs, by ball: a window that needs more is given up
constexpr double kWindowsAhead = 1.5;     // that are worth a lookahead: below, its lists cost more than a grid

// A look at two boxes that overlap costs an eighth of a search.
double pairSearches(const IslandRecords& islands)
{
  std::size_t eighths = 0;
  for (const IslandWork& work : islands.work) eighths += 8 * work.pair_searches + work.near_pairs;
  return 0.125 * static_cast<double>(eighths);
}

// Whatever has been done to the balls.
void startAnew(WorldWithWindows& world)
{
  IslandRecords& islands = world.islands;
  islands.cache.readAll(world.balls, world.edits);
  for (IslandWork& work : islands.work)  // of a cache that is void
  {
    work.added.clear();
    work.due.clear();
  }
}

// As they were before this window, for those that are not.
void forgetIslands(IslandRecords& islands, IslandWork& list, bool ahead)
{
  for (const IslandWork::Busy& busy : list.busy)
  {
    const std::uint32_t i = busy.ball;
    CachedBall& cached = islands.cache[i];
    cached.setNext(busy.next_event);
    cached.busy = cached.left_path = false;
    if (ahead && isDue(islands, i)) islands.noteDue(list, i);
  }
}

void begin(WorldWithWindows& world)
{
  IslandRecords& islands = world.islands;
  if (!islands.cache.known(world.edits)) startAnew(world);
  islands.runs = 0;
  for (IslandWork& work : islands.work)
  {
    work.keep_contacts = world.keep_contacts;
    work.contacts.clear();
    work.provenances.clear();
    work.status = StepStatus();
    work.pair_searches = work.near_pairs = 0;
    work.frequent_contacts = work.any_squeezed = false;
    work.saved.clear();
    work.busy.clear();
    work.pieces.clear();
    work.met.clear();
    work.roots.clear();
    work.squares = 0;
    work.to_hand_off.clear();
  }
  islands.first_contact = world.provenances.size();
  lendContacts(world);
}

// Each looks at each in an island.
bool worthAShorterWindow(const WorldWithWindows& world, const WorkerWindow& window)
{
  const IslandRecords& islands = world.islands;
  if (!(window.end - window.start > 1.5001 * WindowLength::kShortest))
    return false;  // the next try would be as long: see runIslands()
  const double limit = kTooManySearches * static_cast<double>(world.balls.size()) + kTooManySearches * kTooManySearches;
  std::size_t squares = 0;
  for (const IslandWork& work : islands.work) squares += work.squares;
  return pairSearches(islands) + static_cast<double>(squares) > limit;
}

// As if the window had never begun.
void undo(WorldWithWindows& world)
{
  IslandRecords& islands = world.islands;
  lendContacts(world);  // and back
  world.provenances.resize(islands.first_contact);
  if (world.keep_contacts) world.contacts.resize(islands.first_contact);
  for (const IslandWork& work : islands.work)
    for (const IslandWork::Busy& busy : work.busy)
      if (busy.saved != IslandRecords::kNoEntry) world.balls[busy.ball] = islands.saved(busy.saved);
  ++world.edits;
}

// Hands off the balls of islands with events without end; false if there are none.
bool handOffFrequent(WorldWithWindows& world, double start)
{
  std::vector<std::uint32_t>& to_hand_off = world.islands.near;
  to_hand_off.clear();
  for (const IslandWork& work : world.islands.work)
    to_hand_off.insert(to_hand_off.end(), work.to_hand_off.begin(), work.to_hand_off.end());
  if (to_hand_off.empty()) return false;
  std::sort(to_hand_off.begin(), to_hand_off.end());
  undo(world);
  handToSolver(world, to_hand_off, start);
  return true;
}

void endWindow(WorldWithWindows& world, const WorkerWindow& window)
{
  const bool ahead = window.lookahead > window.end;
  eachList(world, window,
           [ahead](WorldWithWindows& its_world, const WorkerWindow& its, IslandWork& list)
           {
             dropVoidContacts(its_world, list);
             if (ahead) predictUnhit(its_world, its, list);
           });
  takeContacts(world);
  if (ahead) endIfManyChanged(world, window);
  eachList(world, window,
           [ahead](WorldWithWindows& its_world, const WorkerWindow&, IslandWork& list)
           { forgetIslands(its_world.islands, list, ahead); });
}

enum class Outcome
{
  Done,
  TooLong,   ///< nothing was done: the window has to be shorter
  HandedOff  ///< nothing was done but that balls have gone to the solver
};

Outcome runWindow(WorldWithWindows& world, const WorkerWindow& window)
{
  IslandRecords& islands = world.islands;
  const bool seen_ahead = seesAhead(world, window.end);
  begin(world);
  if (seen_ahead)
    flyDue(world, window);
  else
    flyAll(world, window);
  for (uniteWhoMet(world); islands.islandsToRun() > 0; runIslandsOnce(world, window))
  {
    if (handOffFrequent(world, window.start)) return Outcome::HandedOff;
    if (!worthAShorterWindow(world, window)) continue;
    undo(world);
    return Outcome::TooLong;
  }
  if (handOffFrequent(world, window.start)) return Outcome::HandedOff;
  endWindow(world, window);
  return Outcome::Done;
}

// What was tried in vain counts, too.
void sumUp(WorldWithWindows& world)
{
  for (const IslandWork& work : world.islands.work)
  {
    world.status.events += work.status.events;
    world.status.event_limit |= work.status.event_limit;
    world.frequent_contacts |= work.frequent_contacts;
    world.any_squeezed |= work.any_squeezed;
  }
}

std::size_t busyBalls(const IslandRecords& islands)
{
  std::size_t busy = 0;
  for (const IslandWork& work : islands.work) busy += work.busy.size();
  return busy;
}

// Windows share what is left of the tick.
double endInTick(const IslandRecords& islands, double start, double end)
{
  const double windows = islands.length.countIn(end - start);
  return windows > 1.0 ? start + (end - start) / windows : end;
}

// Where windows are short because ticks are, one looks ahead: but not if someone changes balls or paddles in every tick.
double endOfLookahead(const WorldWithWindows& world, double start, double window_end)
{
  const IslandRecords& islands = world.islands;
  if (seesAhead(world, window_end)) return islands.lookahead.end;
  const bool ahead = islands.cache.known(world.edits) && islands.length.next() >= kWindowsAhead * (window_end - start);
  return ahead ? start + islands.length.next() : window_end;
}

// If the lookahead does not hold for another window like this one, it ends here. Whether its length was right is known then.
void endLookahead(WorldWithWindows& world, const WorkerWindow& window)
{
  IslandRecords& islands = world.islands;
  Lookahead& lookahead = islands.lookahead;
  for (const IslandWork& work : islands.work)
  {
    lookahead.near_pairs += work.near_pairs;
    lookahead.pair_searches += work.pair_searches;
    lookahead.events += work.status.events;
  }
  const bool cut = window.lookahead > window.end && lookahead.end <= window.end;
  if (lookahead.end - window.end > 0.999 * (window.end - window.start)) return;
  const double n = static_cast<double>(world.balls.size());
  const double length = window.end - lookahead.start;
  if (cut) islands.length.cutTo(length);
  const auto byBall = [n](std::size_t count) { return static_cast<double>(count) / n; };
  islands.length.done(length,
                      {byBall(lookahead.near_pairs), byBall(lookahead.pair_searches), byBall(lookahead.events)});
  lookahead.end = window.end;
}
}  // namespace

void runIslands(WorldWithWindows& world, double end)
{
  IslandRecords& islands = world.islands;
  for (double start = world.time; start < end;)
  {
    const double window_end = endOfWindow(world, start, endInTick(islands, start, end));
    const std::size_t first_contact = world.contacts.size();
    if (!world.solver.ball.empty())
    {
      ++world.edits;
      handNeighboursToSolver(world, start, window_end);
    }
    const bool all_in_solver = world.solver.ball.size() == world.balls.size();
    if (!all_in_solver)
    {
      WorkerWindow window;
      window.start = start;
      window.end = window_end;
      window.smooth_until = end;
      window.lookahead = endOfLookahead(world, start, window_end);
      const Outcome outcome = runWindow(world, window);
      sumUp(world);
      if (outcome == Outcome::TooLong)
        islands.length.tooLong(std::min(islands.length.next(), window.lookahead - start));
      if (outcome != Outcome::Done) continue;
      islands.length.busy(window_end - start, busyBalls(islands));
      endLookahead(world, window);
    }
    if (!world.solver.ball.empty()) ++world.edits;  // some may leave it
    moveSolver(world, start, window_end, end);
    if (!world.solver.ball.empty())
    {
      ++world.edits;  // others may have joined
      sortContacts(world, first_contact);
    }
    start = window_end;
  }
}
}  // namespace ping_pong
