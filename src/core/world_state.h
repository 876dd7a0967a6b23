// What the methods share: every ball, every body, and the records of the tick.
#pragma once

#include <cassert>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "ball_types.h"
#include "broad_phase.h"
#include "glance.h"
#include "outlook.h"
#include "parabola.h"
#include "pile.h"
#include "ping_pong_sim/contact.h"
#include "ping_pong_sim/detect.h"
#include "ping_pong_sim/pooled.h"
#include "ping_pong_sim/scene.h"
#include "ping_pong_sim/segment.h"
#include "ping_pong_sim/support.h"
#include "ping_pong_sim/world.h"
#include "window_length.h"
#include "workers.h"

namespace ping_pong
{
/// The next thing that happens to a ball.
struct Event
{
  enum class Kind : std::uint8_t
  {
    None,
    LookAgain,   ///< the search ended here without an answer
    LeaveFace,   ///< the path on the supporting surfaces ends
    HitBody,
    HitBall
  };
  static constexpr std::uint32_t kNobody = ~0u;

  double time = kNever;           ///< world time [s]
  std::uint32_t other = kNobody;  ///< index of body or ball
  std::uint32_t version = 0;      ///< of the other when this was foreseen: another one makes it void
  std::uint16_t shape = 0;        ///< of the body
  Kind kind = Kind::None;
};

/// What concerns a ball in this window only, and not all balls.
struct Passing
{
  Event moving;  ///< with moving bodies
  Event ball;    ///< with balls of the same island, while that runs
};

/// Who moves a ball.
enum class BallOwner : std::uint8_t
{
  Method,          ///< the scene's method, on paths or in steps of its own
  Solver,          ///< the contact solver: every ball of `impulse`, and what `exact` has handed over, see handover.h
  SolverAsleep,    ///< the same; at rest until something wakes it, see pile_sleep.cpp
  Nobody,          ///< squeezed: it has no room, and is given back to the method when it has
  NobodyOfSolver   ///< the same, given back to the solver
};

/// Thousands of them are a long way through memory: what many have in common, and what few have, is elsewhere, and small
/// members are where larger ones end before their last byte.
struct BallRecord
{
  const BallType* type;
  [[no_unique_address]] Event next;  ///< with still bodies; holds until the path changes
  BallOwner owner : 7;
  bool overflows : 1;             ///< a step of fixed length from here has no finite end: the path goes straight on
  std::uint16_t crush = 0;        ///< contacts in even quicker succession than a streak's
  std::uint8_t streak = 0;        ///< contacts in quick succession, see streak.h
  std::uint8_t crowding = 0;      ///< contacts with other balls since `crowded_since`, see handover.h
  Pooled<Passing> passing;
  Supports supports;
  [[no_unique_address]] Segment path;
  BallId id;
  double last_contact = -1e300;   ///< [s]
  float crowded_since = -1e30f;   ///< [s]
  std::uint32_t version = 0;      ///< of the path

  BallRecord(BallId its_id, const BallType& its_type)
    : type(&its_type), owner(BallOwner::Method), overflows(false), id(its_id)
  {
  }
  const BallParams& params() const { return type->first; }
  const FlightModel& model() const { return type->second; }
  /// The exact method has nothing to do with it.
  bool away() const { return owner != BallOwner::Method; }
  bool asleep() const { return owner == BallOwner::SolverAsleep; }
  bool squeezed() const { return owner == BallOwner::Nobody || owner == BallOwner::NobodyOfSolver; }
  /// In the solver, or squeezed there.
  bool ofSolver() const { return owner != BallOwner::Method && owner != BallOwner::Nobody; }
  void wake()
  {
    if (asleep()) owner = BallOwner::Solver;
  }
  BallState stateAt(double time) const { return path.state(time - path.start); }

