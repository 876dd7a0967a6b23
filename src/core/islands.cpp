#include "islands.h"

#include <algorithm>
#include <cmath>

#include "flown.h"
#include "foresight.h"
#include "handover.h"

namespace ping_pong
{
namespace
{
constexpr double kTooManySearches = 4.0;  // of pairs, by ball: a window that needs more is given up

constexpr double kTicksAhead = 3.0;  // that are worth an outlook
constexpr double kShare = 0.8;       // of the windows that would fit into a tick: rather a bit longer than one more

// What a worker takes at a time.
constexpr std::size_t kBalls = 256;
constexpr std::size_t kIslands = 8;

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
  std::swap(islands.next[a], islands.next[b]);
}

// A look at two boxes that overlap costs an eighth of a search.
double pairSearches(const IslandRecords& islands)
{
  std::size_t eighths = 0;
  for (const IslandWork& work : islands.work) eighths += 8 * work.pair_searches + work.near_pairs;
  return 0.125 * static_cast<double>(eighths);
}

void save(WorldState& world, IslandWork& work, std::size_t i)
{
  std::uint32_t& saved = world.islands.saved_at[i];
  if (saved != IslandRecords::kNoEntry) return;
  saved = IslandRecords::entry(work, work.saved.size());
  work.saved.push_back(world.balls[i]);
  work.changed.push_back(static_cast<std::uint32_t>(i));
}

// While a window runs the first worker writes to the world's own lists: where it is alone, no contact is copied.
void lendContacts(WorldState& world)
{
  std::swap(world.contacts, world.islands.work.front().contacts);
  std::swap(world.origins, world.islands.work.front().origins);
}

void alone(BallRecord& ball)
{
  ball.met = false;
  if (!ball.passing) return;
  if (ball.meetsMoving() == kNever) return ball.passing.reset();
  ball.passing->run = 0;
  ball.passing->ball = Event();
}

void alone(IslandRecords& islands, std::uint32_t i)
{
  islands.root[i] = islands.next[i] = i;
  islands.saved_at[i] = islands.last_piece[i] = IslandRecords::kNoEntry;
}

// Whatever has been done to the balls.
void startAnew(WorldState& world)
{
  IslandRecords& islands = world.islands;
  const std::size_t n = world.balls.size();
  islands.glances.lookAtAll(world.balls);
  for (std::vector<std::uint32_t>* list : {&islands.saved_at, &islands.root, &islands.next, &islands.last_piece})
    list->resize(n);
  islands.swept.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) alone(islands, i);
  for (BallRecord& ball : world.balls) alone(ball);
}

// As it was before this window, for those that are not.
void forgetIslands(WorldState& world)
{
  for (const IslandWork& work : world.islands.work)
    for (const std::uint32_t i : work.changed)
    {
      alone(world.islands, i);
      alone(world.balls[i]);
      world.islands.glances[i].bent = false;
    }
}

void begin(WorldState& world)
{
  IslandRecords& islands = world.islands;
  if (!islands.glances.known()) startAnew(world);
  islands.runs = 0;
  islands.islands.clear();
  for (IslandWork& work : islands.work)
  {
    work.keep_contacts = world.keep_contacts;
    work.contacts.clear();
    work.origins.clear();
    work.status = StepStatus();
    work.pair_searches = work.near_pairs = 0;
    work.crowding = work.any_squeezed = false;
    work.saved.clear();
    work.changed.clear();
    work.pieces.clear();
    work.met.clear();
    work.crowded.clear();
  }
  islands.first_contact = world.origins.size();
  lendContacts(world);
}

// --- each ball as if it were alone ---

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
                       Window its = window;
                       its.count = 1;
                       its.records = its.work = &world.islands.work[worker];
                       for (std::size_t i = begin; i < end; ++i) action(i, its);
                     });
}

// --- islands ---

