// What the exact method keeps from window to window of many balls, and each worker's part of it.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "detect/broad_phase.h"
#include "events/event_loop.h"
#include "solver/solver_state.h"
#include "windows/ball_cache.h"
#include "windows/lookahead.h"
#include "windows/window_length.h"

namespace ping_pong
{
/// Who is near some balls: of one after the other, up to its end.
struct NearList
{
  std::vector<std::uint32_t> entries;  ///< as BroadPhase lists them
  std::vector<std::size_t> ends;

  void clear()
  {
    entries.clear();
    ends.clear();
  }
};

/// What a worker has to do with a window, see islands.h. In lines of the cache of its own.
struct alignas(128) IslandWork : Records
{
  /// Of a ball's flight in this window.
  struct Piece
  {
    Parabola path;
    double until;           ///< [s]
    std::uint32_t earlier;  ///< the ball's piece before, or IslandRecords::kNoEntry
    std::uint16_t count;    ///< pieces of the ball so far
    bool parabola;          ///< else the path is of another form, and not known here
  };

  /// A ball to which something happens in this window.
  struct Busy
  {
    std::uint32_t ball;
    std::uint32_t root,
        next;            ///< union-find over balls, and the circular list of an island's; the least index is the root
    std::uint32_t size;  ///< of the island, if this is its root [balls]
    float next_event;    ///< CachedBall::next() of the ball after this window [s]
    std::uint32_t saved, piece;  ///< entries in the lists of workers, or IslandRecords::kNoEntry; its last piece
    std::uint32_t run : 30;      ///< of its island, the last one; 0 if the ball has been alone
    std::uint32_t met : 1;       ///< it has hit a ball in that run
    std::uint32_t listed : 1;    ///< the root of an island that has to run
    CoarseBox swept;             ///< in this window and on the path that it is on, until the lookahead ends
  };

  std::uint32_t worker = 0;
  std::vector<Busy> busy;
  std::vector<BallRecord> saved;     ///< balls at the start of the window, of those that have changed since
  std::vector<Piece> pieces;         ///< of flights in this window, see encounters.h
  std::vector<std::size_t> members;  ///< the island at work
  std::vector<std::array<std::uint32_t, 2>> met;    ///< balls that are in each other's way,
  std::vector<std::array<std::uint32_t, 2>> apart;  ///< and those of them that are not both in `busy`
  std::vector<std::uint32_t> roots;                 ///< of islands that have to run
  std::size_t squares = 0;  ///< of the sizes of islands: all workers' together are those of all that have to run
  std::vector<std::uint32_t> to_hand_off;  ///< balls of islands with events without end, see solver_handover.h
  std::vector<std::uint32_t> deflected;    ///< balls that have left their paths
  BroadPhase::Additions deferred;          ///< their boxes, on their way to the grid
  NearList near;

  // What comes in the lookahead. Each of these lists is gone through by one worker, this one or another.
  std::vector<PredictedContact> predicted;     ///< after this window
  std::vector<PredictedContact> due_contacts;  ///< in this window
  std::vector<std::uint32_t> due;              ///< balls that may have an event with a body after this window,
  std::vector<std::uint32_t> due_now;          ///< and in it
  std::vector<std::uint32_t> added;            ///< balls whose paths have changed since it began, by each change
};

/// What the exact method keeps from window to window, see islands.h. Balls to which nothing
/// happens are not written to; between windows nobody is busy.
struct IslandRecords
{
  static constexpr std::uint32_t kNoEntry = ~0u;