  /// When it meets a ball or a moving body, as far as that is foreseen; kNever if it does not.
  double meetsBall() const { return passing ? passing->ball.time : kNever; }
  double meetsMoving() const { return passing ? passing->moving.time : kNever; }
  void expectNothing()
  {
    next = Event();
    if (passing) passing->moving = passing->ball = Event();
  }
  /// As between runs of islands.
  void expectNoBall()
  {
    if (meetsMoving() == kNever) return passing.reset();
    passing->ball = Event();
  }
};
static_assert(sizeof(BallRecord) <= 224, "a crowd has thousands: see docs/crowd_cost.md");

inline const Event& soonest(const BallRecord& ball)
{
  if (!ball.passing) return ball.next;
  const Passing& passing = *ball.passing;
  const Event& with_body = passing.moving.time < ball.next.time ? passing.moving : ball.next;
  return passing.ball.time < with_body.time ? passing.ball : with_body;
}

/// Contains the ball on its path at all times in [from, to], or from the start of the path if that is later.
Box boxOf(const BallRecord& ball, double from, double to);
/// The same for a ball on a parabola: the chord, and as far beyond it as the parabola bulges, |a| T^2 / 8. Wider than need be
/// where the ball does not turn round in between, but without a root, a quotient or a branch.
[[gnu::always_inline]] inline Box boxOf(const ParabolaView& path, double radius, double from, double to)
{
  const double s = std::max(from - path.start, 0.0), e = std::max(to - path.start, s);
  const Vector3d p = path.p + s * (path.v + s * path.half_a), q = path.p + e * (path.v + e * path.half_a);
  const Vector3d bulge = (0.25 * (e - s) * (e - s)) * path.half_a;  // towards -a
  return {(p.cwiseMin(q) - bulge.cwiseMax(0.0)).array() - radius, (p.cwiseMax(q) - bulge.cwiseMin(0.0)).array() + radius};
}

struct BodyRecord
{
  Body body;
  BodyMotion motion;      ///< from its start on; still bodies have none
  PaddleCommand command;
  bool moving = false;
  bool moved = false;     ///< in the window before
  bool blocked = false;   ///< a static body has stopped it in this tick
  unsigned version = 0;
  std::vector<Shape> placed;  ///< the shapes in the world frame, for still bodies
  std::vector<Box> boxes;     ///< that contain them

  const std::vector<Shape>& shapes() const { return moving ? body.shapes : placed; }
  const BodyMotion& frame() const { return moving ? motion : kWorldFrame; }
  BodyFrame at(double time) const { return frameAt(frame(), time - frame().start); }
  /// A point given in W, in the frame of shapes() [m].
  Vector3d seenFrom(const Vector3d& p_WQ, double time) const { return moving ? motion.poseAt(time - motion.start).toB(p_WQ) : p_WQ; }

