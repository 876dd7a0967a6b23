#include <algorithm>
#include <cmath>

#include "pile_contacts.h"

namespace ping_pong
{
namespace
{
using Eigen::Vector4f;

constexpr double kSlop = 2e-6;          // overlap that stays [m]
constexpr double kPushOut = 0.2;        // part of the rest that is taken out in a step
constexpr double kCaught = 1.0;         // part of the way in a step by which a contact with a third ball may bring two together
constexpr double kSqueezed = 5e-4;      // a ball that is deeper in a body has no room [m]
constexpr double kForgets = 2e-3;       // deeper than this the last impulses are no guide [m]

// How near a pair has to come to be in touch, on its own: balls that others push may come nearer yet.
double reachOf(const Pile& pile) { return 4.0 * pile.least_impact * pile.h + 1e-6; }

Vector4f flat(const Vector3d& v)
{
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()), 0.0f};
}

// Least change of the normal velocity: closes the gap within the step and no more, and leaves an overlap that was there as it is.
float target(double gap_at_end, double gap_at_start, double h)
{
  return static_cast<float>((std::min(gap_at_start, 0.0) - gap_at_end) / h);
}

// Of the touching points. @param rims  sum of radius times spin, of all balls in touch
Vector4f slip(const Vector3d& u, const Vector3d& n, const Vector3d& rims) { return flat(u - n.dot(u) * n - rims.cross(n)); }

// Part of an overlap that is taken out now [m].
double pushOut(double gap_at_start) { return kPushOut * std::max(-gap_at_start - kSlop, 0.0); }

bool hitInThisStep(const Pile& pile, std::size_t i) { return pile.movers[i].stamp >= pile.step_mark; }

void take(Touch& touch, const Push& push)
{
  touch.normal = push.normal;
  touch.tangent << push.tangent, 0.0f;
}

// The normal force that one of them held when the other fell asleep; < 0 if both are awake [N].
float heldBy(const Pile& pile, const PairLink& link, const KeptPair& kept)
{
  if (pile.movers[link.a].asleep == pile.movers[link.b].asleep) return -1.0f;
  return kept.held < 0.0f ? kept.push.normal / static_cast<float>(pile.h) : kept.held;
}

void gatherPair(WorldState& world, PileShare& share, std::uint32_t l, const KeptPair& kept)
{
  Pile& pile = world.pile;
  const PairLink& link = pile.pairs[l];
  Mover &a = pile.movers[link.a], &b = pile.movers[link.b];
  const double reach = pile.reach(link.a, link.b);
  const Vector3d d = a.p - b.p;
  const Vector3d u = a.v - b.v;
  const Vector3d d_end = d + pile.h * u;
  const double most = reach + reachOf(pile) + kCaught * pile.h * static_cast<double>(pile.changes[link.a].fast + pile.changes[link.b].fast);
  if (d_end.squaredNorm() > most * most)
  {
    if (a.asleep != b.asleep) watch(pile, share, link, 0.0f, heldBy(pile, link, kept));
    return;
  }
  const double distance = d_end.norm();
  const Vector3d n = distance > 0.0 ? Vector3d(d_end / distance) : Vector3d(Vector3d::UnitZ());
  const bool hit = hitInThisStep(pile, link.a) || hitInThisStep(pile, link.b);
  const double gap_at_start = hit ? 0.0 : d.norm() - reach;
  const BallKind &kind_a = pile.kinds[a.kind], &kind_b = pile.kinds[b.kind];
  const double inverse_a = pile.inverseMass(link.a), inverse_b = pile.inverseMass(link.b);
  const double mass = 1.0 / (inverse_a + inverse_b);
  if (const double out = pushOut(gap_at_start); out > 0.0)
  {
    a.p += (out * inverse_a * mass) * n;
    b.p -= (out * inverse_b * mass) * n;
  }
  share.held.push_back(heldBy(pile, link, kept));
  Touch& touch = share.touches.emplace_back();
  touch.n = flat(n);
  take(touch, gap_at_start < -kForgets ? Push() : kept.push);
  touch.slip = slip(u, n, kind_a.params.radius * pile.w[link.a] + kind_b.params.radius * pile.w[link.b]);
  touch.target = target(distance - reach, gap_at_start, pile.h);
  touch.normal_mass = static_cast<float>(mass);
  touch.slip_mass = static_cast<float>(1.0 / (inverse_a * kind_a.give + inverse_b * kind_b.give));
  touch.friction = static_cast<float>(world.scene.surfaces.at(kind_a.params.material, kind_b.params.material).friction);
  touch.link = l;
  touch.a = link.a;
  touch.b = link.b;
}

