#include "islands.h"

#include <algorithm>

#include "flown.h"
#include "foresight.h"
#include "handover.h"

namespace ping_pong
{
namespace
{
// Long windows make large islands, in which each looks at each; short ones cost a search for neighbours each. Searches of
// pairs, by ball and window:
constexpr double kManySearches = 2.0;     // halve the window
constexpr double kFewSearches = 0.7;      // double it
constexpr double kTooManySearches = 4.0;  // give up and begin again with a shorter window
constexpr double kShortestWindow = 1e-4;  // [s]

std::uint32_t rootOf(IslandRecords& islands, std::uint32_t i)
{
  while (islands.root[i] != i) i = islands.root[i] = islands.root[islands.root[i]];
  return i;
}

void unite(IslandRecords& islands, std::uint32_t i, std::uint32_t k)
{
  const std::uint32_t a = rootOf(islands, i), b = rootOf(islands, k);
  if (a == b) return;
  islands.root[std::max(a, b)] = std::min(a, b);
  islands.settled[std::min(a, b)] = false;
  std::swap(islands.next[a], islands.next[b]);
}

void save(WorldState& world, std::size_t i)
{
  IslandRecords& islands = world.islands;
  if (islands.saved_at[i] != IslandRecords::kNotSaved) return;
  islands.saved_at[i] = static_cast<std::uint32_t>(islands.saved.size());
  islands.saved.push_back(world.balls[i]);
}

void begin(WorldState& world)
{
  IslandRecords& islands = world.islands;
  const std::size_t n = world.balls.size();
  islands.alone.resize(n);
  islands.swept.resize(n);
  islands.runs = 0;
  islands.saved.clear();
  islands.saved_at.assign(n, IslandRecords::kNotSaved);
  islands.root.resize(n);
  islands.next.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) islands.root[i] = islands.next[i] = i;
  islands.settled.assign(n, false);
  islands.islands.clear();
  islands.pieces.clear();
  islands.last_piece.assign(n, IslandRecords::kNoPiece);
}

void runAlone(WorldState& world, Window window, std::size_t i)
{
  BallRecord& ball = world.balls[i];
  ball.swept = Box();
  ball.met = false;
  ball.run = 0;
  ball.next_ball = Event();
  if (ball.away())
  {
    world.islands.alone[i] = world.islands.swept[i] = Box();
    return;
  }
  if (soonest(ball).time <= window.end)
  {
    save(world, i);
    window.members = &i;
    window.count = 1;
    runTogether(world, window);
  }
  Box box = ball.swept;
  box.add(boxOf(ball, window.start, window.end));
  world.islands.alone[i] = world.islands.swept[i] = box;
}

bool movedAlone(const WorldState& world, std::size_t i)
{
  return world.islands.last_piece[i] != IslandRecords::kNoPiece;
}

// Whether two balls that would be alone meet.
bool meet(const WorldState& world, const Window& window, std::size_t i, std::size_t k)
{
  const BallRecord &a = world.balls[i], &b = world.balls[k];
  if (a.away() || b.away()) return false;
  if (a.path.degree == 0 && b.path.degree == 0 && !movedAlone(world, i) && !movedAlone(world, k)) return false;
  return metInFlight(world, window, i, k);
}

void gatherMembers(IslandRecords& islands, std::uint32_t first)
{
  islands.members.clear();
  std::uint32_t i = first;
  do
  {
    islands.members.push_back(i);
    i = islands.next[i];
  } while (i != first);
  std::sort(islands.members.begin(), islands.members.end());  // ties go to the first ball, whoever came in first
}

void backToStart(WorldState& world)
{
  IslandRecords& islands = world.islands;
  ++islands.runs;
  for (const std::size_t i : islands.members)
  {
    save(world, i);
    BallRecord& ball = world.balls[i];
    ball = islands.saved[islands.saved_at[i]];
    forgetFlown(world, i);
    ball.met = false;
    ball.next_ball = Event();
    ball.run = islands.runs;
  }
}

// What balls have recorded before their island went back to the start has not happened.
void dropVoidContacts(WorldState& world, std::size_t first)
{
  std::size_t kept = first;
  for (std::size_t c = first; c < world.contacts.size(); ++c)
  {
    if (world.origins[c].run != world.balls[world.origins[c].ball].run) continue;
    if (kept != c)
    {
      world.contacts[kept] = world.contacts[c];
      world.origins[kept] = world.origins[c];
    }
    ++kept;
  }
  world.status.contacts -= world.contacts.size() - kept;
  world.contacts.resize(kept);
  world.origins.resize(kept);
}

// False if there is no end of events.
bool runIsland(WorldState& world, Window window)
{
  const std::vector<std::size_t>& members = world.islands.members;
  for (std::size_t m = 0; m < members.size(); ++m)
    for (std::size_t n = m + 1; n < members.size(); ++n)
      foreseeBall(world, members[m], members[n], -kNever, window.end);
  window.members = members.data();
  window.count = members.size();
  window.most_events = mostEvents(world, members);
  return runTogether(world, window) || world.status.event_limit;
}

// Balls that were thrown off their path may sweep into balls outside: joins those. False if there are any.
bool metNobodyElse(WorldState& world, const Window& window)
{
  IslandRecords& islands = world.islands;
  const std::uint32_t root = rootOf(islands, static_cast<std::uint32_t>(islands.members.front()));
  for (const std::size_t i : islands.members)
  {
    const BallRecord& ball = world.balls[i];
    islands.swept[i] = ball.swept;
    islands.swept[i].add(boxOf(ball, window.start, window.end));
  }
  bool nobody = true;
  const auto lookAt = [&](std::size_t i, std::uint32_t k) {
    if (rootOf(islands, k) == root || world.balls[k].away() || !islands.swept[k].overlaps(islands.swept[i])) return;
    if (metInFlight(world, window, i, k)) islands.near.push_back(k);
  };
  islands.near.clear();
  for (const std::size_t i : islands.members)
  {
    if (!world.balls[i].met) continue;
    islands.broad_phase.findOverlapping(islands.swept[i], islands.alone, islands.found);
    for (const std::uint32_t k : islands.found) lookAt(i, k);
    islands.broad_phase.findAdded(islands.swept[i], islands.found);
    for (const std::uint32_t k : islands.found) lookAt(i, k);
  }
  for (const std::uint32_t k : islands.near)
  {
    unite(islands, root, k);
    nobody = false;
  }
  return nobody;
}

bool worthAShorterWindow(const WorldState& world, const Window& window)
{
  const double m = static_cast<double>(world.islands.members.size());
  const double searches = static_cast<double>(world.islands.pair_searches) + m * m;
  return window.end - window.start > 1.001 * kShortestWindow &&  // beyond the rounding of its ends
         searches > kTooManySearches * static_cast<double>(world.balls.size()) + kTooManySearches * kTooManySearches;
}

// False if the island is too large for this window, or crowded.
bool settleIsland(WorldState& world, const Window& window, std::uint32_t first)
{
  IslandRecords& islands = world.islands;
  do
  {
    gatherMembers(islands, first);
    if (worthAShorterWindow(world, window)) return false;
    backToStart(world);
    if (!runIsland(world, window))
    {
      islands.crowded.assign(islands.members.begin(), islands.members.end());
      return false;
    }
  } while (!metNobodyElse(world, window));
  islands.settled[rootOf(islands, first)] = true;
  for (const std::size_t i : islands.members)
    if (world.balls[i].met) islands.broad_phase.add(static_cast<std::uint32_t>(i), islands.swept[i]);
  return true;
}

// As if the window had never begun.
void undo(WorldState& world, std::size_t first_contact)
{
  const IslandRecords& islands = world.islands;
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    if (islands.saved_at[i] != IslandRecords::kNotSaved) world.balls[i] = islands.saved[islands.saved_at[i]];
  world.status.contacts -= world.contacts.size() - first_contact;
  world.contacts.resize(first_contact);
  world.origins.resize(first_contact);
}

// By time, ties by ball. Contacts are large: their order is found first, and each is moved once.
void sortContacts(WorldState& world, std::size_t first)
{
  std::vector<IslandRecords::Place>& order = world.islands.order;
  order.clear();
  bool sorted = true;
  for (std::size_t c = first; c < world.contacts.size(); ++c)
  {
    order.push_back({world.contacts[c].time, world.contacts[c].ball, static_cast<std::uint32_t>(c)});
    sorted &= c == first || !(order.back() < order[order.size() - 2]);
  }
  if (sorted) return;
  std::sort(order.begin(), order.end());
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    std::size_t from = order[k].contact;
    while (from < first + k) from = order[from - first].contact;  // it has been moved away from there
    order[k].contact = static_cast<std::uint32_t>(from);
    std::swap(world.contacts[first + k], world.contacts[from]);
  }
}

