// The step of method `impulse`, and the way of balls into the pile and back into the records of the world.
#include <algorithm>
#include <cmath>

#include "count.h"
#include "pile.h"
#include "ping_pong_sim/evolve.h"
#include "ping_pong_sim/fixed_flight.h"
#include "world_state.h"

namespace ping_pong
{
namespace
{
constexpr double kFastest = 1e8;       // [m/s]
constexpr double kNoImpact = 1e-9;     // slower is no impact: without any force [m/s],
constexpr double kImpactInSteps = 2.0; // and else what gravity adds in so many steps
constexpr std::size_t kLinks = 8;   // room for so many links a ball from the start

bool same(const BallParams& a, const BallParams& b)
{
  return a.radius == b.radius && a.mass == b.mass && a.inertia == b.inertia && a.material == b.material;
}

std::uint16_t kindOf(Pile& pile, const BallRecord& ball)
{
  for (std::size_t k = 0; k < pile.kinds.size(); ++k)
    if (same(pile.kinds[k].params, ball.params)) return static_cast<std::uint16_t>(k);
  BallKind kind{ball.params, ball.model};
  if (ball.model.constant()) kind.a = ball.model.acceleration(Vector3d::Zero(), Vector3d::Zero());
  kind.spin_per_impulse = 1.0 / (ball.params.inertia * ball.params.radius);
  kind.inverse_mass = 1.0 / ball.params.mass;
  kind.give = 1.0 + 1.0 / ball.params.inertia;
  pile.kinds.push_back(kind);
  return static_cast<std::uint16_t>(pile.kinds.size() - 1);
}

void take(WorldState& world, std::size_t slot, double time)
{
  Pile& pile = world.pile;
  const BallRecord& ball = world.balls[pile.ball[slot]];
  const BallState state = ball.stateAt(time);
  Mover mover;
  mover.kind = kindOf(pile, ball);
  mover.v = state.v_WB;
  mover.w = state.w_WB;
  mover.asleep = mover.loaded = mover.was_loaded = ball.asleep;
  pile.movers[slot] = mover;
  pile.p[slot] = pile.home[slot] = state.p_WB;
  pile.q[slot] = state.q_WB;
  pile.still[slot] = pile.untouched[slot] = 0.0f;
  pile.links_void = pile.active_void = true;
}

// --- the step ---

void accelerate(WorldState& world)
{
  Pile& pile = world.pile;
  if (pile.a.empty()) return;
  for (const std::uint32_t i : pile.awake)
  {
    const Mover& mover = pile.movers[i];
    pile.a[i] = pile.kinds[mover.kind].model.acceleration(mover.v, mover.w);
    if ((mover.v + pile.h * pile.a[i]).norm() < kFastest) continue;
    pile.a[i].setZero();  // the step is too long for the drag: the ball goes straight on
    world.status.not_finite = true;
  }
}

double reachOf(const Body& body)
{
  double reach = 0.0;
  for (const Shape& shape : body.shapes) reach = std::max(reach, shape.p_BS.norm() + shape.half_size.norm());
  return reach;
}

// Bodies that move are linked with all balls nearby, in every step.
void linkMovingBodies(WorldState& world)
{
  Pile& pile = world.pile;
  pile.moving.clear();
  for (std::size_t b = 0; b < world.bodies.size(); ++b)
  {
    const BodyRecord& body = world.bodies[b];
    if (!body.moving) continue;
    const BodyFrame frame = frameAt(body.motion, pile.start - body.motion.start);
    const double size = reachOf(body.body);
    const double way = pile.h * (frame.v_WB.norm() + frame.w_WB.norm() * size + 0.5 * pile.h * frame.a_WB.norm());
    for (std::uint32_t i = 0; i < pile.p.size(); ++i)
    {
      const double near = size + pile.radius(i) + way + pile.h * pile.movers[i].v.norm() + pile.margin;
      if ((pile.p[i] - frame.p_WB).squaredNorm() > near * near) continue;
      for (std::size_t s = 0; s < body.body.shapes.size(); ++s)
        pile.moving.push_back({i, static_cast<std::uint16_t>(b), static_cast<std::uint16_t>(s), {}});
    }
  }
}

void turn(Pile& pile, std::size_t i)
{
  Mover& mover = pile.movers[i];
  const double left = pile.h - mover.clock;
  mover.clock = 0.0;
  mover.impacts = 0;
  if (mover.w.isZero(0.0)) return;
  const double decay = pile.kinds[mover.kind].model.spinDecay();
  turnBall(pile.q[i], decay > 0.0 ? turnIn(mover.w, decay, left) : Vector3d(left * mover.w));
  if (decay > 0.0) mover.w *= std::exp(-decay * pile.h);
}

// The rest of the forces acts where nothing carries the ball: velocity Verlet in free flight.
void endStep(WorldState& world)
{
  Pile& pile = world.pile;
  for (const std::uint32_t i : pile.awake)
  {
    Mover& mover = pile.movers[i];
    const Vector3d p = pile.p[i] + pile.h * mover.v;
    Vector3d v = mover.v;
    mover.half_owed = !mover.was_loaded && mover.loaded;
    if (!mover.was_loaded && !mover.loaded)
    {
      const Vector3d predicted = v + (0.5 * pile.h) * pile.flightAcceleration(i);
      v += (0.5 * pile.h) * (pile.a.empty() ? pile.flightAcceleration(i)
                                             : pile.kinds[mover.kind].model.acceleration(predicted, mover.w));
    }
    if (!(v.norm() < kFastest) || !p.allFinite())  // the ball keeps its last finite state
    {
      world.status.not_finite = true;
      mover.clock = 0.0;
      mover.impacts = 0;
      continue;
    }
    pile.p[i] = p;
    mover.v = v;
    turn(pile, i);
    pile.untouched[i] += static_cast<float>(pile.h);
    const Eigen::Vector3f way = (p - pile.home[i]).cast<float>();
    const bool there = (way - pile.anchor[i]).squaredNorm() < kPlace * kPlace;
    pile.still[i] = there ? pile.still[i] + static_cast<float>(pile.h) : 0.0f;
    if (!there) pile.anchor[i] = way;
  }
}

// Impulses of the last step are a guide for one of another length in its proportion.
void setLength(Pile& pile, double h)
{
  if (pile.h == h) return;
  const float ratio = pile.h > 0.0 ? static_cast<float>(h / pile.h) : 0.0f;
  const auto scale = [ratio](Push& push) {
    push.normal *= ratio;
    push.tangent *= ratio;
  };
  for (PairLink& link : pile.pairs) scale(link.push);
  for (BodyLink& link : pile.bodies) scale(link.push);
  pile.h = h;
}

void step(WorldState& world, double start, double h)
{
  Pile& pile = world.pile;
  setLength(pile, h);
  pile.start = start;
  pile.squeezed = 0;
  pile.least_impact = std::max(kNoImpact, kImpactInSteps * world.scene.forces.gravity.norm() * h);
  pile.step_mark = pile.counter + 1;
  accelerate(world);
  linkMovingBodies(world);
  updateLinks(world);
  if (pile.awake.empty() && pile.moving.empty()) return;
  resolveImpacts(world);
  solveContacts(world);
  endStep(world);
  settlePile(world);
}
}  // namespace

void turnBall(Quaterniond& q, const Vector3d& turn)
{
  const double x = 0.25 * turn.squaredNorm();  // of half the angle, squared
  if (x > 1e-2)
  {
    q = turned(q, turn, 1.0);
    return;
  }
  count(Law::Orientation);
  // Taylor series: the next terms are below 1e-17.
  const double sine = 1.0 - x / 6.0 * (1.0 - x / 20.0 * (1.0 - x / 42.0 * (1.0 - x / 72.0 * (1.0 - x / 110.0))));
  const double cosine = 1.0 - x / 2.0 * (1.0 - x / 12.0 * (1.0 - x / 30.0 * (1.0 - x / 56.0 * (1.0 - x / 90.0))));
  const Vector3d axis = (0.5 * sine) * turn;
  q = Quaterniond(cosine, axis.x(), axis.y(), axis.z()) * q;
  q.coeffs() *= 1.5 - 0.5 * q.squaredNorm();  // back to length 1
}

void clearPile(Pile& pile)
{
  pile.ball.clear();
  pile.movers.clear();
  pile.p.clear();
  pile.q.clear();
  pile.a.clear();
  pile.home.clear();
  pile.sweep.clear();
  pile.anchor.clear();
  pile.still.clear();
  pile.untouched.clear();
  pile.kinds.clear();
  pile.pairs.clear();
  pile.bodies.clear();
  pile.moving.clear();
  pile.awake.clear();
  pile.active_pairs.clear();
  pile.active_bodies.clear();
  pile.counter = 1;
  pile.steps = 0;
  pile.h = 0.0;
  pile.links_void = pile.active_void = true;
}

void reservePile(Pile& pile, std::size_t balls, bool constant_forces)
{
  pile.ball.reserve(balls);
  pile.movers.reserve(balls);
  pile.p.reserve(balls);
  pile.q.reserve(balls);
  if (!constant_forces) pile.a.reserve(balls);
  pile.home.reserve(balls);
  pile.sweep.reserve(balls);
  pile.anchor.reserve(balls);
  pile.still.reserve(balls);
  pile.untouched.reserve(balls);
  for (std::vector<PairLink>* links : {&pile.pairs, &pile.old_pairs}) links->reserve(kLinks * balls);
  for (std::vector<BodyLink>* links : {&pile.bodies, &pile.old_bodies, &pile.moving}) links->reserve(kLinks * balls);
  pile.awake.reserve(balls);
  for (std::vector<std::uint32_t>* list : {&pile.active_pairs, &pile.active_bodies, &pile.waking})
    list->reserve(kLinks * balls);
  pile.touches.reserve(kLinks * balls);
  pile.body_touches.reserve(kLinks * balls);
  pile.first_link.reserve(balls);
  pile.chain.reserve(kLinks * balls);
  pile.first_body.reserve(balls);
  pile.body_chain.reserve(kLinks * balls);
  pile.ahead.reserve(kLinks * balls);
  pile.grid.start.reserve(2 * balls + 3);
  pile.grid.cell.reserve(balls);
  pile.grid.entries.reserve(balls);
  pile.grid.large.reserve(balls);
  pile.grid.strays.reserve(balls);
}

void addToPile(WorldState& world, std::uint32_t ball, double time)
{
  Pile& pile = world.pile;
  pile.ball.push_back(ball);
  pile.movers.emplace_back();
  pile.p.emplace_back();
  pile.q.push_back(Quaterniond::Identity());
  if (!world.balls[ball].model.constant()) pile.a.push_back(Vector3d::Zero());
  pile.home.emplace_back();
  pile.sweep.push_back(Eigen::Vector3f::Zero());
  pile.anchor.push_back(Eigen::Vector3f::Zero());
  pile.still.push_back(0.0f);
  pile.untouched.push_back(0.0f);
  take(world, pile.ball.size() - 1, time);
}

void dropFromPile(Pile& pile, std::uint32_t ball)
{
  const auto found = std::find(pile.ball.begin(), pile.ball.end(), ball);
  if (found == pile.ball.end()) return;
  const auto slot = static_cast<std::uint32_t>(found - pile.ball.begin());
  wakeNear(pile, pile.p[slot], pile.radius(slot));
  const auto drop = [slot](auto& list) {
    if (slot < list.size()) list.erase(list.begin() + slot);
  };
  drop(pile.ball), drop(pile.movers), drop(pile.p), drop(pile.q), drop(pile.a), drop(pile.home);
  drop(pile.sweep), drop(pile.anchor), drop(pile.still), drop(pile.untouched);
  const auto forget = [](auto& links, const auto& its) {
    links.erase(std::remove_if(links.begin(), links.end(), its), links.end());
  };
  forget(pile.pairs, [slot](const PairLink& link) { return link.a == slot || link.b == slot; });
  forget(pile.bodies, [slot](const BodyLink& link) { return link.ball == slot; });
  for (PairLink& link : pile.pairs) link.a -= link.a > slot, link.b -= link.b > slot;
  for (BodyLink& link : pile.bodies) link.ball -= link.ball > slot;
  pile.links_void = pile.active_void = true;
}

void removeFromPile(Pile& pile, std::uint32_t ball)
{
  dropFromPile(pile, ball);
  for (std::uint32_t& other : pile.ball) other -= other > ball;
}

void disturbPile(WorldState& world)
{
  for (std::size_t slot = 0; slot < world.pile.ball.size(); ++slot)
  {
    world.balls[world.pile.ball[slot]].asleep = false;
    take(world, slot, world.time);
  }
}

void restatePile(WorldState& world, std::size_t slot)
{
  world.balls[world.pile.ball[slot]].asleep = false;
  wakeNear(world.pile, world.pile.p[slot], world.pile.radius(slot));
  take(world, slot, world.time);
  wakeNear(world.pile, world.pile.p[slot], world.pile.radius(slot));
}

void storeBall(WorldState& world, std::size_t slot, double time)
{
  const Pile& pile = world.pile;
  Segment& path = world.balls[pile.ball[slot]].path;
  path.start = time;
  path.c[0] = pile.p[slot];
  path.c[1] = pile.movers[slot].v;
  path.w_WB = pile.movers[slot].w;
  path.q_WB = pile.q[slot];
}

void runPile(WorldState& world, double start, double end, double longest_step)
{
  Pile& pile = world.pile;
  if (pile.ball.empty()) return;
  const double duration = end - start;
  const long steps = std::max(1L, std::lround(std::ceil(duration / longest_step - 1e-9)));
  const double h = duration / static_cast<double>(steps);
  for (long i = 0; i < steps; ++i) step(world, start + h * static_cast<double>(i), h);
  updateActive(pile);
  world.status.squeezed += pile.squeezed;
  for (const std::uint32_t i : pile.awake)
  {
    storeBall(world, i, end);
    world.balls[pile.ball[i]].asleep = false;
  }
}
}  // namespace ping_pong
