// What the contact solver keeps of each ball: lists with one entry for each, at the same place in all of them, its "slot".
#pragma once

#include <cstdint>
#include <vector>

#include "ping_pong_sim/types.h"

namespace ping_pong
{
/// A ball that does not leave a sphere of this radius about its anchor stays in its place, and may fall asleep there [m].
inline constexpr float kRestRadius = 1e-4f;

/// Where a ball is and how it moves: what the search for impacts needs. One cache line.
struct alignas(64) Mover
{
  Vector3d p = Vector3d::Zero();  ///< within a step where the path that it now has would have begun [m]
  Vector3d v = Vector3d::Zero();  ///< [m/s]
  double clock = 0.0;             ///< of its last impact, from the start of the step [s]
  std::uint32_t last_impact = 0;  ///< when it last had an impact, on the counter of the solver
  std::uint16_t type = 0;
  std::uint8_t impacts = 0;  ///< in this step
  bool asleep : 1;
  bool carried : 1;               ///< something carries it: forces act with the contacts, not before them
  bool was_carried : 1;           ///< at the start of the step
  bool half_kick_due : 1;         ///< forces of the last half step are still to act
  bool kept_awake : 1;            ///< by a neighbour that is not still
  bool too_slow_for_impacts : 1;  ///< carried, and slower than half the least impact: two such balls have none

  Mover()
      : asleep(false),
        carried(false),
        was_carried(false),
        half_kick_due(false),
        kept_awake(false),
        too_slow_for_impacts(false)
  {
  }
};

static_assert(sizeof(Mover) == 64, "one cache line");

/// What the contacts of this step change of a ball, and what of it they ask for. One cache line.
struct alignas(64) Change
{
  Eigen::Vector4f v = Eigen::Vector4f::Zero();  ///< of its velocity [m/s], and 1 / mass, 0 while asleep [1/kg]
  Eigen::Vector4f surface_velocity = Eigen::Vector4f::Zero();  ///< of radius times spin [m/s], and 1 / (k mass) [1/kg]
  Eigen::Vector4f before = Eigen::Vector4f::Zero();            ///< radius times spin before the contacts [m/s], and 0
  Eigen::Vector4f p = Eigen::Vector4f::Zero();                 ///< of its place, against overlap [m], and 0
};
static_assert(sizeof(Change) == 64, "one cache line");

/// The last hit of a ball by a moving body.
struct BodyHit
{
  double time = -1e300;  ///< [s]
  std::uint16_t body = 0;
  bool other = false;  ///< the ball has hit something else since
};

struct SolverBodies
{
  static constexpr std::uint8_t kCarried = 1;  ///< by something that presses on it,
  static constexpr std::uint8_t kByBall = 2;   ///< and that is another ball

  std::vector<std::uint32_t> ball;  ///< its index in WorldWithSolver::balls
  std::vector<Mover> movers;
  std::vector<Vector3d> w;                 ///< spin [rad/s]
  std::vector<Quaterniond> q;              ///< but for
  std::vector<Vector3d> pending_rotation;  ///< rotation since that is not in q yet, as a rotation vector [rad]
  std::vector<Change> changes;
  std::vector<std::uint32_t>
      last_iteration;  ///< the iteration over constraints that last changed it, on the counter of the solver
  std::vector<std::uint8_t> carried_by;  ///< in this step: kCarried, kByBall or both
  std::vector<Vector3d> a;               ///< acceleration, where it is not constant [m/s^2]
  std::vector<Vector3d> home;            ///< where it was when neighbours were searched [m]
  std::vector<Eigen::Vector3f>
      displacement;  ///< way from there along which they were searched, and by the margin around it [m]
  std::vector<Eigen::Vector3f> anchor;  ///< place that it has not left for the time `still`, from home [m]
  std::vector<float> still;             ///< [s]
  std::vector<float> since_contact;     ///< time since its last contact with another ball [s]
  std::vector<BodyHit> last_hits;
  std::vector<Vector3d>
      start_positions;  ///< where it was at the start of the step, if a moving body is near any ball [m]
};

/// Calls action(list) for each of these lists. @param with_a  `a`, too: it has no entries where accelerations are constant
template <typename Action>
void eachSlotList(SolverBodies& slots, bool with_a, const Action& action)
{
  auto& [ball, movers, w, q, pending_rotation, changes, last_iteration, carried_by, a, home, displacement, anchor,
         still, since_contact, last_hits, start_positions] = slots;  // does not compile if one is left out
  const auto each = [&action](auto&... lists) { (action(lists), ...); };
  each(ball, movers, w, q, pending_rotation, changes, last_iteration, carried_by, home, displacement, anchor, still,
       since_contact, last_hits, start_positions);
  if (with_a) action(a);
}

/// The same for those of a solver that has balls.
template <typename Action>
void eachSlotList(SolverBodies& slots, const Action& action)
{
  eachSlotList(slots, !slots.a.empty(), action);
}
}  // namespace ping_pong
