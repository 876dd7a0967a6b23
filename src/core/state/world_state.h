// What all methods share: every ball, every body, and the records of the tick.
#pragma once

#include <cassert>
#include <memory>
#include <utility>
#include <vector>

#include "base/pooled.h"
#include "base/prefetch.h"
#include "base/thread_pool.h"
#include "detect/first_contact.h"
#include "evolve/parabola.h"
#include "evolve/segment.h"
#include "geometry/aabb.h"
#include "ping_pong_sim/contact.h"
#include "ping_pong_sim/scene.h"
#include "ping_pong_sim/step_status.h"
#include "state/ball_types.h"
#include "state/supports.h"

namespace ping_pong
{
/// The next thing that happens to a ball.
struct Event
{
  enum class Kind : std::uint8_t
  {
    None,
    Horizon,    ///< the search ended here without an answer: it goes on from there
    LeaveFace,  ///< the path on the supporting surfaces ends
    HitBody,
    HitBall
  };
  static constexpr std::uint32_t kNobody = ~0u;

  double time = kNever;           ///< world time [s]
  std::uint32_t other = kNobody;  ///< index of body or ball
  std::uint32_t version = 0;      ///< of the other when this was predicted: another one makes it void
  std::uint16_t shape = 0;        ///< of the body
  Kind kind = Kind::None;
};

/// What concerns a ball in this window only, and not all balls.
struct TransientPredictions
{
  Event moving;  ///< with moving bodies
  Event ball;    ///< with balls of the same island, while that runs
};

/// Who moves a ball.
enum class BallOwner : std::uint8_t
{
  Method,  ///< the scene's method, on paths or in steps of its own
  Solver,  ///< the contact solver: every ball of `impulse`, and what `exact` has handed over, see solver_handover.h
  SolverAsleep,   ///< the same; at rest until something wakes it, see sleep.cpp
  Nobody,         ///< squeezed: it has no room, and is given back to the method when it has
  NobodyOfSolver  ///< the same, given back to the solver
};

/// Thousands of them are a long way through memory: what many have in common, and what few have, is elsewhere, and small
/// members are where larger ones end before their last byte.
struct BallRecord
{
  const BallType* type;
  [[no_unique_address]] Event next;  ///< with still bodies; holds until the path changes
  BallOwner owner : 7;
  bool overflows : 1;  ///< a step of fixed length from here has no finite end: the path goes straight on
  std::uint16_t instant_contacts = 0;  ///< contacts in even quicker succession
  std::uint8_t quick_contacts = 0;     ///< contacts in quick succession, see collapse_guard.h
  std::uint8_t frequent_contacts = 0;  ///< contacts with other balls since `frequent_since`, see hand_off_rule.h
  Pooled<TransientPredictions> transient;
  Supports supports;
  [[no_unique_address]] Segment path;
  BallId id;
  double last_contact = -1e300;   ///< [s]
  float frequent_since = -1e30f;  ///< [s]
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

  /// When it meets a ball or a moving body, as far as that is predicted; kNever if it does not.
  double meetsBall() const { return transient ? transient->ball.time : kNever; }
  double meetsMoving() const { return transient ? transient->moving.time : kNever; }
  void expectNothing()
  {
    next = Event();
    if (transient) transient->moving = transient->ball = Event();
  }
  /// As between runs of islands.
  void expectNoBall()
  {
    if (meetsMoving() == kNever) return transient.reset();
    transient->ball = Event();
  }
};
static_assert(sizeof(BallRecord) <= 224, "a crowd has thousands: see docs/crowd_cost.md");

inline const Event& nextEvent(const BallRecord& ball)
{
  if (!ball.transient) return ball.next;
  const TransientPredictions& transient = *ball.transient;
  const Event& with_body = transient.moving.time < ball.next.time ? transient.moving : ball.next;
  return transient.ball.time < with_body.time ? transient.ball : with_body;
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
  return {(p.cwiseMin(q) - bulge.cwiseMax(0.0)).array() - radius,
          (p.cwiseMax(q) - bulge.cwiseMin(0.0)).array() + radius};
}

struct BodyRecord
{
  Body body;
  BodyMotion motion;  ///< from its start on; still bodies have none
  PaddleCommand command;
  bool moving = false;
  bool moved = false;    ///< in the window before
  bool blocked = false;  ///< a static body has stopped it in this tick
  unsigned version = 0;
  std::vector<Shape> placed;  ///< the shapes in the world frame, for still bodies
  std::vector<Box> boxes;     ///< that contain them

  const std::vector<Shape>& shapes() const { return moving ? body.shapes : placed; }
  const BodyMotion& frame() const { return moving ? motion : kWorldFrame; }
  BodyFrame at(double time) const { return frameAt(frame(), time - frame().start); }
  /// A point given in W, in the frame of shapes() [m].
  Vector3d seenFrom(const Vector3d& p_WQ, double time) const
  {
    return moving ? motion.poseAt(time - motion.start).toB(p_WQ) : p_WQ;
  }

  static const BodyMotion kWorldFrame;
};

/// Which ball has recorded a contact, and in which run of its island: what an earlier one has recorded has not happened.
struct ContactProvenance
{
  std::uint32_t ball;
  std::uint32_t run;  ///< 0: the ball was alone
};

/// What the handling of events notes, besides the balls: of the world, or of one worker.
struct Records
{
  bool keep_contacts = true;  ///< else they are counted only
  std::vector<Contact> contacts;
  std::vector<ContactProvenance> provenances;  ///< by contact, in the exact method
  std::uint32_t run = 0;                       ///< of the island at work, for provenances
  StepStatus status;
  std::size_t pair_searches = 0;   ///< of balls with balls, in this window
  std::size_t near_pairs = 0;      ///< of balls whose boxes overlap, in this window
  bool frequent_contacts = false;  ///< a ball has met others too often, see hand_off_rule.h
  bool any_squeezed = false;       ///< a ball may be
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

/// What all methods share. After an assignment, ownTypes() is to be called.
struct WorldState : Records, SharedScene
{
  explicit WorldState(std::shared_ptr<const Scene> its_scene) : SharedScene(std::move(its_scene)) {}
  WorldState(const WorldState&) = delete;
  WorldState& operator=(const WorldState&) = default;

  Method method = Method::Exact;  ///< in use: never Auto
  bool flies_in_steps = false;    ///< paths in the air are steps of scene.dt, else of what the tolerance permits
  double time = 0.0;              ///< [s]
  BallTypes types;
  std::vector<BallRecord> balls;
  std::vector<BodyRecord> bodies;
  bool any_moving = false;  ///< any body, in this window
  std::uint32_t edits =
      0;  ///< raised by all that change balls or bodies outside of a window: what is remembered of them is void
  Workers workers;  ///< as many as the scene names threads, once there are balls to share

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

/// Of a world that was assigned another one: balls point to its own types.
void ownTypes(WorldState& world);

/// Puts a still body at a pose and flattens its shapes into the world frame.
void placeBody(BodyRecord& body, Pose pose);
}  // namespace ping_pong
