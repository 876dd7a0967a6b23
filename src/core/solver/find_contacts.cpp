#include <algorithm>
#include <cmath>

#include "geometry/tangential.h"
#include "solver/contact_forces.h"
#include "solver/seams.h"

namespace ping_pong
{
namespace
{
using Eigen::Vector3f;

constexpr double kCaught =
    1.0;  // part of the way in a step by which a contact with a third ball may bring two together
constexpr double kSqueezed = 5e-4;       // a ball that is deeper in a body has no room [m]
constexpr std::size_t kMoreFound = 256;  // places at a time; what an earlier step has left there is overwritten
constexpr double kSamePlace = 1e-12;     // two balls nearer than this have no direction [m]
constexpr double kForgets = 2e-3;        // deeper than this the last impulses are no guide [m]

// How near a pair has to come to be in touch, on its own: balls that others push may come nearer yet.
double reachOf(const Pile& pile)
{
  return 4.0 * pile.least_impact * pile.h + 1e-6;
}

bool hitInThisStep(const Pile& pile, std::size_t i)
{
  return pile.movers[i].stamp >= pile.step_mark;
}

// One of them has fallen asleep, or none does any more: see Pile::held.
void updateHeld(Pile& pile, std::uint32_t l, bool one_sleeps)
{
  float& held = pile.held[l];
  if (!one_sleeps)
    held = -1.0f;
  else if (held < 0.0f)
    held = pile.pushes[l][3] / static_cast<float>(pile.h);
}

void apart(Pile& pile, PileShare& share, std::uint32_t l, bool one_sleeps)
{
  if (one_sleeps) watch(pile, share, l, 0.0f);
  pile.held[l] = -1.0f;
  pile.pushes[l] = Lanes{};
}

void gatherPair(Pile& pile, PileShare& share, std::uint32_t l)
{
  const PairLink& link = pile.pairs[l];
  const Mover &a = pile.movers[link.a], &b = pile.movers[link.b];
  const double reach = pile.reach(link.a, link.b);
  const Vector3d d = a.p - b.p;
  const Vector3d u = a.v - b.v;
  Vector3d d_end = d + pile.h * u;
  const double square = d_end.squaredNorm();
  const double fast = std::sqrt(2.0 * (a.v.squaredNorm() + b.v.squaredNorm()));  // no less than the sum of their speeds
  const double most = reach + reachOf(pile) + kCaught * pile.h * fast;
  const bool one_sleeps = a.asleep != b.asleep;
  updateHeld(pile, l, one_sleeps);
  if (square > most * most) return apart(pile, share, l, one_sleeps);
  if (square < kSamePlace * kSamePlace) d_end = kSamePlace * Vector3d::UnitZ();
  const bool hit = hitInThisStep(pile, link.a) || hitInThisStep(pile, link.b);
  const double room =
      hit ? 0.0 : std::min(d.squaredNorm() - reach * reach, 0.0);  // what there was at the start does not count
  const bool forgets = room < -kForgets * (2.0 * reach - kForgets);
  const LanePlace place = share.open_pairs.place(share.pair_batches, link.a, link.b);
  if (share.found.size() <= place.index)
  {
    share.found.resize(place.index + kMoreFound);
    share.pair_links.resize(place.index + kMoreFound);
  }
  share.pair_links[place.index] = l;
  FoundPair& found = share.found[place.index];
  found.way = lanesOf(d_end, square - reach * reach);
  found.u = lanesOf(u, room);
  found.push = forgets ? Lanes{} : pile.pushes[l];
}

// Any ball may be thrown at a body by the fastest one.
double reachOfBodies(const Pile& pile)
{
  double squared = 0.0;
  for (const PileShare& share : pile.shares) squared = std::max(squared, share.fastest_squared);
  return reachOf(pile) + kCaught * pile.h * std::sqrt(squared);
}

// A surface takes over from the one that it continues: with the impulses that the ball had there in the last step.
void passOn(Pile& pile, PileShare& share, std::uint32_t from, std::uint32_t to)
{
  BodyLink& old = pile.bodies[from];
  if (!(old.push[3] > 0.0f)) return;
  if (to > from)
    pile.bodies[to].push += old.push;
  else
    for (const BodyTouch& touch : share.body_touches)  // it has been gathered
    {
      if (touch.moving || touch.link != to) continue;
      TouchBatch& batch = share.body_batches[touch.place.batch()];
      const std::size_t lane = touch.place.lane();
      batch.tangent.set(lane, Vector3f(batch.tangent.at(lane) + Vector3f(old.push[0], old.push[1], old.push[2])));
      batch.normal[lane] += old.push[3];
    }
  old.push = Lanes{};
}

// Room at the start of the step. A shape to which the ball has come across a seam continues the one that it lay on before.
double roomAtStart(const WorldWithSolver& world, const BodyLink& link)
{
  const Pile& pile = world.pile;
  if (hitInThisStep(pile, link.ball)) return 0.0;
  const Vector3d& p = pile.movers[link.ball].p;
  const Proximity near = nearestOf(world, link, p, 0.0);
  if (!near.flat())
    if (const Seam seam = seamWith(world, link, near, p, 0.0); seam.there)
      return seam.surface.distance - pile.radius(link.ball);
  return near.distance - pile.radius(link.ball);
}

// A touch of a ball, at its place at the end of the step, and what of a shape is nearest to it there.
void addTouch(WorldWithSolver& world, PileShare& share, std::uint32_t l, const BodyLink& link, const Vector3d& end,
              const Proximity& near)
{
  Pile& pile = world.pile;
  const std::uint32_t i = link.ball;
  const Mover& mover = pile.movers[i];
  const BodyRecord& body = world.bodies[link.body];
  const MaterialId material = body.shapes()[link.shape].material;
  const double radius = pile.radius(i);
  const double overlap = std::max(-roomAtStart(world, link), 0.0);
  share.squeezed += pile.moving.empty() && overlap > kSqueezed;
  pile.changes[i].p.head<3>() += (pushOut(overlap) * near.normal).cast<float>();
  const BallKind& kind = pile.kinds[mover.kind];
  const double middle = pile.start + 0.5 * pile.h - body.motion.start;
  const Vector3d u =
      body.moving ? frameAt(body.motion, middle).pointVelocity(end - radius * near.normal) : Vector3d(Vector3d::Zero());
  const LanePlace place = share.open_bodies.place(share.body_batches, i, TouchBatch::kBody);
  share.body_touches.push_back({u, l, place, i, material, body.moving});
  TouchBatch& batch = share.body_batches[place.batch()];
  const std::size_t lane = place.lane();
  const Vector3d v = mover.v - u;
  const Vector3f n = near.normal.cast<float>();
  batch.n.set(lane, n);
  batch.slip.set(lane, Vector3f(tangential(v, near.normal).cast<float>() - pile.changes[i].before.head<3>().cross(n)));
  const Lanes push = overlap > kForgets ? Lanes{} : link.push;
  batch.tangent.set(lane, Vector3f(push[0], push[1], push[2]));
  batch.normal[lane] = push[3];
  batch.target[lane] = static_cast<float>(-(overlap + (near.distance - radius)) / pile.h);
  batch.normal_mass[lane] = static_cast<float>(kind.params.mass);
  batch.slip_mass[lane] = static_cast<float>(kind.params.mass / kind.give);
  batch.friction[lane] = static_cast<float>(world.scene.surfaces.at(kind.params.material, material).friction);
}

void gatherBody(WorldWithSolver& world, PileShare& share, std::uint32_t l, BodyLink& link, double reach)
{
  Pile& pile = world.pile;
  const Mover& mover = pile.movers[link.ball];
  const bool moving = world.bodies[link.body].moving;
  const Vector3d end = mover.p + pile.h * mover.v;
  const Proximity near = nearestOf(world, link, end, pile.h);
  if (near.distance - pile.radius(link.ball) > reach)
  {
    link.push = Lanes{};
    return;
  }
  if (!near.flat())
    if (const Seam seam = seamWith(world, link, near, end, pile.h); seam.there)
    {
      if (!moving) passOn(pile, share, l, seam.link);
      return;
    }
  if (moving && mover.asleep)
  {
    pile.wake(link.ball);
    clearChange(pile, link.ball);
  }
  addTouch(world, share, l, link, end, near);
}

void gatherShare(WorldWithSolver& world, PileShare& share, double reach_of_bodies)
{
  Pile& pile = world.pile;
  for (const std::uint32_t l : share.active_bodies) gatherBody(world, share, l, pile.bodies[l], reach_of_bodies);
  for (const std::uint32_t l : share.active_pairs) gatherPair(pile, share, l);
}
}  // namespace

void gatherTouches(WorldWithSolver& world)
{
  Pile& pile = world.pile;
  const double reach = reachOfBodies(pile);
  for (std::uint32_t l = 0; l < pile.moving.size(); ++l)
    gatherBody(world, pile.shares[pile.share_of[pile.moving[l].ball]], l, pile.moving[l], reach);
  updateActive(world);  // who meets a body that moves is awake
  inTurns(world,
          [&world, reach](PileShare& share)
          {
            gatherShare(world, share, reach);
            startTouches(world, share);
          });
}
}  // namespace ping_pong