// Calls action(world, its window, entry) for all entries of a list of balls or islands.
template <class Action>
void eachOf(const std::vector<std::uint32_t>& list, WorldState& world, const Window& window, const Action& action)
{
  world.workers.each(list.size(), kIslands,
                     [&](std::size_t begin, std::size_t end, std::size_t worker)
                     {
                       Window its = window;
                       its.records = its.work = &world.islands.work[worker];
                       for (std::size_t c = begin; c < end; ++c) action(world, its, list[c]);
                     });
}

// Those who met are of one island now; its root stands in the list of islands that have to run.
void uniteWhoMet(IslandRecords& islands)
{
  islands.islands.clear();
  for (const IslandWork& work : islands.work)
    for (const auto& [i, k] : work.met) unite(islands, i, k);
  for (IslandWork& work : islands.work)
  {
    for (const auto& pair : work.met) islands.islands.push_back(rootOf(islands, pair[0]));
    work.met.clear();
  }
  std::sort(islands.islands.begin(), islands.islands.end());
  islands.islands.erase(std::unique(islands.islands.begin(), islands.islands.end()), islands.islands.end());
}

void gatherMembers(IslandRecords& islands, std::uint32_t root, std::vector<std::size_t>& members)
{
  members.clear();
  std::uint32_t i = root;
  do
  {
    members.push_back(i);
    islands.root[i] = root;
    i = islands.next[i];
  } while (i != root);
  std::sort(members.begin(), members.end());  // ties go to the first ball, whoever came in first
}

void backToStart(WorldState& world, IslandWork& work, std::size_t i)
{
  IslandRecords& islands = world.islands;
  save(world, work, i);
  BallRecord& ball = world.balls[i];
  ball = islands.saved(islands.saved_at[i]);
  forgetFlown(islands, i);
  ball.passing.make().run = islands.runs;
}

// Event by event, from the start of the window. Nobody outside is looked at.
void runIsland(WorldState& world, Window window, std::uint32_t root)
{
  IslandWork& work = *window.work;
  const std::vector<std::size_t>& members = work.members;
  gatherMembers(world.islands, root, work.members);
  for (const std::size_t i : members) backToStart(world, work, i);
  for (std::size_t m = 0; m < members.size(); ++m)
    for (std::size_t n = m + 1; n < members.size(); ++n)
      foreseeBall(world, members[m], members[n], -kNever, window.end, work);
  window.members = members.data();
  window.count = members.size();
  window.most_events = mostEvents(world, members);
  if (!runTogether(world, window)) work.crowded.insert(work.crowded.end(), members.begin(), members.end());
  for (const std::size_t i : members) noteLast(world, window, i);
}

// Outside of its island.
void findWhoWasMetBy(WorldState& world, const Window& window, std::uint32_t i)
{
  const IslandRecords& islands = world.islands;
  islands.eachNear(i,
                   [&](std::uint32_t k)
                   {
                     if (islands.root[k] == islands.root[i]) return;
                     ++window.work->near_pairs;
                     if (metInFlight(world, window, i, k)) window.work->met.push_back({i, k});
                   });
}

// Balls that were thrown off their path may come into the way of balls outside, islands of the same run among them.
void findWhoWasMet(WorldState& world, const Window& window, std::uint32_t root)
{
  const IslandRecords& islands = world.islands;
  for (std::uint32_t i = islands.next[root];; i = islands.next[i])
  {
    if (world.balls[i].met) findWhoWasMetBy(world, window, i);
    if (i == root) return;
  }
}

void addWhoWasThrown(WorldState& world)
{
  IslandRecords& islands = world.islands;
  for (const std::uint32_t root : islands.islands)
    for (std::uint32_t i = islands.next[root];; i = islands.next[i])
    {
      if (world.balls[i].met) islands.broad_phase.add(i, islands.swept[i]);
      if (i == root) break;
    }
}