  /// An entry in a list of a worker.
  static constexpr std::uint32_t kIndexBits = 26;
  static std::uint32_t entry(const IslandWork& work, std::size_t index)
  {
    return work.worker << kIndexBits | static_cast<std::uint32_t>(index);
  }
  IslandWork& workOf(std::uint32_t entry) { return work[entry >> kIndexBits]; }
  const IslandWork& workOf(std::uint32_t entry) const { return work[entry >> kIndexBits]; }
  static std::uint32_t indexOf(std::uint32_t entry) { return entry & ((1u << kIndexBits) - 1u); }
  const BallRecord& saved(std::uint32_t entry) const { return workOf(entry).saved[indexOf(entry)]; }
  bool isBusy(std::size_t i) const { return cache[i].busy; }
  /// Of a ball that is.
  IslandWork::Busy& busy(std::size_t i) { return workOf(cache[i].entry()).busy[indexOf(cache[i].entry())]; }
  const IslandWork::Busy& busy(std::size_t i) const { return workOf(cache[i].entry()).busy[indexOf(cache[i].entry())]; }
  /// The same, from now on if it was not yet: an island of its own.
  IslandWork::Busy& makeBusy(IslandWork& its_work, std::size_t i)
  {
    CachedBall& cached = cache[i];
    if (cached.busy) return busy(i);
    const float next = cached.next();
    cached.setEntry(entry(its_work, its_work.busy.size()));
    cached.busy = true;
    return addBusy(its_work, i, next);
  }
  /// Whether it is in the list of this worker, if need be from now on. By all workers at the same time.
  bool claim(IslandWork& its_work, std::size_t i)
  {
    if (work.size() == 1)  // an exchange takes as long as a dozen other operations
    {
      makeBusy(its_work, i);
      return true;
    }
    const CachedBallHead now = cache.head(i);
    if (now.busy) return now.entry() >> kIndexBits == its_work.worker;
    CachedBallHead claimed = now;
    claimed.setEntry(entry(its_work, its_work.busy.size()));
    claimed.busy = true;
    if (!cache.replace(i, now, claimed)) return false;
    addBusy(its_work, i, now.next());
    return true;
  }
  /// Whether ball i, which is busy, is in the list of this worker; while others are claimed.
  bool isOf(const IslandWork& its_work, std::size_t i) const
  {
    return cache.head(i).entry() >> kIndexBits == its_work.worker;
  }
  static IslandWork::Busy& addBusy(IslandWork& its_work, std::size_t i, float next)
  {
    const auto ball = static_cast<std::uint32_t>(i);
    its_work.busy.push_back({ball, ball, ball, 1, next, kNoEntry, kNoEntry, 0, 0, 0, CoarseBox()});
    return its_work.busy.back();
  }
  std::size_t islandsToRun() const
  {
    std::size_t count = 0;
    for (const IslandWork& its_work : work) count += its_work.roots.size();
    return count;
  }
  std::uint32_t lastPiece(std::size_t i) const { return isBusy(i) ? busy(i).piece : kNoEntry; }
  const IslandWork::Piece& piece(std::uint32_t entry) const { return workOf(entry).pieces[indexOf(entry)]; }

  /// Of a contact in the order of a window's contacts.
  struct ContactOrder
  {
    double time;
    BallId ball;
    std::uint32_t contact;  ///< its index
    bool operator<(const ContactOrder& other) const
    {
      return std::tie(time, ball, contact) < std::tie(other.time, other.ball, other.contact);
    }
  };

  WindowLength length;  ///< of the next window
  Lookahead lookahead;
  std::size_t first_contact = 0;           ///< of this window, in the world's list
  std::uint32_t runs = 0;                  ///< of all islands that have to run again, in this window
  BallCache cache;                         ///< of each ball
  BroadPhase broad_phase;                  ///< of what each ball would sweep if no other were there
  std::vector<IslandWork> work;            ///< of each worker
  std::vector<std::size_t> ends;           ///< of the lists of islands that have to run, one after the other
  std::vector<std::uint32_t> found, near;  ///< balls near those of the solver; a list for a moment
  std::vector<CoarseBox> near_boxes;       ///< of those near the solver
  std::vector<ContactOrder> order;         ///< of the window's contacts
  std::vector<std::uint32_t> to_hand_off;  ///< balls of an island with events without end, see solver_handover.h

  /// Takes the memory for so many balls now, not while the world moves on.
  void reserve(std::size_t balls, std::size_t workers);

  /// Ball i is elsewhere than it was when the lookahead began: after addToGrid() in what it sweeps.
  void deferInsertion(IslandWork& its_work, std::uint32_t i)
  {
    cache[i].added = true;
    its_work.added.push_back(i);
    broad_phase.deferInsertion(i, busy(i).swept, its_work.deferred);
  }
  void addToGrid(Workers& workers) { broad_phase.add(work, &IslandWork::deferred, workers); }
  /// Ball i may have an event with a body before the lookahead ends.
  void noteDue(IslandWork& its_work, std::uint32_t i)
  {
    if (cache[i].due) return;
    cache[i].due = true;
    its_work.due.push_back(i);
  }

  /// Lists whose boxes overlap this one, for eachNear(): what the cache has of them comes through memory until then.
  template <class AnyBox>
  void listNear(const AnyBox& box, NearList& list) const
  {
    const std::size_t before = list.entries.size();
    broad_phase.listOverlapping(box, list.entries);
    for (std::size_t e = before; e < list.entries.size(); ++e) cache.fetch(list.entries[e] & ~BroadPhase::kAdded);
    list.ends.push_back(list.entries.size());
  }
  /// Calls action(k) for every ball k but i itself that was listed in the c-th place; for some twice.
  template <class Action>
  void eachNear(std::uint32_t i, const NearList& list, std::size_t c, const Action& action) const
  {
    for (std::size_t e = c == 0 ? 0 : list.ends[c - 1]; e < list.ends[c]; ++e)
    {
      const std::uint32_t entry = list.entries[e], k = entry & ~BroadPhase::kAdded;
      if (k != i && (entry != k || !cache[k].added)) action(k);
    }
  }
};

/// The world as time windows see it: the highest of its three layers, and the only one that is ever made.
struct WorldWithWindows : WorldWithSolver
{
  using WorldWithSolver::WorldWithSolver;

  IslandRecords islands;
};

/// A window as one worker sees it.
struct WorkerWindow : Window
{
  IslandWork* work = nullptr;  ///< its lists; its records, too
};
}  // namespace ping_pong
