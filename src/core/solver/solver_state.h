// Balls that are stepped together with the contact solver of method `impulse`: what it keeps of them, as compact records.
//
// Everything is done in the order of these lists, which follows from the states alone: the same bits on every run, with any
// number of threads. What they share is a pile cut into slabs, see slabs.h.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ping_pong_sim/forces.h"
#include "ping_pong_sim/types.h"
#include "solver/contact_batches.h"
#include "solver/solver_bodies.h"
#include "state/world_state.h"

namespace ping_pong
{
/// What balls of one make have in common.
struct BallKind
{
  BallParams params;
  FlightModel model;
  Vector3d a = Vector3d::Zero();  ///< acceleration in flight, if it is constant [m/s^2]
  double spin_per_impulse = 0.0;  ///< 1 / (k r): spin is this times impulse / mass [1/m]
  double inverse_mass = 0.0;      ///< [1/kg]
  double give = 0.0;              ///< 1 + 1/k: slip of the touching point is this times impulse / mass
};

/// A link in the chain of one of its two balls.
struct PairEnd
{
  std::uint32_t pair : 31;  ///< index of the link
  std::uint32_t is_b : 1;   ///< the chain is that of its ball b

  static PairEnd endOfChain() { return {~0u >> 1, 1}; }
  bool isEnd() const { return pair == ~0u >> 1; }
};
static_assert(sizeof(PairEnd) == 4, "there are thousands of links");

/// Two balls that may touch soon. Each ball has a chain of its links: see anyLink().
struct PairLink
{
  std::uint32_t a, b;      ///< slots; normals point from b to a
  PairEnd next_a, next_b;  ///< of the chains of a and b
};

/// A ball and a shape that may touch soon.
struct BodyLink
{
  std::uint32_t ball;
  std::uint32_t next;  ///< link of this ball with a still body
  std::uint16_t body, shape;
  Lanes push{};  ///< in the last step: of friction, and along the normal, >= 0 [N s]
};

/// What is kept of a pair in touch while the links are built anew.
struct KeptPair
{
  std::uint32_t a, b;
  float held;  ///< see Pile
  Lanes push;  ///< see Pile
};

struct BodyTouch
{
  Vector3d u;  ///< velocity of the touched point of the body [m/s]
  std::uint32_t link;
  LanePlace place;      ///< among the batches
  std::uint32_t ball;   ///< slot
  std::uint16_t material;
  bool moving;  ///< link of a moving body
};

/// A ball that has no room, and the place where it was last whole.
struct SqueezedBall
{
  std::uint32_t ball;  ///< its index in WorldWithSolver::balls
  Vector3d p_WB;       ///< [m]
};

/// What meets: a link in one of the three lists of a pile.
struct LinkName
{
  enum List : std::uint32_t
  {
    Pairs,
    StillBodies,
    MovingBodies
  };
  std::uint32_t index : 30;
  std::uint32_t list : 2;

