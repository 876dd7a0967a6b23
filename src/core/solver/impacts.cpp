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
// Of one ball in one step. The last has to be 4^15 times as fast as the least impact: beyond, contacts take over anyway.
constexpr int kMostImpacts = 15;

// From t on the ball flies with this state: its path is drawn back to the start of the step.
void changePath(ContactSolver& solver, std::size_t i, const BallState& state, double t)
{
  Mover& mover = solver.movers[i];
  solver.pending_rotation[i] += (t - mover.clock) * solver.w[i];
  applyRotation(solver, i);  // about another axis from now on
  const Vector3d a = solver.pathAcceleration(i);
  mover.v = state.v_WB - t * a;
  solver.w[i] = state.w_WB;
  mover.p = state.p_WB - t * (state.v_WB - (0.5 * t) * a);
  mover.clock = t;
  mover.last_impact = solver.counter;
  mover.too_slow_for_impacts = false;
  ++mover.impacts;
}

// An impact of the ball in slot i. No later than the step ends: rounding may say so.
void record(WorldWithSolver& world, std::uint32_t i, const HitObject& other, double t, const BallState& before,
            const BallState& after, const Vector3d& n, const Vector3d& u, const Vector3d& impulse)
{
  ++world.status.events;
  const std::uint32_t ball = world.solver.ball[i];
  recordContact(world, world.balls[ball], ball, other,
                {std::min(world.solver.start + t, world.solver.end), n, u, before.p_WB, before.v_WB, after.v_WB,
                 before.w_WB, after.w_WB, impulse});
}

// --- two balls ---

void hitPair(WorldWithSolver& world, const NeighbourPair& pair, double t)
{
  ContactSolver& solver = world.solver;
  BallState a = stateAt(solver, pair.a, t), b = stateAt(solver, pair.b, t);
  solver.wake(pair.a);
  solver.wake(pair.b);
  const Vector3d n = (a.p_WB - b.p_WB).normalized();
  const double closing = -n.dot(a.v_WB - b.v_WB);
  const BallParams &params_a = solver.params(pair.a), &params_b = solver.params(pair.b);
  const Surface& law = world.scene.surfaces.at(params_a.material, params_b.material);
  const Vector3d p_WC = a.p_WB - params_a.radius * n;
  const Vector3d v_other = b.v_WB + b.w_WB.cross(p_WC - b.p_WB);
  if (!solver.moving.empty())
    for (const std::uint32_t i : {pair.a, pair.b}) noteOther(solver, i);
  const BallState before = a;
  const Vector3d impulse = part(law, law.restitutionAt(closing) * closing, params_a, a, params_b, b, n);
  record(world, pair.a, HitObject::ballOf(world.balls[solver.ball[pair.b]].id), t, before, a, n, v_other, impulse);
  changePath(solver, pair.a, a, t);
  changePath(solver, pair.b, b, t);
  solver.since_contact[pair.a] = solver.since_contact[pair.b] = 0.0f;
}

// --- a ball and a shape ---

void hitBody(WorldWithSolver& world, const BodyNeighbour& neighbour, double t)
{
  ContactSolver& solver = world.solver;
  const std::uint32_t i = neighbour.ball;
  const BodyRecord& body = world.bodies[neighbour.body];
  const Shape& shape = body.shapes()[neighbour.shape];
  BallState state = stateAt(solver, i, t);
  const BodyFrame frame = body.at(solver.start + t);
  const Gap gap = gapTo(shape, frame, state.p_WB, state.v_WB, solver.radius(i));
  solver.wake(i);
  const Vector3d p_WC = state.p_WB - solver.radius(i) * gap.n_W;
  const Vector3d u = body.moving ? frame.pointVelocity(p_WC) : Vector3d::Zero();
  Surface law = world.scene.surfaces.at(solver.params(i).material, shape.material);
  const bool along = body.moving && takesAlong(solver, neighbour, t);
  if (along) law.restitution = 0.0;
  if (!body.moving && !solver.moving.empty()) noteOther(solver, i);
  const BallState before = state;
  Vector3d impulse = bounce(law, solver.params(i), state, u, gap.n_W);
  if (along) limitImpulse(solver.params(i), before, u.norm(), state, impulse);
  record(world, i, HitObject::shapeOf(neighbour.body, neighbour.shape), t, before, state, gap.n_W, u, impulse);
  changePath(solver, i, state, t);
}

// --- in the order of time ---

bool later(const PredictedImpact& p, const PredictedImpact& q)
{
  return p.time != q.time ? p.time > q.time : p.neighbour > q.neighbour;
}

bool impactsExhausted(const ContactSolver& solver, std::uint32_t i)
{
  return solver.movers[i].impacts >= kMostImpacts;
}