// False if nothing was done, since the window was too long.
bool runWindow(WorldState& world, const Window& window)
{
  IslandRecords& islands = world.islands;
  const std::size_t first_contact = world.contacts.size();
  begin(world);
  for (std::size_t i = 0; i < world.balls.size(); ++i) runAlone(world, window, i);
  for (const BroadPhase::Pair& pair : islands.broad_phase.findPairs(islands.alone))
    if (meet(world, window, pair.a, pair.b))
    {
      unite(islands, pair.a, pair.b);
      islands.islands.push_back(pair.a);
    }
  for (const std::uint32_t first : islands.islands)
    if (!islands.settled[rootOf(islands, first)] && !settleIsland(world, window, first))
    {
      undo(world, first_contact);
      return false;
    }
  dropVoidContacts(world, first_contact);
  sortContacts(world, first_contact);
  return true;
}
}  // namespace

void runIslands(WorldState& world, double end)
{
  IslandRecords& islands = world.islands;
  for (double start = world.time; start < end;)
  {
    const bool whole = start + 1.5 * islands.length < end;  // else it ends with the tick, whatever its length should be
    const double window_end = endOfWindow(world, start, whole ? start + islands.length : end);
    const std::size_t first_contact = world.contacts.size();
    if (!world.pile.ball.empty()) joinPile(world, start, window_end);
    islands.pair_searches = 0;
    const bool all_piled = world.pile.ball.size() == world.balls.size();
    const bool done = all_piled || runWindow(world, {start, window_end, end, nullptr, 0, true});
    const double searches = static_cast<double>(islands.pair_searches) / static_cast<double>(world.balls.size());
    if (!islands.crowded.empty())
    {
      passOn(world, islands.crowded, start);
      islands.crowded.clear();
      continue;
    }
    if (!done || searches > kManySearches)
      islands.length = std::max(0.5 * std::min(islands.length, window_end - start), kShortestWindow);
    else if (searches < kFewSearches && (whole || window_end - start >= islands.length))
      islands.length *= searches == 0.0 ? 8.0 : 2.0;
    if (!done) continue;
    movePile(world, start, window_end, end);
    if (!world.pile.ball.empty()) sortContacts(world, first_contact);
    start = window_end;
  }
}
}  // namespace ping_pong