  static const BodyMotion kWorldFrame;
};

/// Which ball has recorded a contact, and in which run of its island: what an earlier one has recorded has not happened.
struct ContactOrigin
{
  std::uint32_t ball;
  std::uint32_t run;  ///< 0: the ball was alone
};

/// What the handling of events notes, besides the balls: of the world, or of one worker.
struct Records
{
  bool keep_contacts = true;           ///< else they are counted only
  std::vector<Contact> contacts;
  std::vector<ContactOrigin> origins;  ///< by contact, in the exact method
  std::uint32_t run = 0;               ///< of the island at work, for origins
  StepStatus status;
  std::size_t pair_searches = 0;       ///< of balls with balls, in this window
  std::size_t near_pairs = 0;          ///< of balls whose boxes overlap, in this window
  bool crowding = false;               ///< a ball has met others too often, see handover.h
  bool any_squeezed = false;           ///< a ball may be
};

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
    bool parabola;          ///< else the path is of another kind, and not known here
  };

  /// A ball to which something happens in this window.
  struct Busy
  {
    std::uint32_t ball;
    std::uint32_t root, next;      ///< union-find over balls, and the circular list of an island's; the least index is the root
    std::uint32_t size;            ///< of the island, if this is its root [balls]
    float next_event;              ///< Glance::next of the ball after this window [s]
    std::uint32_t saved, piece;    ///< entries in the lists of workers, or IslandRecords::kNoEntry; its last piece
    std::uint32_t run : 30;        ///< of its island, the last one; 0 if the ball has been alone
    std::uint32_t met : 1;         ///< it has hit a ball in that run
    std::uint32_t listed : 1;      ///< the root of an island that has to run
    CoarseBox swept;               ///< in this window and on the path that it is on, until the outlook ends
  };

  std::uint32_t worker = 0;
  std::vector<Busy> busy;
  std::vector<BallRecord> saved;      ///< balls at the start of the window, of those that have changed since
  std::vector<Piece> pieces;          ///< flown in this window, see flown.h
  std::vector<std::size_t> members;   ///< the island at work
  std::vector<std::array<std::uint32_t, 2>> met;  ///< balls that are in each other's way,
  std::vector<std::array<std::uint32_t, 2>> apart;  ///< and those of them that are not both in `busy`
  std::vector<std::uint32_t> roots;   ///< of islands that have to run
  std::size_t squares = 0;            ///< of the sizes of islands: all workers' together are those of all that have to run
  std::vector<std::uint32_t> crowded;  ///< balls of islands with events without end, see handover.h
  std::vector<std::uint32_t> thrown;  ///< balls that have left their paths
  BroadPhase::Additions announced;  ///< their boxes, on their way to the grid
  NearList near;

  // What comes in the outlook. Each of these lists is gone through by one worker, this one or another.
  std::vector<Meeting> meetings;      ///< after this window
  std::vector<Meeting> due_meetings;  ///< in this window
  std::vector<std::uint32_t> due;     ///< balls that may have an event with a body after this window,
  std::vector<std::uint32_t> turn;    ///< and in it
  std::vector<std::uint32_t> added;   ///< balls whose paths have changed since it began, by each change
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
  bool isBusy(std::size_t i) const { return glances[i].busy; }
  /// Of a ball that is.
  IslandWork::Busy& busy(std::size_t i) { return workOf(glances[i].entry).busy[indexOf(glances[i].entry)]; }
  const IslandWork::Busy& busy(std::size_t i) const { return workOf(glances[i].entry).busy[indexOf(glances[i].entry)]; }
  /// The same, from now on if it was not yet: an island of its own.
  IslandWork::Busy& makeBusy(IslandWork& its_work, std::size_t i)
  {
    Glance& glance = glances[i];
    if (glance.busy) return busy(i);
    const float next = glance.next;
    glance.entry = entry(its_work, its_work.busy.size());
    glance.busy = true;
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
    const GlanceHead now = glances.head(i);
    if (now.busy) return now.entry >> kIndexBits == its_work.worker;
    GlanceHead claimed = now;
    claimed.entry = entry(its_work, its_work.busy.size());
    claimed.busy = true;
    if (!glances.replace(i, now, claimed)) return false;
    addBusy(its_work, i, now.next);
    return true;
  }
  /// Whether ball i, which is busy, is in the list of this worker; while others are claimed.
  bool isOf(const IslandWork& its_work, std::size_t i) const { return glances.head(i).entry >> kIndexBits == its_work.worker; }
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
  struct Place
  {
    double time;
    BallId ball;
    std::uint32_t contact;  ///< its index
    bool operator<(const Place& other) const
    {
      return std::tie(time, ball, contact) < std::tie(other.time, other.ball, other.contact);
    }
  };

  WindowLength length;                     ///< of the next window
  Outlook outlook;
  std::size_t first_contact = 0;           ///< of this window, in the world's list
  std::uint32_t runs = 0;                  ///< of all islands that are not settled, in this window
  Glances glances;                         ///< of each ball
  BroadPhase broad_phase;                  ///< of what each ball would sweep if no other were there
  std::vector<IslandWork> work;            ///< of each worker
  std::vector<std::size_t> ends;           ///< of the lists of islands that have to run, one after the other
  std::vector<std::uint32_t> found, near;  ///< balls near a pile; a list for a moment
  std::vector<CoarseBox> near_boxes;       ///< of those near a pile
  std::vector<Place> order;                ///< of the window's contacts
  std::vector<std::uint32_t> crowded;      ///< balls of an island with events without end, see handover.h

  /// Takes the memory for so many balls now, not while the world moves on.
  void reserve(std::size_t balls, std::size_t workers);

  /// Ball i is elsewhere than it was when the outlook began: after addToGrid() in what it sweeps.
  void announce(IslandWork& its_work, std::uint32_t i)
  {
    glances[i].added = true;
    its_work.added.push_back(i);
    broad_phase.announce(i, busy(i).swept, its_work.announced);
  }
  void addToGrid(Workers& workers) { broad_phase.add(work, &IslandWork::announced, workers); }
  /// Ball i may have an event with a body before the outlook ends.
  void noteDue(IslandWork& its_work, std::uint32_t i)
  {
    if (glances[i].due) return;
    glances[i].due = true;
    its_work.due.push_back(i);
  }

  /// Lists whose boxes overlap this one, for eachNear(): their glances come through memory until then.
  template <class AnyBox>
  void listNear(const AnyBox& box, NearList& list) const
  {
    const std::size_t before = list.entries.size();
    broad_phase.listOverlapping(box, list.entries);
    for (std::size_t e = before; e < list.entries.size(); ++e) glances.fetch(list.entries[e] & ~BroadPhase::kAdded);
    list.ends.push_back(list.entries.size());
  }
  /// Calls action(k) for every ball k but i itself that was listed in the c-th place; for some twice.
  template <class Action>
  void eachNear(std::uint32_t i, const NearList& list, std::size_t c, const Action& action) const
  {
    for (std::size_t e = c == 0 ? 0 : list.ends[c - 1]; e < list.ends[c]; ++e)
    {
      const std::uint32_t entry = list.entries[e], k = entry & ~BroadPhase::kAdded;
      if (k != i && (entry != k || !glances[k].added)) action(k);
    }
  }
};

