// Balls that are stepped together with the contact solver of method `impulse`: what it keeps of them, as compact records.
//
// Everything is done in the order of these lists, which follows from the states alone: the same bits on every run, with any
// number of threads. These work on slabs of the solver, see slabs.h.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ping_pong_sim/forces.h"
#include "ping_pong_sim/types.h"
#include "solver/contact_batches.h"
#include "solver/neighbours.h"
#include "solver/solver_bodies.h"
#include "state/world_state.h"

namespace ping_pong
{
/// What balls of one type have in common.
struct SolverBallType
{
  BallParams params;
  FlightModel model;
  Vector3d a = Vector3d::Zero();  ///< acceleration in flight, if it is constant [m/s^2]
  double spin_per_impulse = 0.0;  ///< 1 / (k r): spin is this times impulse / mass [1/m]
  double inverse_mass = 0.0;      ///< [1/kg]
  double slip_per_impulse = 0.0;  ///< 1 + 1/k: slip of the touching point is this times impulse / mass
};

struct BodyConstraint
{
  Vector3d u;  ///< velocity of the touched point of the body [m/s]
  std::uint32_t neighbour;
  ConstraintIndex index;  ///< among the batches
  std::uint32_t ball;     ///< slot
  std::uint16_t material;
  bool moving;  ///< the neighbour is a moving body
};

/// A ball that has no room, and the place where it was last whole.
struct SqueezedBall
{
  std::uint32_t ball;  ///< its index in WorldWithSolver::balls
  Vector3d p_WB;       ///< [m]
};

/// An impact in this step, if nothing happens to its balls before.
struct PredictedImpact
{
  double time;                 ///< from the start of the step [s]
  NeighbourRef neighbour;      ///< of impacts at the same time the least comes first
  std::uint32_t predicted_at;  ///< on the counter of the solver
};
static_assert(sizeof(PredictedImpact) == 16, "a heap of them");

/// A slab of the solver: its balls, their neighbours, and what a step notes of them. Lists of neighbours are
/// in the order of their indices.
struct SolverSlab
{
  std::vector<std::uint32_t> balls, awake;                 ///< slots: all, and those awake
  std::vector<std::uint32_t> pairs, bodies;                ///< neighbours
  std::vector<std::uint32_t> active_pairs, active_bodies;  ///< those with an end that is awake
  std::vector<BodyConstraint> body_constraints;
  std::vector<ConstraintBatch> pair_batches, body_batches;
  OpenBatches open_pairs, open_bodies;  ///< of these, while constraints are listed
  std::vector<FoundPair> found;         ///< of each lane in pair_batches, then
  std::vector<std::uint32_t> pair_of;   ///< of each lane
  std::vector<PredictedImpact> ahead;   ///< found by a search through all neighbours
  std::vector<std::uint32_t> leaving;   ///< slots of balls that leave the way that their neighbours were searched along
  std::vector<std::uint32_t> waking;    ///< slots to wake up at the end of the step
  double fastest_squared = 0.0;         ///< speed of a ball before the contacts of this step [m^2/s^2]
  std::uint32_t squeezed = 0;           ///< balls deep in a body at the start of this step
  std::uint32_t changed = 0;            ///< when an iteration last changed something here, on the counter of the solver
  bool active_void = false;             ///< somebody fell asleep or woke up
  bool not_finite = false;              ///< in this step
};

/// Cells of a uniform grid with the balls in each, by the boxes that they may sweep.
struct NeighbourGrid
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

struct ContactSolver : SolverBodies
{
  static constexpr std::uint32_t kEndOfList = ~0u;
  static constexpr std::size_t kMostSlabs = 16;

  std::vector<SolverBallType> ball_types;
  std::vector<NeighbourPair> pairs;
  std::vector<Lanes> impulses;  ///< of each pair in the last step: of friction, and along the normal, >= 0 [N s]
  std::vector<float>
      force_at_sleep;  ///< of each pair: normal force when one of them fell asleep; < 0 if not one alone sleeps [N]
  std::vector<BodyNeighbour> bodies;             ///< with still bodies
  std::vector<BodyNeighbour> moving;             ///< with moving bodies, for this step
  std::array<SolverSlab, kMostSlabs + 1> slabs;  ///< of these the last one is for pairs that reach farther
  std::size_t slab_count = 1;
  std::vector<std::uint8_t> slab_of;      ///< of each ball, since neighbours were searched
  std::vector<PairEnd> first_pair;        ///< of each ball, the beginning of its list in `pairs`
  std::vector<std::uint32_t> first_body;  ///< the same in `bodies`
  std::vector<PredictedImpact> ahead;     ///< heap, the next one on top
  std::vector<SqueezedBall> squeezed;     ///< found in this step, by index
  std::vector<KeptPair> old_kept;
  std::vector<BodyNeighbour> old_bodies;
  std::vector<std::uint32_t> old_slot, new_slot;  ///< scratch
  NeighbourGrid grid;
  std::array<std::vector<NeighbourPair>, kMostSlabs> found;  ///< pairs of a part of the grid each
  float margin = 0.0f;                                       ///< around ways that neighbours are searched along [m]
  std::uint32_t counter = 1;  ///< goes up with every impact and every iteration over constraints; see restartCounter()
  std::uint32_t steps = 0;
  std::uint32_t step_mark = 0;  ///< the counter at the start of the step
  unsigned body_versions = 0;   ///< sum, when neighbours were searched
  bool neighbours_void = true;
  double h = 0.0;                 ///< length of the step [s]
  double start = 0.0, end = 0.0;  ///< of the step [s]
  double pressing =
      0.0;  ///< speed of the fastest moving body that presses on a ball in this step, 0 if none does [m/s]
  double least_impact = 0.0;  ///< of the first impact in a step [m/s]

