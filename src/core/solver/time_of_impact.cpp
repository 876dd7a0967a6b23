#include "solver/time_of_impact.h"

#include <algorithm>
#include <cmath>

#include "base/law_counter.h"
#include "evolve/flight.h"
#include "solver/seams.h"

namespace ping_pong
{
namespace
{
constexpr int kMostAdvances = 20;  // of a search, which converges quadratically: more only where a ball grazes an edge
constexpr int kMostSeams = 4;      // of a moving body that a ball passes in a step

// A ball on a face comes to the edge of the next shape in the same plane: no impact. When it will be past the edge, or kNever.
// @param v  its velocity relative to the body
double crossesSeam(const WorldWithSolver& world, const BodyNeighbour& neighbour, const Proximity& near,
                   const Vector3d& p, const Vector3d& v, double t)
{
  if (near.flat()) return t;
  const Seam seam = seamWith(world, neighbour, near, p, t);
  if (!seam.there) return t;
  const Vector3d way = seam.surface.distance * seam.surface.normal - near.distance * near.normal;
  const double along = way.dot(v);
  return along > 0.0 ? t + way.squaredNorm() / along : kNever;
}

// Advances as firstContact() does: the gap stays above its tangent parabola. On a straight line its rate only grows.
double stillImpact(const WorldWithSolver& world, const BodyNeighbour& neighbour)
{
  const ContactSolver& solver = world.solver;
  const std::uint32_t i = neighbour.ball;
  const Vector3d a = solver.pathAcceleration(i);
  const double most = a.norm(), least = solver.leastImpact(solver.movers[i].impacts);
  double t = solver.movers[i].clock;
  for (int step = 0; step < kMostAdvances; ++step)
  {
    const Vector3d p = placeAt(solver, i, t), v = velocityAt(solver, i, t);
    const Proximity near = nearestOf(world, neighbour, p, t);
    const double gap = near.distance - solver.radius(i), rate = near.normal.dot(v);
    if (rate >= most * (solver.h - t) - least) return kNever;  // nor is it faster later in this step
    if (gap <= touchTolerance(p, solver.radius(i)))
    {
      if (rate >= -least) return kNever;
      const double past = crossesSeam(world, neighbour, near, p, v, t);
      if (past == t) return t;
      t = past;
    }
    else
    {
      const double press = near.normal.dot(a);
      const double discriminant = rate * rate - 2.0 * press * gap;
      if (discriminant < 0.0) return kNever;
      const double closing = std::sqrt(discriminant) - rate;
      if (closing <= 0.0) return kNever;
      t += 2.0 * gap / closing;
    }
    if (t > solver.h) return kNever;
  }
  return t;
}

double movingImpact(const WorldWithSolver& world, const BodyNeighbour& neighbour)
{
  const ContactSolver& solver = world.solver;
  const std::uint32_t i = neighbour.ball;
  const BodyRecord& body = world.bodies[neighbour.body];
  const Shape& shape = body.body.shapes[neighbour.shape];
  const Segment path = flyParabola(stateAt(solver, i, 0.0), solver.start, solver.pathAcceleration(i));
  double from = solver.movers[i].clock;
  for (int seam = 0; seam < kMostSeams && from <= solver.h; ++seam)
  {
    const Detection found =
        firstContact(path, solver.radius(i), shape, body.motion, solver.start + from, solver.start + solver.h);
    if (!found.found()) return kNever;
    const double t = found.time - solver.start;
    const BodyFrame frame = frameAt(body.motion, found.time - body.motion.start);
    const Vector3d p = placeAt(solver, i, t), v = velocityAt(solver, i, t);
    const Gap gap = gapTo(shape, frame, p, v, solver.radius(i));
    if (gap.rate >= -solver.leastImpact(solver.movers[i].impacts)) return kNever;
    from = crossesSeam(world, neighbour, nearestOf(world, neighbour, p, t), p, v - frame.pointVelocity(p), t);
    if (from == t) return t;
  }
  return kNever;
}
}  // namespace

double pairImpact(const ContactSolver& solver, const NeighbourPair& pair)
{
  const Mover &a = solver.movers[pair.a], &b = solver.movers[pair.b];
  const double from = std::max(a.clock, b.clock);
  const double left = solver.h - from;
  Vector3d d = solver.movers[pair.a].p - solver.movers[pair.b].p;
  Vector3d u = a.v - b.v;
  if (!solver.a.empty() || a.type != b.type || a.carried != b.carried)
  {
    const Vector3d pull = solver.pathAcceleration(pair.a) - solver.pathAcceleration(pair.b);
    d += (0.5 * from * from) * pull;
    u += (from + 0.5 * left) * pull;
    d += from * (u - (from + 0.5 * left) * pull);
  }
  else if (from > 0.0)
    d += from * u;
  const double du = d.dot(u);
  if (du >= 0.0) return kNever;
  const double reach = solver.reach(pair.a, pair.b);
  const double c = d.squaredNorm() - reach * reach;
  if (c + 2.0 * du * left > 0.0) return kNever;
  const double slowest = solver.leastImpact(std::max(a.impacts, b.impacts));
  const double least = slowest * slowest * reach * reach;
  if (c <= 0.0) return du * du > least ? from : kNever;
  const double discriminant = du * du - u.squaredNorm() * c;
  if (discriminant < least) return kNever;
  const double t = from + c / (std::sqrt(discriminant) - du);
  return t <= solver.h ? t : kNever;
}

double bodyImpact(const WorldWithSolver& world, const BodyNeighbour& neighbour)
{
  const BodyRecord& body = world.bodies[neighbour.body];
  count(meetingLaw(body.shapes()[neighbour.shape].kind));
  if (body.moving) count(Law::MeetMoving);
  return body.moving ? movingImpact(world, neighbour) : stillImpact(world, neighbour);
}
}  // namespace ping_pong
