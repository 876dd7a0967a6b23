// Impacts within a step, located on parabolas and handled in the order of time. Each one takes energy away, by the
// restitution at its own speed: so does any sequence of them.
#include <algorithm>
#include <cmath>

#include "base/law_counter.h"
#include "ping_pong_sim/resolve.h"
#include "solver/slabs.h"
#include "solver/squeezed_in_solver.h"
#include "solver/time_of_impact.h"
#include "state/contact_log.h"

namespace ping_pong
{
namespace
{
constexpr int kMostImpacts = 15;  // of one ball in one step; what is left is up to the contacts

// From t on the ball flies with this state: its path is drawn back to the start of the step.
void fork(Pile& pile, std::size_t i, const BallState& state, double t)
{
  Mover& mover = pile.movers[i];
  pile.turn[i] += (t - mover.clock) * pile.w[i];
  takeTurn(pile, i);  // about another axis from now on
  const Vector3d a = pile.pathAcceleration(i);
  mover.v = state.v_WB - t * a;
  pile.w[i] = state.w_WB;
  mover.p = state.p_WB - t * (state.v_WB - (0.5 * t) * a);
  mover.clock = t;
  mover.stamp = pile.counter;
  mover.calm = false;
  ++mover.impacts;
}

// An impact of the ball in slot i. No later than the step ends: rounding may say so.
void record(WorldWithSolver& world, std::uint32_t i, const HitObject& other, double t, const BallState& before,
            const BallState& after, const Vector3d& n, const Vector3d& u, const Vector3d& impulse)
{
  ++world.status.events;
  const std::uint32_t ball = world.pile.ball[i];
  recordContact(world, world.balls[ball], ball, other,
                {std::min(world.pile.start + t, world.pile.end), n, u, before.p_WB, before.v_WB, after.v_WB,
                 before.w_WB, after.w_WB, impulse});
}

// --- two balls ---

void hitPair(WorldWithSolver& world, const PairLink& link, double t)
{
  Pile& pile = world.pile;
  BallState a = stateAt(pile, link.a, t), b = stateAt(pile, link.b, t);
  pile.wake(link.a);
  pile.wake(link.b);
  const Vector3d n = (a.p_WB - b.p_WB).normalized();
  const double closing = -n.dot(a.v_WB - b.v_WB);
  const BallParams &params_a = pile.params(link.a), &params_b = pile.params(link.b);
  const Surface& law = world.scene.surfaces.at(params_a.material, params_b.material);
  const Vector3d p_WC = a.p_WB - params_a.radius * n;
  const Vector3d v_other = b.v_WB + b.w_WB.cross(p_WC - b.p_WB);
  if (!pile.moving.empty())
    for (const std::uint32_t i : {link.a, link.b}) noteOther(pile, i);
  const BallState before = a;
  const Vector3d impulse = part(law, law.restitutionAt(closing) * closing, params_a, a, params_b, b, n);
  record(world, link.a, HitObject::ballOf(world.balls[pile.ball[link.b]].id), t, before, a, n, v_other, impulse);
  fork(pile, link.a, a, t);
  fork(pile, link.b, b, t);
  pile.untouched[link.a] = pile.untouched[link.b] = 0.0f;
}

// --- a ball and a shape ---

void hitBody(WorldWithSolver& world, const BodyLink& link, double t)
{
  Pile& pile = world.pile;
  const std::uint32_t i = link.ball;
  const BodyRecord& body = world.bodies[link.body];
  const Shape& shape = body.shapes()[link.shape];
  BallState state = stateAt(pile, i, t);
  const BodyFrame frame = body.at(pile.start + t);
  const Gap gap = gapTo(shape, frame, state.p_WB, state.v_WB, pile.radius(i));
  pile.wake(i);
  const Vector3d p_WC = state.p_WB - pile.radius(i) * gap.n_W;
  const Vector3d u = body.moving ? frame.pointVelocity(p_WC) : Vector3d::Zero();
  Surface law = world.scene.surfaces.at(pile.params(i).material, shape.material);
  const bool along = body.moving && takesAlong(pile, link, t);
  if (along) law.restitution = 0.0;
  if (!body.moving && !pile.moving.empty()) noteOther(pile, i);
  const BallState before = state;
  Vector3d impulse = bounce(law, pile.params(i), state, u, gap.n_W);
  if (along) limitImpulse(pile.params(i), before, u.norm(), state, impulse);
  record(world, i, HitObject::shapeOf(link.body, link.shape), t, before, state, gap.n_W, u, impulse);
  fork(pile, i, state, t);
}

// --- in the order of time ---

bool later(const ImpactAhead& p, const ImpactAhead& q)
{
  return p.time != q.time ? p.time > q.time : p.link > q.link;
}

bool tired(const Pile& pile, std::uint32_t i)
{
  return pile.movers[i].impacts >= kMostImpacts;
}

double nextOfPair(const Pile& pile, const PairLink& link)
{
  if (pile.movers[link.a].calm && pile.movers[link.b].calm) return kNever;
  if (tired(pile, link.a) || tired(pile, link.b)) return kNever;
  count(Law::PairSearch);
  return pairImpact(pile, link);
}

double nextWithBody(const WorldWithSolver& world, const BodyLink& link)
{
  const bool still = !world.bodies[link.body].moving;
  if (tired(world.pile, link.ball) || (still && world.pile.movers[link.ball].calm)) return kNever;
  return bodyImpact(world, link);
}

void lookAtShare(const WorldWithSolver& world, PileShare& share)
{
  const Pile& pile = world.pile;
  share.ahead.clear();
  const auto note = [&](double t, LinkName link)
  {
    if (t <= pile.h) share.ahead.push_back({t, link, pile.counter});
  };
  for (const std::uint32_t l : share.active_bodies)
    note(nextWithBody(world, pile.bodies[l]), {l, LinkName::StillBodies});
  for (const std::uint32_t l : share.active_pairs) note(nextOfPair(pile, pile.pairs[l]), {l, LinkName::Pairs});
}

void lookAtAll(WorldWithSolver& world)
{
  Pile& pile = world.pile;
  eachShare(world, [&world](PileShare& share) { lookAtShare(world, share); });
  pile.ahead.clear();
  for (std::uint32_t l = 0; l < pile.moving.size(); ++l)
    if (const double t = nextWithBody(world, pile.moving[l]); t <= pile.h)
      pile.ahead.push_back({t, {l, LinkName::MovingBodies}, pile.counter});
  for (const PileShare& share : pile.shares)
    pile.ahead.insert(pile.ahead.end(), share.ahead.begin(), share.ahead.end());
  std::make_heap(pile.ahead.begin(), pile.ahead.end(), later);
}

// The ball has another path.
void lookAgain(WorldWithSolver& world, std::uint32_t i)
{
  Pile& pile = world.pile;
  const auto note = [&pile](double t, LinkName link)
  {
    if (!(t <= pile.h)) return;
    pile.ahead.push_back({t, link, pile.counter});
    std::push_heap(pile.ahead.begin(), pile.ahead.end(), later);
  };
  for (std::uint32_t l = 0; l < pile.moving.size(); ++l)
    if (pile.moving[l].ball == i) note(nextWithBody(world, pile.moving[l]), {l, LinkName::MovingBodies});
  for (std::uint32_t l = pile.first_body[i]; l != Pile::kEndOfChain; l = pile.bodies[l].next)
    note(nextWithBody(world, pile.bodies[l]), {l, LinkName::StillBodies});
  pile.anyLink(i,
               [&](std::uint32_t l)
               {
                 note(nextOfPair(pile, pile.pairs[l]), {l, LinkName::Pairs});
                 return false;
               });
}

// Handles one impact; balls that it has thrown off their path are put into a and b, twice the same if it is but one.
bool handle(WorldWithSolver& world, const ImpactAhead& impact, std::uint32_t& a, std::uint32_t& b)
{
  Pile& pile = world.pile;
  const std::uint32_t l = impact.link.index;
  const bool pair = impact.link.list == LinkName::Pairs, still = impact.link.list == LinkName::StillBodies;
  a = pair ? pile.pairs[l].a : still ? pile.bodies[l].ball : pile.moving[l].ball;
  b = pair ? pile.pairs[l].b : a;
  if (pile.movers[a].stamp > impact.made || pile.movers[b].stamp > impact.made) return false;
  ++pile.counter;
  if (pair)
    hitPair(world, pile.pairs[l], impact.time);
  else
    hitBody(world, still ? pile.bodies[l] : pile.moving[l], impact.time);
  return true;
}
}  // namespace

void resolveImpacts(WorldWithSolver& world)
{
  Pile& pile = world.pile;
  lookAtAll(world);
  while (!pile.ahead.empty())
  {
    const ImpactAhead next = pile.ahead.front();
    std::pop_heap(pile.ahead.begin(), pile.ahead.end(), later);
    pile.ahead.pop_back();
    std::uint32_t a, b;
    if (!handle(world, next, a, b)) continue;
    if (updateLinksAfterImpact(world, a, b))
    {
      lookAtAll(world);
      continue;
    }
    lookAgain(world, a);
    if (b != a) lookAgain(world, b);
  }
  updateActive(world);
}
}  // namespace ping_pong