double nextOfPair(const ContactSolver& solver, const NeighbourPair& pair)
{
  if (solver.movers[pair.a].too_slow_for_impacts && solver.movers[pair.b].too_slow_for_impacts) return kNever;
  if (impactsExhausted(solver, pair.a) || impactsExhausted(solver, pair.b)) return kNever;
  count(Law::PairSearch);
  return pairImpact(solver, pair);
}

double nextWithBody(const WorldWithSolver& world, const BodyNeighbour& neighbour)
{
  const bool still = !world.bodies[neighbour.body].moving;
  if (impactsExhausted(world.solver, neighbour.ball) ||
      (still && world.solver.movers[neighbour.ball].too_slow_for_impacts))
    return kNever;
  return bodyImpact(world, neighbour);
}

void predictInSlab(const WorldWithSolver& world, SolverSlab& slab)
{
  const ContactSolver& solver = world.solver;
  slab.ahead.clear();
  const auto note = [&](double t, NeighbourRef neighbour)
  {
    if (t <= solver.h) slab.ahead.push_back({t, neighbour, solver.counter});
  };
  for (const std::uint32_t l : slab.active_bodies)
    note(nextWithBody(world, solver.bodies[l]), {l, NeighbourRef::StillBodies});
  for (const std::uint32_t l : slab.active_pairs) note(nextOfPair(solver, solver.pairs[l]), {l, NeighbourRef::Pairs});
}

void predictAll(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  eachSlab(world, [&world](SolverSlab& slab) { predictInSlab(world, slab); });
  solver.ahead.clear();
  for (std::uint32_t l = 0; l < solver.moving.size(); ++l)
    if (const double t = nextWithBody(world, solver.moving[l]); t <= solver.h)
      solver.ahead.push_back({t, {l, NeighbourRef::MovingBodies}, solver.counter});
  for (const SolverSlab& slab : solver.slabs)
    solver.ahead.insert(solver.ahead.end(), slab.ahead.begin(), slab.ahead.end());
  std::make_heap(solver.ahead.begin(), solver.ahead.end(), later);
}

// The ball has another path.
void predictAgain(WorldWithSolver& world, std::uint32_t i)
{
  ContactSolver& solver = world.solver;
  const auto note = [&solver](double t, NeighbourRef neighbour)
  {
    if (!(t <= solver.h)) return;
    solver.ahead.push_back({t, neighbour, solver.counter});
    std::push_heap(solver.ahead.begin(), solver.ahead.end(), later);
  };
  for (std::uint32_t l = 0; l < solver.moving.size(); ++l)
    if (solver.moving[l].ball == i) note(nextWithBody(world, solver.moving[l]), {l, NeighbourRef::MovingBodies});
  for (std::uint32_t l = solver.first_body[i]; l != ContactSolver::kEndOfList; l = solver.bodies[l].next)
    note(nextWithBody(world, solver.bodies[l]), {l, NeighbourRef::StillBodies});
  solver.anyPair(i,
                 [&](std::uint32_t l)
                 {
                   note(nextOfPair(solver, solver.pairs[l]), {l, NeighbourRef::Pairs});
                   return false;
                 });
}

// Handles one impact; balls that it has thrown off their path are put into a and b, twice the same if it is but one.
bool handle(WorldWithSolver& world, const PredictedImpact& impact, std::uint32_t& a, std::uint32_t& b)
{
  ContactSolver& solver = world.solver;
  const std::uint32_t l = impact.neighbour.index;
  const bool pair = impact.neighbour.list == NeighbourRef::Pairs,
             still = impact.neighbour.list == NeighbourRef::StillBodies;
  a = pair ? solver.pairs[l].a : still ? solver.bodies[l].ball : solver.moving[l].ball;
  b = pair ? solver.pairs[l].b : a;
  if (solver.movers[a].last_impact > impact.predicted_at || solver.movers[b].last_impact > impact.predicted_at)
    return false;
  ++solver.counter;
  if (pair)
    hitPair(world, solver.pairs[l], impact.time);
  else
    hitBody(world, still ? solver.bodies[l] : solver.moving[l], impact.time);
  return true;
}
}  // namespace

void resolveImpacts(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  predictAll(world);
  while (!solver.ahead.empty())
  {
    const PredictedImpact next = solver.ahead.front();
    std::pop_heap(solver.ahead.begin(), solver.ahead.end(), later);
    solver.ahead.pop_back();
    std::uint32_t a, b;
    if (!handle(world, next, a, b)) continue;
    if (updateNeighboursAfterImpact(world, a, b))
    {
      predictAll(world);
      continue;
    }
    predictAgain(world, a);
    if (b != a) predictAgain(world, b);
  }
  updateActive(world);
}
}  // namespace ping_pong