// Each looks at each in an island.
bool worthAShorterWindow(const WorldState& world, const Window& window)
{
  const IslandRecords& islands = world.islands;
  if (!(window.end - window.start > 1.5001 * WindowLength::kShortest)) return false;  // the next try would be as long: see runIslands()
  const double limit = kTooManySearches * static_cast<double>(world.balls.size()) + kTooManySearches * kTooManySearches;
  double searches = pairSearches(islands);
  for (const std::uint32_t root : islands.islands)
  {
    double m = 1.0;
    for (std::uint32_t i = islands.next[root]; i != root; i = islands.next[i]) m += 1.0;
    searches += m * m;
  }
  return searches > limit;
}

// Runs all islands of the list, and lists those that have to run again, joined with others.
void runIslandsOnce(WorldState& world, const Window& window)
{
  IslandRecords& islands = world.islands;
  ++islands.runs;
  eachOf(islands.islands, world, window, runIsland);
  addWhoWasThrown(world);
  eachOf(islands.islands, world, window, findWhoWasMet);
  uniteWhoMet(islands);
}

// --- the window ---

// As if the window had never begun.
void undo(WorldState& world)
{
  IslandRecords& islands = world.islands;
  lendContacts(world);  // and back
  world.origins.resize(islands.first_contact);
  if (world.keep_contacts) world.contacts.resize(islands.first_contact);
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    if (islands.saved_at[i] != IslandRecords::kNoEntry) world.balls[i] = islands.saved(islands.saved_at[i]);
  islands.glances.forget();
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

// Not of an earlier run of its island: what balls have recorded before their island went back to the start has not
// happened.
bool happened(const WorldState& world, const ContactOrigin& origin)
{
  return origin.run == world.balls[origin.ball].run();
}

// Of the contacts from the first on, those that have happened.
void dropVoid(WorldState& world, std::size_t first)
{
  std::size_t kept = first;
  for (std::size_t c = first; c < world.origins.size(); ++c)
  {
    if (!happened(world, world.origins[c])) continue;
    if (kept != c)
    {
      if (world.keep_contacts) world.contacts[kept] = world.contacts[c];
      world.origins[kept] = world.origins[c];
    }
    ++kept;
  }
  world.origins.resize(kept);
  if (world.keep_contacts) world.contacts.resize(kept);
}

// All contacts of a ball that have happened are in the list of one worker, in their order: which one does not matter.
void takeContacts(WorldState& world)
{
  const std::size_t first = world.islands.first_contact;
  lendContacts(world);  // and back
  dropVoid(world, first);
  for (std::size_t worker = 1; worker < world.islands.work.size(); ++worker)
  {
    IslandWork& work = world.islands.work[worker];
    for (std::size_t c = 0; c < work.origins.size(); ++c)
    {
      if (!happened(world, work.origins[c])) continue;
      if (world.keep_contacts) world.contacts.push_back(work.contacts[c]);
      world.origins.push_back(work.origins[c]);
    }
  }
  world.status.contacts += world.origins.size() - first;
  if (world.keep_contacts)
    sortContacts(world, first);
  else
    world.origins.resize(first);
}

// Whoever was crowded while the window was run passes; false if nobody was.
bool passOnWhoIsCrowded(WorldState& world, double start)
{
  std::vector<std::uint32_t>& crowded = world.islands.near;
  crowded.clear();
  for (const IslandWork& work : world.islands.work)
    crowded.insert(crowded.end(), work.crowded.begin(), work.crowded.end());
  if (crowded.empty()) return false;
  std::sort(crowded.begin(), crowded.end());
  undo(world);
  passOn(world, crowded, start);
  return true;
}

enum class Outcome
{
  Done,
  TooLong,  ///< nothing was done: the window has to be shorter
  Crowded   ///< nothing was done but that balls have joined the pile
};

// The outlook of a window before this one holds to its end.
bool seesAhead(const IslandRecords& islands, double end)
{
  return islands.glances.known() && islands.outlook.end >= end;
}

// All fly, and each looks for others in its way.
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

// Whom balls meet that nothing happens to is known.
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

Outcome runWindow(WorldState& world, const Window& window)
{
  IslandRecords& islands = world.islands;
  const bool seen_ahead = seesAhead(islands, window.end);
  begin(world);
  if (seen_ahead)
    flyOn(world, window);
  else
    flyAnew(world, window);
  for (uniteWhoMet(islands); !islands.islands.empty(); runIslandsOnce(world, window))
  {
    if (passOnWhoIsCrowded(world, window.start)) return Outcome::Crowded;
    if (!worthAShorterWindow(world, window)) continue;
    undo(world);
    return Outcome::TooLong;
  }
  if (passOnWhoIsCrowded(world, window.start)) return Outcome::Crowded;
  takeContacts(world);
  if (islands.outlook.end > window.end) lookAhead(world, window);
  forgetIslands(world);
  return Outcome::Done;
}

// What was tried in vain counts, too.
void sumUp(WorldState& world)
{
  for (const IslandWork& work : world.islands.work)
  {
    world.status.events += work.status.events;
    world.status.event_limit |= work.status.event_limit;
    world.crowding |= work.crowding;
    world.any_squeezed |= work.any_squeezed;
  }
}

// Windows share what is left of the tick.
double endInTick(const IslandRecords& islands, double start, double end)
{
  const double windows = std::ceil(kShare * (end - start) / islands.length.next());
  return windows > 1.0 ? start + (end - start) / windows : end;
}

// Where windows are short because ticks are, one looks ahead: but not if someone changes balls or paddles in every tick.
double endOfOutlook(const IslandRecords& islands, double start, double window_end, double tick)
{
  if (seesAhead(islands, window_end)) return islands.outlook.end;
  const bool ahead = islands.glances.known() && islands.length.next() >= kTicksAhead * tick;
  return ahead ? start + islands.length.next() : window_end;
}

// If the outlook does not hold for another window like this one, it ends here. Whether its length was right is known then.
void endOutlook(WorldState& world, const Window& window)
{
  IslandRecords& islands = world.islands;
  Outlook& outlook = islands.outlook;
  for (const IslandWork& work : islands.work)
  {
    outlook.near_pairs += work.near_pairs;
    outlook.pair_searches += work.pair_searches;
    outlook.events += work.status.events;
  }
  const bool cut = window.outlook > window.end && outlook.end <= window.end;
  if (outlook.end - window.end > 0.999 * (window.end - window.start)) return;
  const double n = static_cast<double>(world.balls.size());
  const double length = window.end - outlook.start;
  if (cut) islands.length.cutTo(length);
  const auto byBall = [n](std::size_t count) { return static_cast<double>(count) / n; };
  islands.length.done(length, {byBall(outlook.near_pairs), byBall(outlook.pair_searches), byBall(outlook.events)});
  outlook.end = window.end;
}
}  // namespace