  bool operator>(const LinkName& other) const
  {
    return index != other.index ? index > other.index : list > other.list;
  }
};

/// An impact in this step, if nothing happens to its balls before.
struct ImpactAhead
{
  double time;         ///< from the start of the step [s]
  LinkName link;       ///< of impacts at the same time the least comes first
  std::uint32_t made;  ///< on the counter of the pile
};
static_assert(sizeof(ImpactAhead) == 16, "a heap of them");

/// A slab of the pile: its balls, the links of which it has the first ball, and what a step notes of them. Lists of links are
/// in the order of their indices.
struct PileShare
{
  std::vector<std::uint32_t> balls, awake;                 ///< slots: all, and those awake
  std::vector<std::uint32_t> pairs, bodies;                ///< links
  std::vector<std::uint32_t> active_pairs, active_bodies;  ///< those with an end that is awake
  std::vector<BodyTouch> body_touches;
  std::vector<TouchBatch> pair_batches, body_batches;
  OpenBatches open_pairs, open_bodies;    ///< of these, while touches are listed
  std::vector<FoundPair> found;           ///< of each place in pair_batches, then
  std::vector<std::uint32_t> pair_links;  ///< of each place
  std::vector<ImpactAhead> ahead;         ///< found by a look at all links
  std::vector<std::uint32_t> leaving;     ///< slots of balls that leave the way that their links cover
  std::vector<std::uint32_t> waking;      ///< slots to wake up at the end of the step
  double fastest_squared = 0.0;           ///< speed of a ball before the contacts of this step [m^2/s^2]
  std::uint32_t squeezed = 0;             ///< balls deep in a body at the start of this step
  std::uint32_t changed = 0;              ///< when a sweep last changed something here, on the counter of the pile
  bool active_void = false;               ///< somebody fell asleep or woke up
  bool not_finite = false;                ///< in this step
};

/// Cells of a uniform grid with the balls in each, by the boxes that they may sweep.
struct PileGrid
{
  struct Entry
  {
    Eigen::Vector3f centre, half;  ///< of the box of a ball, from the origin of the grid [m]
    float round;                   ///< radius of a sphere about the same centre that contains its way, too [m]
    std::uint32_t slot;
  };
  Vector3d origin = Vector3d::Zero();
  double cells_per_metre = 1.0;
  float large_edge = 0.0f;  ///< boxes with a longer edge are not in the cells [m]
  std::array<int, 3> count{1, 1, 1};
  std::vector<std::uint32_t> start;  ///< of each cell in `entries`
  std::vector<std::uint32_t> cell;   ///< of each ball
  std::vector<Entry> entries;        ///< by cell
  std::vector<Entry> large;
  std::vector<Entry> strays;  ///< balls that have left their box since, with their new one

  int cellAt(double x, int axis) const;
};

struct Pile : PileSlots
{
  static constexpr std::uint32_t kEndOfChain = ~0u;
  static constexpr std::size_t kMostSlabs = 16;

  std::vector<BallKind> kinds;
  std::vector<PairLink> pairs;
  std::vector<Lanes> pushes;  ///< of each pair in the last step: of friction, and along the normal, >= 0 [N s]
  std::vector<float>
      held;  ///< of each pair: normal force when one of them fell asleep; < 0 if not one alone sleeps [N]
  std::vector<BodyLink> bodies;                  ///< with still bodies
  std::vector<BodyLink> moving;                  ///< with moving bodies, for this step
  std::array<PileShare, kMostSlabs + 1> shares;  ///< slabs; the last one has the links that go farther
  std::size_t slabs = 1;
  std::vector<std::uint8_t> share_of;     ///< slab of each ball, since the links were built
  std::vector<PairEnd> first_link;        ///< of each ball, the beginning of the chain of its links in `pairs`
  std::vector<std::uint32_t> first_body;  ///< the same in `bodies`
  std::vector<ImpactAhead> ahead;         ///< heap, the next one on top
  std::vector<SqueezedBall> squeezed;     ///< found in this step, by index
  std::vector<KeptPair> old_kept;
  std::vector<BodyLink> old_bodies;
  std::vector<std::uint32_t> old_slot, new_slot;  ///< scratch
  PileGrid grid;
  std::array<std::vector<PairLink>, kMostSlabs> found;  ///< links of a part of the grid each
  float margin = 0.0f;                                  ///< of the links [m]
  std::uint32_t counter = 1;  ///< goes up with every impact and every sweep over touches; see restartCounter()
  std::uint32_t steps = 0;
  std::uint32_t step_mark = 0;  ///< the counter at the start of the step
  unsigned body_versions = 0;   ///< sum, when the links were built
  bool links_void = true;
  double h = 0.0;                 ///< length of the step [s]
  double start = 0.0, end = 0.0;  ///< of the step [s]
  double pressing =
      0.0;  ///< speed of the fastest moving body that presses on a ball in this step, 0 if none does [m/s]
  double least_impact = 0.0;  ///< of the first impact in a step [m/s]

