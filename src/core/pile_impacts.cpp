// Impacts within a step, located on parabolas and handled in the order of time. Each one takes energy away, by the
// restitution at its own speed: so does any sequence of them.
#include <algorithm>
#include <cmath>

#include "count.h"
#include "pile.h"
#include "ping_pong_sim/evolve.h"
#include "ping_pong_sim/resolve.h"
#include "world_state.h"

namespace ping_pong
{
namespace
{
constexpr int kMostImpacts = 4;      // of one ball in one step; what is left is up to the contacts
constexpr int kMostMarchSteps = 20;  // of a search for the time of an impact

Vector3d placeAt(const Pile& pile, std::size_t i, double t)
{
  return pile.p[i] + t * (pile.movers[i].v + (0.5 * t) * pile.pathAcceleration(i));
}

Vector3d velocityAt(const Pile& pile, std::size_t i, double t)
{
  return pile.movers[i].v + t * pile.pathAcceleration(i);
}

// From t on the ball flies with this state: its path is drawn back to the start of the step.
void fork(Pile& pile, std::size_t i, const BallState& state, double t)
{
  Mover& mover = pile.movers[i];
  if (!mover.w.isZero(0.0)) turnBall(pile.q[i], (t - mover.clock) * mover.w);
  const Vector3d a = pile.pathAcceleration(i);
  mover.v = state.v_WB - t * a;
  mover.w = state.w_WB;
  pile.p[i] = state.p_WB - t * (state.v_WB - (0.5 * t) * a);
  mover.clock = t;
  mover.stamp = pile.counter;
  ++mover.impacts;
}

BallState stateAt(const Pile& pile, std::size_t i, double t)
{
  BallState state;
  state.p_WB = placeAt(pile, i, t);
  state.v_WB = velocityAt(pile, i, t);
  state.w_WB = pile.movers[i].w;
  return state;
}

// A record of the impact, as long as there is room: none is taken while the world moves on.
Contact* newContact(WorldState& world, std::uint32_t ball, const BallState& before, double t)
{
  ++world.status.contacts;
  ++world.status.events;
  if (!world.keep_contacts || world.contacts.size() == world.contacts.capacity()) return nullptr;
  Contact& contact = world.contacts.emplace_back();
  world.origins.push_back({ball, 0});
  contact.time = world.pile.start + t;
  contact.ball = world.balls[ball].id;
  contact.v_before = before.v_WB;
  contact.w_before = before.w_WB;
  return &contact;
}

void finish(Contact* contact, const BallState& after, const Vector3d& n, const Vector3d& p_WC, const Vector3d& v_other,
            const Vector3d& impulse)
{
  if (contact == nullptr) return;
  contact->n_W = n;
  contact->p_WC = p_WC;
  contact->v_other = v_other;
  contact->v_after = after.v_WB;
  contact->w_after = after.w_WB;
  contact->impulse = impulse;
}

// --- two balls ---

void hitPair(WorldState& world, const PairLink& link, double t)
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
  Contact* contact = newContact(world, pile.ball[link.a], a, t);
  const Vector3d impulse = part(law, law.restitutionAt(closing) * closing, params_a, a, params_b, b, n);
  if (contact != nullptr)
  {
    contact->with_ball = true;
    contact->other_ball = world.balls[pile.ball[link.b]].id;
  }
  finish(contact, a, n, p_WC, v_other, impulse);
  fork(pile, link.a, a, t);
  fork(pile, link.b, b, t);
  pile.untouched[link.a] = pile.untouched[link.b] = 0.0f;
}

// Time of the impact of two balls in this step, or kNever. Where both are under the same acceleration, their relative path is
// a line. Most pairs part, or are too far from each other: they are told by products alone.
double pairImpact(const Pile& pile, const PairLink& link)
{
  const Mover &a = pile.movers[link.a], &b = pile.movers[link.b];
  const double from = std::max(a.clock, b.clock);
  const double left = pile.h - from;
  Vector3d d = pile.p[link.a] - pile.p[link.b];
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
  const double reach = pile.radius(link.a) + pile.radius(link.b);
  const double c = d.squaredNorm() - reach * reach;
  if (c + 2.0 * du * left > 0.0) return kNever;
  const double least = pile.least_impact * pile.least_impact * reach * reach;
  if (c <= 0.0) return du * du > least ? from : kNever;
  const double discriminant = du * du - u.squaredNorm() * c;
  if (discriminant < least) return kNever;
  const double t = from + c / (std::sqrt(discriminant) - du);
  return t <= pile.h ? t : kNever;
}

// --- a ball and a shape ---

// Marches as firstContact() does, see detect.h: the gap stays above its tangent parabola.
double stillImpact(const Pile& pile, std::size_t i, const Shape& placed)
{
  const Vector3d a = pile.pathAcceleration(i);
  double t = pile.movers[i].clock;
  for (int step = 0; step < kMostMarchSteps; ++step)
  {
    const Vector3d p = placeAt(pile, i, t);
    const Gap gap = gapTo(placed, p, velocityAt(pile, i, t), pile.radius(i));
    if (gap.gap <= touchTolerance(p, pile.radius(i))) return gap.rate < -pile.least_impact ? t : kNever;
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
  return gap.rate < -pile.least_impact ? t : kNever;
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

void hitBody(WorldState& world, const BodyLink& link, double t)
{
  Pile& pile = world.pile;
  const std::uint32_t i = link.ball;
  const BodyRecord& body = world.bodies[link.body];
  const Shape& shape = body.shapes()[link.shape];
  BallState state = stateAt(pile, i, t);
  const BodyFrame frame = frameAt(body.frame(), pile.start + t - body.frame().start);
  const Gap gap = gapTo(shape, frame, state.p_WB, state.v_WB, pile.radius(i));
  pile.wake(i);
  const Vector3d p_WC = state.p_WB - pile.radius(i) * gap.n_W;
  const Vector3d u = body.moving ? frame.pointVelocity(p_WC) : Vector3d::Zero();
  Contact* contact = newContact(world, pile.ball[i], state, t);
  const Surface& law = world.scene.surfaces.at(pile.params(i).material, shape.material);
  const Vector3d impulse = bounce(law, pile.params(i), state, u, gap.n_W);
  if (contact != nullptr)
  {
    contact->body = link.body;
    contact->shape = link.shape;
  }
  finish(contact, state, gap.n_W, p_WC, u, impulse);
  fork(pile, i, state, t);
}

// --- in the order of time ---

bool later(const ImpactAhead& p, const ImpactAhead& q)
{
  return p.time != q.time ? p.time > q.time : p.link > q.link;
}

void push(Pile& pile, double t, std::uint32_t link)
{
  if (!(t <= pile.h)) return;
  pile.ahead.push_back({t, link, pile.counter});
  std::push_heap(pile.ahead.begin(), pile.ahead.end(), later);
}

bool tired(const Pile& pile, std::uint32_t i) { return pile.movers[i].impacts >= kMostImpacts; }

void lookAtPair(Pile& pile, std::uint32_t l)
{
  const PairLink& link = pile.pairs[l];
  if (tired(pile, link.a) || tired(pile, link.b)) return;
  count(Law::PairSearch);
  push(pile, pairImpact(pile, link), 3 * l);
}

void lookAtBody(WorldState& world, const BodyLink& link, std::uint32_t code)
{
  if (!tired(world.pile, link.ball)) push(world.pile, bodyImpact(world, link), code);
}

void lookAtAll(WorldState& world)
{
  Pile& pile = world.pile;
  pile.ahead.clear();
  for (std::uint32_t l = 0; l < pile.moving.size(); ++l) lookAtBody(world, pile.moving[l], 3 * l + 2);
  for (const std::uint32_t l : pile.active_bodies) lookAtBody(world, pile.bodies[l], 3 * l + 1);
  for (const std::uint32_t l : pile.active_pairs) lookAtPair(pile, l);
}

// The ball has another path.
void lookAgain(WorldState& world, std::uint32_t i)
{
  Pile& pile = world.pile;
  for (std::uint32_t l = 0; l < pile.moving.size(); ++l)
    if (pile.moving[l].ball == i) lookAtBody(world, pile.moving[l], 3 * l + 2);
  for (std::uint32_t l = pile.first_body[i]; l != Pile::kEndOfChain; l = pile.body_chain[l])
    lookAtBody(world, pile.bodies[l], 3 * l + 1);
  for (std::uint32_t l = pile.first_link[i]; l != Pile::kEndOfChain; l = pile.chain[l / 2][l % 2])
    lookAtPair(pile, l / 2);
}

// Handles one impact; balls that it has thrown off their path are put into a and b, twice the same if it is but one.
bool handle(WorldState& world, const ImpactAhead& impact, std::uint32_t& a, std::uint32_t& b)
{
  Pile& pile = world.pile;
  const std::uint32_t l = impact.link / 3, list = impact.link % 3;
  a = list == 0 ? pile.pairs[l].a : list == 1 ? pile.bodies[l].ball : pile.moving[l].ball;
  b = list == 0 ? pile.pairs[l].b : a;
  if (pile.movers[a].stamp > impact.made || pile.movers[b].stamp > impact.made) return false;
  ++pile.counter;
  if (list == 0)
    hitPair(world, pile.pairs[l], impact.time);
  else
    hitBody(world, list == 1 ? pile.bodies[l] : pile.moving[l], impact.time);
  return true;
}
}  // namespace

void resolveImpacts(WorldState& world)
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
  updateActive(pile);
}
}  // namespace ping_pong