  /// Slower is no impact but a contact [m/s]: after each impact in a step four times as much, or a jam would have no end.
  double leastImpact(int impacts) const { return least_impact * static_cast<double>(1 << (2 * impacts)); }
  const Vector3d& flightAcceleration(std::size_t i) const { return a.empty() ? ball_types[movers[i].type].a : a[i]; }
  /// On its path within the step, before contacts: what carries a ball also bears its weight.
  Vector3d pathAcceleration(std::size_t i) const
  {
    return movers[i].carried || movers[i].asleep ? Vector3d(Vector3d::Zero()) : flightAcceleration(i);
  }
  /// Distance of the centres of two balls that touch [m].
  double reach(std::size_t i, std::size_t k) const
  {
    return ball_types.size() == 1 ? 2.0 * ball_types.front().params.radius : radius(i) + radius(k);
  }
  double radius(std::size_t i) const { return ball_types[movers[i].type].params.radius; }
  /// Action on the index of every pair of a ball in `pairs`, the last one made first, until it returns true: then true.
  template <typename Action>
  bool anyPair(std::uint32_t ball, const Action& action) const
  {
    for (PairEnd end = first_pair[ball]; !end.isEnd();)
    {
      const NeighbourPair& pair = pairs[end.pair];
      const PairEnd next = end.is_b ? pair.next_b : pair.next_a;
      if (action(end.pair)) return true;
      end = next;
    }
    return false;
  }
  const BallParams& params(std::size_t i) const { return ball_types[movers[i].type].params; }

  SolverSlab& lastSlab() { return slabs.back(); }
  void wake(std::size_t i);
  /// Ball i fell asleep or woke up: who is awake in the slabs of its neighbours is not known.
  void voidActive(std::size_t i);
  bool anyAwake() const;
};

/// The world as the contact solver sees it.
struct WorldWithSolver : WorldState
{
  using WorldState::WorldState;

  ContactSolver solver;
};

/// As many as there are if it is not in the solver.
std::uint32_t slotOf(const ContactSolver& solver, std::uint32_t ball);
/// Takes a ball of the world in, at its state then.
void addToSolver(WorldWithSolver& world, std::uint32_t ball, double time);
/// Takes it out, and wakes up who lay on it.
void dropFromSolver(ContactSolver& solver, std::uint32_t ball);
/// The same before the ball leaves WorldWithSolver::balls, where later ones move up.
void removeFromSolver(ContactSolver& solver, std::uint32_t ball);
/// Takes over the states of all balls that it has, and wakes them up: bodies or balls have been put elsewhere.
void disturbSolver(WorldWithSolver& world);
/// Takes over the state of a ball that is in the solver, and wakes it up.
void restateInSolver(WorldWithSolver& world, std::uint32_t ball);
void clearSolver(ContactSolver& solver);
/// Takes the memory for so many balls now, not while the world moves on.
void reserveSolver(WorldWithSolver& world, std::size_t balls);
/// Turns the ball by what it has turned since it was last told: closed form, without trigonometry where that is little.
void applyRotation(ContactSolver& solver, std::size_t slot);
/// Puts the state of a ball into its record.
void storeBall(WorldWithSolver& world, std::size_t slot, double time);
/// Wakes up balls that touch a sphere, or nearly.
void wakeNear(ContactSolver& solver, const Vector3d& p_WB, double radius);

/// Steps of equal length from `start` to `end`; then writes the states of balls that have moved into the records of the
/// world.
void stepSolver(WorldWithSolver& world, double start, double end, double longest_step);

/// Neighbours are void: the impulses between them are kept by their balls until there are new ones.
void saveImpulses(ContactSolver& solver);

// --- parts of a step, in this order ---

/// Which balls and shapes may touch in this step: searched anew if a ball may leave the way along which they were.
void updateNeighbours(WorldWithSolver& world);
/// The same for two balls that an impact has thrown off their way; true if all neighbours are new.
bool updateNeighboursAfterImpact(WorldWithSolver& world, std::uint32_t a, std::uint32_t b);
/// Lists of what is awake, where anybody fell asleep or woke up.
void updateActive(WorldWithSolver& world);
/// Impacts in the step: located on the paths, resolved one by one, the next one first.
void resolveImpacts(WorldWithSolver& world);
/// Contacts that carry load: impulses such that nothing is pressed into another, with friction.
void solveContacts(WorldWithSolver& world);
/// What they change of the balls of a slab.
void applyContacts(WorldWithSolver& world, const SolverSlab& slab);
/// Balls that have not moved for a while and whom nobody disturbs fall asleep; whom somebody disturbs wakes up.
void updateSleep(WorldWithSolver& world);
}  // namespace ping_pong
