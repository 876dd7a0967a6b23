// What a body that has jumped covers, and what lay on it.
#include "evolve/flight.h"
#include "geometry/tolerances.h"
#include "state/free_space.h"
#include "state/squeeze.h"
#include "world/world_impl.h"

namespace ping_pong
{
namespace
{
constexpr std::size_t kManyBalls = 32;  // from here on a grid tells which balls may overlap

// Whether two balls overlap by more than half of what hasRoom() lets pass.
bool spheresOverlap(const BallRecord& a, const BallRecord& b, double time)
{
  const double reach = a.params().radius + b.params().radius - 0.5 * kOverlapTolerance;
  return (a.path.position(time - a.path.start) - b.path.position(time - b.path.start)).squaredNorm() < reach * reach;
}
}  // namespace

// After a body has jumped: balls that it covers are put on its surface, and push on others in turn. A ball that finds no room
// is squeezed, where it is. (In the contact solver balls may overlap a little, and push each other out.)
void World::Impl::resolveOverlaps()
{
  const std::vector<char> overlapping = ballsThatOverlap();
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const bool in_solver = balls[i].ofSolver();
    BallState state = balls[i].stateAt(time);
    const double radius = balls[i].params().radius;
    const bool free = in_solver        ? !overlapsABody(*this, state.p_WB, radius)
                      : overlapping[i] ? hasRoom(*this, state.p_WB, radius, i)
                                       : hasRoomAmongBodies(*this, state.p_WB, radius);
    if (free) continue;
    const BallState covered = state;
    const bool room = pushOut(*this, state.p_WB, radius, i);  // clear of all others: none is covered that was not
    if (room)
      balls[i].path = flyParabola(state, time, Vector3d::Zero());
    else if (!in_solver)
      squeeze(*this, balls[i], covered, time);
  }
}

// Balls that surely overlap no other one are left out; of few balls none is.
std::vector<char> World::Impl::ballsThatOverlap()
{
  std::vector<char> overlapping(balls.size(), balls.size() < kManyBalls);
  if (balls.size() < kManyBalls) return overlapping;
  BroadPhase& grid = islands.broad_phase;  // of the next window: its memory is there
  grid.build(
      balls.size(), [&](std::size_t i) { return boxOf(balls[i], time, time); }, workers);
  grid.eachPair(
      [&](std::uint32_t a, std::uint32_t b)
      {
        if (spheresOverlap(balls[a], balls[b], time)) overlapping[a] = overlapping[b] = true;
      });
  return overlapping;
}

// Balls on this body search anew for what carries them.
void World::Impl::detachFrom(std::size_t body)
{
  for (BallRecord& ball : balls)
  {
    bool lay_there = false;
    for (std::size_t i = 0; i < ball.supports.count(); ++i) lay_there |= ball.supports[i].body == body;
    if (lay_there) ball.supports = Supports();
  }
}
}  // namespace ping_pong