/// What a world was made of. It never changes, so that a world and its copies share it.
struct SharedScene
{
  std::shared_ptr<const Scene> loaded;
  const Scene& scene;  ///< the same

  explicit SharedScene(std::shared_ptr<const Scene> its) : loaded(std::move(its)), scene(*loaded) {}
  SharedScene(const SharedScene&) = default;
  SharedScene& operator=([[maybe_unused]] const SharedScene& same)  ///< and no other
  {
    assert(loaded == same.loaded);
    return *this;
  }
};

/// After an assignment, ownWhatPoints() is to be called.
struct WorldState : Records, SharedScene
{
  explicit WorldState(std::shared_ptr<const Scene> its_scene) : SharedScene(std::move(its_scene)) {}
  WorldState(const WorldState&) = delete;
  WorldState& operator=(const WorldState&) = default;

  Method method = Method::Exact;          ///< in use: never Auto
  bool flies_in_steps = false;            ///< paths in the air are steps of scene.dt, else of what the tolerance permits
  double time = 0.0;  ///< [s]
  BallTypes types;
  std::vector<BallRecord> balls;
  std::vector<BodyRecord> bodies;
  bool any_moving = false;                ///< any body, in this window
  IslandRecords islands;
  Pile pile;
  Workers workers;                        ///< as many as the scene names threads, once there are balls to share

  /// Its record will be changed soon: until then it comes through memory.
  void fetch(std::size_t i) const
  {
    const char* record = reinterpret_cast<const char*>(&balls[i]);
    for (std::size_t byte = 0; byte < sizeof(BallRecord); byte += 64) fetchToWrite(record + byte);
  }
  const Surface& surface(const BallRecord& ball, const Shape& shape) const
  {
    return scene.surfaces.at(ball.params().material, shape.material);
  }
  const Surface& surface(const BallRecord& a, const BallRecord& b) const
  {
    return scene.surfaces.at(a.params().material, b.params().material);
  }
};

/// Of a world that was assigned another one: what pointed into that one points into its own records, or nowhere.
void ownWhatPoints(WorldState& world);

/// Puts a still body at a pose and flattens its shapes into the world frame.
void placeBody(BodyRecord& body, Pose pose);
}  // namespace ping_pong
