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
constexpr int kMostMarchSteps = 20;  // of a search for the time of an impact
constexpr int kMostSeams = 4;        // of a moving body that a ball passes in a step

// A ball on a face comes to the edge of the next shape in the same plane: no impact. When it will be past the edge, or kNever.
// @param v  its velocity relative to the body
double passesSeam(const WorldWithSolver& world, const BodyLink& link, const Proximity& near, const Vector3d& p,
                  const Vector3d& v, double t)
{
  if (near.flat()) return t;
  const Seam seam = seamWith(world, link, near, p, t);
  if (!seam.there) return t;
  const Vector3d way = seam.surface.distance * seam.surface.normal - near.distance * near.normal;
  const double along = way.dot(v);
  return along > 0.0 ? t + way.squaredNorm() / along : kNever;
}

// Marches as firstContact() does, see first_contact.h: the gap stays above its tangent parabola. On a straight line its rate only grows.
double stillImpact(const WorldWithSolver& world, const BodyLink& link)
{
  const Pile& pile = world.pile;
  const std::uint32_t i = link.ball;
  const Vector3d a = pile.pathAcceleration(i);
  const double most = a.norm(), least = pile.leastImpact(pile.movers[i].impacts);
  double t = pile.movers[i].clock;
  for (int step = 0; step < kMostMarchSteps; ++step)
  {
    const Vector3d p = placeAt(pile, i, t), v = velocityAt(pile, i, t);
    const Proximity near = nearestOf(world, link, p, t);
    const double gap = near.distance - pile.radius(i), rate = near.normal.dot(v);
    if (rate >= most * (pile.h - t) - least) return kNever;  // nor is it faster later in this step
    if (gap <= touchTolerance(p, pile.radius(i)))
    {
      if (rate >= -least) return kNever;
      const double past = passesSeam(world, link, near, p, v, t);
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
    if (t > pile.h) return kNever;
  }
  return t;
}

double movingImpact(const WorldWithSolver& world, const BodyLink& link)
{
  const Pile& pile = world.pile;
  const std::uint32_t i = link.ball;
  const BodyRecord& body = world.bodies[link.body];
  const Shape& shape = body.body.shapes[link.shape];
  const Segment path = flyParabola(stateAt(pile, i, 0.0), pile.start, pile.pathAcceleration(i));
  double from = pile.movers[i].clock;
  for (int seam = 0; seam < kMostSeams && from <= pile.h; ++seam)
  {
    const Detection found =
        firstContact(path, pile.radius(i), shape, body.motion, pile.start + from, pile.start + pile.h);
    if (!found.found()) return kNever;
    const double t = found.time - pile.start;
    const BodyFrame frame = frameAt(body.motion, found.time - body.motion.start);
    const Vector3d p = placeAt(pile, i, t), v = velocityAt(pile, i, t);
    const Gap gap = gapTo(shape, frame, p, v, pile.radius(i));
    if (gap.rate >= -pile.leastImpact(pile.movers[i].impacts)) return kNever;
    from = passesSeam(world, link, nearestOf(world, link, p, t), p, v - frame.pointVelocity(p), t);
    if (from == t) return t;
  }
  return kNever;
}
}  // namespace

double pairImpact(const Pile& pile, const PairLink& link)
{
  const Mover &a = pile.movers[link.a], &b = pile.movers[link.b];
  const double from = std::max(a.clock, b.clock);
  const double left = pile.h - from;
  Vector3d d = pile.movers[link.a].p - pile.movers[link.b].p;
  Vector3d u = a.v - b.v;
  if (!pile.a.empty() || a.kind != b.kind || a.loaded != b.loaded)
  {
    const Vector3d pull = pile.pathAcceleration(link.a) - pile.pathAcceleration(link.b);
    d += (0.5 * from * from) * pull;
    u += (from + 0.5 * left) * pull;
    d += from * (u - (from + 0.5 * left) * pull);
  }
  else if (from > 0.0)
    d += from * u;
  const double du = d.dot(u);
  if (du >= 0.0) return kNever;
  const double reach = pile.reach(link.a, link.b);
  const double c = d.squaredNorm() - reach * reach;
  if (c + 2.0 * du * left > 0.0) return kNever;
  const double slowest = pile.leastImpact(std::max(a.impacts, b.impacts));
  const double least = slowest * slowest * reach * reach;
  if (c <= 0.0) return du * du > least ? from : kNever;
  const double discriminant = du * du - u.squaredNorm() * c;
  if (discriminant < least) return kNever;
  const double t = from + c / (std::sqrt(discriminant) - du);
  return t <= pile.h ? t : kNever;
}

double bodyImpact(const WorldWithSolver& world, const BodyLink& link)
{
  const BodyRecord& body = world.bodies[link.body];
  count(meeting(body.shapes()[link.shape].kind));
  if (body.moving) count(Law::MeetMoving);
  return body.moving ? movingImpact(world, link) : stillImpact(world, link);
}
}  // namespace ping_pong
