#include "islands.h"

#include <algorithm>

#include "foresight.h"
#include "handover.h"

namespace ping_pong
{
namespace
{
// Long windows make large islands, in which each looks at each; short ones cost a search for neighbours each. Searches of
// pairs, by ball and window:
constexpr double kManySearches = 8.0;     // halve the window
constexpr double kFewSearches = 3.0;      // double it
constexpr double kTooManySearches = 24.0; // give up and begin again with a shorter window
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
  islands.saved.clear();
  islands.saved_at.assign(n, IslandRecords::kNotSaved);
  islands.root.resize(n);
  islands.next.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) islands.root[i] = islands.next[i] = i;
  islands.settled.assign(n, false);
  islands.islands.clear();
  islands.hit.clear();
}

void runAlone(WorldState& world, Window window, std::size_t i)
{
  BallRecord& ball = world.balls[i];
  ball.swept = Box();
  ball.met = false;
  ball.next_ball = Event();
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

// Whether two balls that would be alone meet. Paths of one piece are searched, others just said to meet.
bool meet(const WorldState& world, const Window& window, std::size_t i, std::size_t k)
{
  const BallRecord &a = world.balls[i], &b = world.balls[k];
  if (a.away() || b.away()) return false;
  const IslandRecords& islands = world.islands;
  if (islands.saved_at[i] != IslandRecords::kNotSaved || islands.saved_at[k] != IslandRecords::kNotSaved) return true;
  if (a.path.degree == 0 && b.path.degree == 0) return false;
  const double from = std::max(a.path.start, b.path.start);
  return firstContact(a.path, a.params.radius, b.path, b.params.radius, from, window.end).time < kNever;
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

// Contacts of these balls in this window have not happened.
void forgetContacts(WorldState& world, std::size_t first_contact, std::uint32_t root)
{
  std::size_t kept = first_contact;
  for (std::size_t c = first_contact; c < world.contacts.size(); ++c)
  {
    if (rootOf(world.islands, world.contact_of[c]) == root) continue;
    if (kept != c)
    {
      world.contacts[kept] = world.contacts[c];
      world.contact_of[kept] = world.contact_of[c];
    }
    ++kept;
  }
  world.status.contacts -= world.contacts.size() - kept;
  world.contacts.resize(kept);
  world.contact_of.resize(kept);
}

void backToStart(WorldState& world, std::size_t first_contact, std::uint32_t root)
{
  IslandRecords& islands = world.islands;
  bool ran = false;
  for (const std::size_t i : islands.members)
  {
    ran |= islands.saved_at[i] != IslandRecords::kNotSaved;
    save(world, i);
    world.balls[i] = islands.saved[islands.saved_at[i]];
    world.balls[i].swept = Box();
    world.balls[i].met = false;
    world.balls[i].next_ball = Event();
  }
  if (ran) forgetContacts(world, first_contact, root);
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
    islands.near.push_back(k);
  };
  islands.near.clear();
  for (const std::size_t i : islands.members)
  {
    if (!world.balls[i].met) continue;
    islands.broad_phase.findOverlapping(islands.swept[i], islands.alone, islands.found);
    for (const std::uint32_t k : islands.found) lookAt(i, k);
    for (const std::uint32_t k : islands.hit) lookAt(i, k);
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
bool settleIsland(WorldState& world, const Window& window, std::uint32_t first, std::size_t first_contact)
{
  IslandRecords& islands = world.islands;
  do
  {
    gatherMembers(islands, first);
    if (worthAShorterWindow(world, window)) return false;
    backToStart(world, first_contact, rootOf(islands, first));
    if (!runIsland(world, window))
    {
      islands.crowded.assign(islands.members.begin(), islands.members.end());
      return false;
    }
  } while (!metNobodyElse(world, window));
  islands.settled[rootOf(islands, first)] = true;
  for (const std::size_t i : islands.members)
    if (world.balls[i].met) islands.hit.push_back(static_cast<std::uint32_t>(i));
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
  world.contact_of.resize(first_contact);
}

void sortContacts(WorldState& world, std::size_t first)
{
  const auto earlier = [](const Contact& a, const Contact& b) { return a.time != b.time ? a.time < b.time : a.ball < b.ball; };
  if (std::is_sorted(world.contacts.begin() + static_cast<std::ptrdiff_t>(first), world.contacts.end(), earlier)) return;
  std::sort(world.contacts.begin() + static_cast<std::ptrdiff_t>(first), world.contacts.end(), earlier);
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
    if (!islands.settled[rootOf(islands, first)] && !settleIsland(world, window, first, first_contact))
    {
      undo(world, first_contact);
      return false;
    }
  sortContacts(world, first_contact);
  return true;
}
}  // namespace

void runIslands(WorldState& world, double end)
{
  IslandRecords& islands = world.islands;
  for (double start = world.time; start < end;)
  {
    const double window_end =
        endOfWindow(world, start, start + 1.5 * islands.length < end ? start + islands.length : end);
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
    else if (searches < kFewSearches && window_end - start >= islands.length)
      islands.length *= 2.0;
    if (!done) continue;
    movePile(world, start, window_end, end);
    if (!world.pile.ball.empty()) sortContacts(world, first_contact);
    start = window_end;
  }
}
}  // namespace ping_pong