void runIslands(WorldState& world, double end)
{
  IslandRecords& islands = world.islands;
  const double tick = end - world.time;
  for (double start = world.time; start < end;)
  {
    const double window_end = endOfWindow(world, start, endInTick(islands, start, end));
    const std::size_t first_contact = world.contacts.size();
    if (!world.pile.ball.empty())
    {
      islands.glances.forget();
      joinPile(world, start, window_end);
    }
    const bool all_piled = world.pile.ball.size() == world.balls.size();
    if (!all_piled)
    {
      Window window;
      window.start = start;
      window.end = window_end;
      window.smooth_until = end;
      window.outlook = endOfOutlook(islands, start, window_end, tick);
      const Outcome outcome = runWindow(world, window);
      sumUp(world);
      if (outcome == Outcome::TooLong) islands.length.tooLong(std::min(islands.length.next(), window.outlook - start));
      if (outcome != Outcome::Done) continue;
      endOutlook(world, window);
    }
    if (!world.pile.ball.empty()) islands.glances.forget();  // some may leave it
    movePile(world, start, window_end, end);
    if (!world.pile.ball.empty())
    {
      islands.glances.forget();  // others may have joined
      sortContacts(world, first_contact);
    }
    start = window_end;
  }
}
}  // namespace ping_pong