void gatherBody(WorldState& world, PileShare& share, std::uint32_t l, BodyLink& link)
{
  Pile& pile = world.pile;
  const std::uint32_t i = link.ball;
  Mover& mover = pile.movers[i];
  const BodyRecord& body = world.bodies[link.body];
  const Shape& shape = body.shapes()[link.shape];
  const double radius = pile.radius(i);
  const Vector3d end = mover.p + pile.h * mover.v;
  const auto gapAt = [&](const Vector3d& p, double t) {
    return body.moving ? gapTo(shape, frameAt(body.motion, pile.start + t - body.motion.start), p, Vector3d::Zero(), radius)
                       : gapTo(shape, p, Vector3d::Zero(), radius);
  };
  const Gap gap = gapAt(end, pile.h);
  if (gap.gap > reachOf(pile))
  {
    link.push = Push();
    return;
  }
  const double gap_at_start = hitInThisStep(pile, i) ? 0.0 : gapAt(mover.p, 0.0).gap;
  if (body.moving && mover.asleep)
  {
    pile.wake(i);
    clearChange(pile, i);
  }
  share.squeezed += gap_at_start < -kSqueezed;
  mover.p += pushOut(gap_at_start) * gap.n_W;
  BodyTouch& touch = share.body_touches.emplace_back();
  touch.n = flat(gap.n_W);
  take(touch, gap_at_start < -kForgets ? Push() : link.push);
  touch.target = target(gap.gap, gap_at_start, pile.h);
  const BallKind& kind = pile.kinds[mover.kind];
  touch.normal_mass = static_cast<float>(kind.params.mass);
  touch.slip_mass = static_cast<float>(kind.params.mass / kind.give);
  const double middle = pile.start + 0.5 * pile.h - body.motion.start;
  touch.u = body.moving ? frameAt(body.motion, middle).pointVelocity(end - radius * gap.n_W) : Vector3d(Vector3d::Zero());
  touch.slip = slip(mover.v - touch.u, gap.n_W, radius * pile.w[i]);
  touch.friction = static_cast<float>(world.scene.surfaces.at(kind.params.material, shape.material).friction);
  touch.moving = body.moving;
  touch.material = shape.material;
  touch.link = l;
  touch.a = touch.b = i;
}
void gatherShare(WorldState& world, PileShare& share)
{
  Pile& pile = world.pile;
  for (const std::uint32_t l : share.active_bodies) gatherBody(world, share, l, pile.bodies[l]);
  const KeptPair unknown;
  auto kept = share.kept.begin();  // both are in the order of links
  for (const std::uint32_t l : share.active_pairs)
  {
    while (kept != share.kept.end() && kept->link < l) ++kept;
    gatherPair(world, share, l, kept != share.kept.end() && kept->link == l ? *kept : unknown);
  }
}
}  // namespace

void gatherTouches(WorldState& world)
{
  Pile& pile = world.pile;
  for (std::uint32_t l = 0; l < pile.moving.size(); ++l)
    gatherBody(world, pile.shares[pile.share_of[pile.moving[l].ball]], l, pile.moving[l]);
  updateActive(world);  // who meets a body that moves is awake
  inTurns(world, [&world](PileShare& share) { gatherShare(world, share); });
}
}  // namespace ping_pong