  /// Slower is no impact but a contact [m/s]: after each impact in a step four times as much, or a jam would have no end.
  double leastImpact(int impacts) const { return least_impact * static_cast<double>(1 << (2 * impacts)); }
  const Vector3d& flightAcceleration(std::size_t i) const { return a.empty() ? kinds[movers[i].kind].a : a[i]; }
  /// On its path within the step, before contacts: what carries a ball also bears its weight.
  Vector3d pathAcceleration(std::size_t i) const
  {
    return movers[i].loaded || movers[i].asleep ? Vector3d(Vector3d::Zero()) : flightAcceleration(i);
  }
  /// Distance of the centres of two balls that touch [m].
  double reach(std::size_t i, std::size_t k) const
  {
    return kinds.size() == 1 ? 2.0 * kinds.front().params.radius : radius(i) + radius(k);
  }
  double radius(std::size_t i) const { return kinds[movers[i].kind].params.radius; }
  /// Action on the index of every link of a ball in `pairs`, the last one made first, until it returns true: then true.
  template <typename Action>
  bool anyLink(std::uint32_t ball, const Action& action) const
  {
    for (PairEnd end = first_link[ball]; !end.isEnd();)
    {
      const PairLink& link = pairs[end.pair];
      const PairEnd next = end.is_b ? link.next_b : link.next_a;
      if (action(end.pair)) return true;
      end = next;
    }
    return false;
  }
  const BallParams& params(std::size_t i) const { return kinds[movers[i].kind].params; }

  PileShare& lastShare() { return shares.back(); }
  void wake(std::size_t i);
  /// Ball i fell asleep or woke up: who is awake in the shares of its links is not known.
  void voidActive(std::size_t i);
  bool anyAwake() const;
};

/// The world as the contact solver sees it.
struct WorldWithSolver : WorldState
{
  using WorldState::WorldState;

  Pile pile;
};

/// As many as there are if it is not in the pile.
std::uint32_t slotOf(const Pile& pile, std::uint32_t ball);
/// Takes a ball of the world in, at its state then.
void addToPile(WorldWithSolver& world, std::uint32_t ball, double time);
/// Takes it out, and wakes up who lay on it.
void dropFromPile(Pile& pile, std::uint32_t ball);
/// The same before the ball leaves WorldWithSolver::balls, where later ones move up.
void removeFromPile(Pile& pile, std::uint32_t ball);
/// Takes over the states of all balls that it has, and wakes them up: bodies or balls have been put elsewhere.
void disturbPile(WorldWithSolver& world);
/// Takes over the state of a ball that is in the pile, and wakes it up.
void restatePile(WorldWithSolver& world, std::uint32_t ball);
void clearPile(Pile& pile);
/// Takes the memory for so many balls now, not while the world moves on.
void reservePile(WorldWithSolver& world, std::size_t balls);
/// Turns the ball by what it has turned since it was last told: closed form, without trigonometry where that is little.
void takeTurn(Pile& pile, std::size_t slot);
/// Puts the state of a ball into its record.
void storeBall(WorldWithSolver& world, std::size_t slot, double time);
/// Wakes up balls that touch a sphere, or nearly.
void wakeNear(Pile& pile, const Vector3d& p_WB, double radius);

/// Steps of equal length from `start` to `end`; then writes the states of balls that have moved into the records of the
/// world.
void runPile(WorldWithSolver& world, double start, double end, double longest_step);

/// Links are void: what is known of them is kept by their balls until there are new ones.
void detachKept(Pile& pile);

// --- parts of a step, in this order ---

/// Which balls and shapes may touch in this step: links them anew if a ball may leave the way that the links cover.
void updateLinks(WorldWithSolver& world);
/// The same for two balls that an impact has thrown off their way; true if the links are new.
bool updateLinksAfterImpact(WorldWithSolver& world, std::uint32_t a, std::uint32_t b);
/// Lists of what is awake, where anybody fell asleep or woke up.
void updateActive(WorldWithSolver& world);
/// Impacts in the step: located on the paths, resolved one by one, the next one first.
void resolveImpacts(WorldWithSolver& world);
/// Contacts that carry load: impulses such that nothing is pressed into another, with friction.
void solveContacts(WorldWithSolver& world);
/// What they change of the balls of a share.
void takeContacts(WorldWithSolver& world, const PileShare& share);
/// Balls that have not moved for a while and whom nobody disturbs fall asleep; whom somebody disturbs wakes up.
void settlePile(WorldWithSolver& world);
}  // namespace ping_pong
