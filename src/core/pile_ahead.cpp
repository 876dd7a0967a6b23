#include "pile_ahead.h"

#include <algorithm>
#include <cmath>

#include "count.h"
#include "ping_pong_sim/evolve.h"

namespace ping_pong
{
namespace
{
constexpr int kMostMarchSteps = 20;  // of a search for the time of an impact

// Marches as firstContact() does, see detect.h: the gap stays above its tangent parabola.
double stillImpact(const Pile& pile, std::size_t i, const Shape& placed)
{
  const Vector3d a = pile.pathAcceleration(i);
  double t = pile.movers[i].clock;
  for (int step = 0; step < kMostMarchSteps; ++step)
  {
    const Vector3d p = placeAt(pile, i, t);
    const Gap gap = gapTo(placed, p, velocityAt(pile, i, t), pile.radius(i));
    if (gap.gap <= touchTolerance(p, pile.radius(i))) return gap.rate < -pile.leastImpact(pile.movers[i].impacts) ? t : kNever;
    const double press = gap.n_W.dot(a);
    const double discriminant = gap.rate * gap.rate - 2.0 * press * gap.gap;
    if (discriminant < 0.0) return kNever;
    const double closing = std::sqrt(discriminant) - gap.rate;
    if (closing <= 0.0) return kNever;
    t += 2.0 * gap.gap / closing;
    if (t > pile.h) return kNever;
  }
  return t;
}

double movingImpact(const Pile& pile, std::size_t i, const Shape& shape, const BodyMotion& motion)
{
  const double from = pile.start + pile.movers[i].clock;
  const Segment path = flyParabola(stateAt(pile, i, 0.0), pile.start, pile.pathAcceleration(i));
  const Detection found = firstContact(path, pile.radius(i), shape, motion, from, pile.start + pile.h);
  if (!found.found()) return kNever;
  const BodyFrame frame = frameAt(motion, found.time - motion.start);
  const double t = found.time - pile.start;
  const Gap gap = gapTo(shape, frame, placeAt(pile, i, t), velocityAt(pile, i, t), pile.radius(i));
  return gap.rate < -pile.leastImpact(pile.movers[i].impacts) ? t : kNever;
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

double bodyImpact(const WorldState& world, const BodyLink& link)
{
  const BodyRecord& body = world.bodies[link.body];
  const Shape& shape = body.shapes()[link.shape];
  count(meeting(shape.kind));
  if (body.moving) count(Law::MeetMoving);
  return body.moving ? movingImpact(world.pile, link.ball, shape, body.motion)
                     : stillImpact(world.pile, link.ball, shape);
}
}  // namespace ping_pong
