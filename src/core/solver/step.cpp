// The step of method `impulse`.
#include <algorithm>
#include <cmath>

#include "base/law_counter.h"
#include "evolve/flight.h"
#include "evolve/integrators.h"
#include "solver/slabs.h"
#include "solver/squeezed_in_solver.h"

namespace ping_pong
{
namespace
{
constexpr double kFastest = 1e8;        // squares of it, and their sums, are far from overflow [m/s]
constexpr double kNoImpact = 1e-9;      // slower is no impact: without any force [m/s],
constexpr double kImpactInSteps = 2.0;  // and else what gravity adds in so many steps
constexpr std::uint32_t kLastCount =
    1u << 31;  // a step that begins above this counts anew: days of steps, and it must not wrap

void accelerate(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  if (solver.a.empty()) return;
  for (std::size_t i = 0; i < solver.movers.size(); ++i)
  {
    const Mover& mover = solver.movers[i];
    if (mover.asleep) continue;
    solver.a[i] = solver.ball_types[mover.type].model.acceleration(mover.v, solver.w[i]);
    if ((mover.v + solver.h * solver.a[i]).norm() < kFastest) continue;
    solver.a[i].setZero();  // the step is too long for the drag: the ball goes straight on
    world.status.not_finite = true;
  }
}

double reachOf(const Body& body)
{
  double reach = 0.0;
  for (const Shape& shape : body.shapes) reach = std::max(reach, shape.p_BS.norm() + shape.half_size.norm());
  return reach;
}

// Bodies that move are neighbours of all balls nearby, in every step.
void findMovingNeighbours(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  solver.moving.clear();
  for (std::size_t b = 0; b < world.bodies.size(); ++b)
  {
    const BodyRecord& body = world.bodies[b];
    if (!body.moving) continue;
    const BodyFrame frame = frameAt(body.motion, solver.start - body.motion.start);
    const double size = reachOf(body.body);
    const double way = solver.h * (frame.v_WB.norm() + frame.w_WB.norm() * size + 0.5 * solver.h * frame.a_WB.norm());
    for (std::uint32_t i = 0; i < solver.movers.size(); ++i)
    {
      const double near = size + solver.radius(i) + way + solver.h * solver.movers[i].v.norm() + solver.margin;
      if ((solver.movers[i].p - frame.p_WB).squaredNorm() > near * near) continue;
      for (std::size_t s = 0; s < body.body.shapes.size(); ++s)
        solver.moving.push_back(
            {i, ContactSolver::kEndOfList, static_cast<std::uint16_t>(b), static_cast<std::uint16_t>(s)});
    }
  }
}

void rotate(ContactSolver& solver, std::size_t i)
{
  Mover& mover = solver.movers[i];
  Vector3d& w = solver.w[i];
  const double left = solver.h - mover.clock;
  mover.clock = 0.0;
  mover.impacts = 0;
  if (w.isZero(0.0)) return;
  const double decay = solver.ball_types[mover.type].model.spinDecay();
  solver.pending_rotation[i] += decay > 0.0 ? turnIn(w, decay, left) : Vector3d(left * w);
  if (decay > 0.0) w *= std::exp(-decay * solver.h);
}

// The rest of the forces acts where nothing carries the ball: velocity Verlet in free flight.
void endStep(ContactSolver& solver, SolverSlab& slab)
{
  for (const std::uint32_t i : slab.awake)
  {
    Mover& mover = solver.movers[i];
    const Vector3d p = solver.movers[i].p + solver.h * mover.v;
    Vector3d v = mover.v;
    mover.carried = (solver.carried_by[i] & ContactSolver::kCarried) != 0;
    mover.half_kick_due = !mover.was_carried && mover.carried;
    if (!mover.was_carried && !mover.carried)
    {
      const Vector3d predicted = v + (0.5 * solver.h) * solver.flightAcceleration(i);
      v += (0.5 * solver.h) * (solver.a.empty()
                                   ? solver.flightAcceleration(i)
                                   : solver.ball_types[mover.type].model.acceleration(predicted, solver.w[i]));
    }
    if (!(v.squaredNorm() < kFastest * kFastest) || !p.allFinite())  // the ball keeps its last finite state
    {
      slab.not_finite = true;
      mover.clock = 0.0;
      mover.impacts = 0;
      continue;
    }
    solver.movers[i].p = p;
    mover.v = v;
    mover.too_slow_for_impacts = mover.carried && v.squaredNorm() < 0.25 * solver.least_impact * solver.least_impact;
    rotate(solver, i);
    if (solver.carried_by[i] & ContactSolver::kByBall) solver.since_contact[i] = 0.0f;
    solver.since_contact[i] += static_cast<float>(solver.h);
    const Eigen::Vector3f way = (p - solver.home[i]).cast<float>();
    const bool there = (way - solver.anchor[i]).squaredNorm() < kRestRadius * kRestRadius;
    solver.still[i] = there ? solver.still[i] + static_cast<float>(solver.h) : 0.0f;
    if (!there) solver.anchor[i] = way;
  }
}

// Impulses of the last step are a guide for one of another length in its proportion.
void setLength(ContactSolver& solver, double h)
{
  if (solver.h == h) return;
  const float ratio = solver.h > 0.0 ? static_cast<float>(h / solver.h) : 0.0f;
  for (Lanes& impulse : solver.impulses) impulse *= ratio;
  for (BodyNeighbour& neighbour : solver.bodies) neighbour.impulse *= ratio;
  solver.h = h;
}

// What was noted on the counter is long ago. Between steps nobody asks for more.
void restartCounter(ContactSolver& solver)
{
  solver.counter = 1;
  for (Mover& mover : solver.movers) mover.last_impact = 0;
  std::fill(solver.last_iteration.begin(), solver.last_iteration.end(), 0u);
  for (SolverSlab& slab : solver.slabs) slab.changed = 0;
}

void step(WorldWithSolver& world, double start, double end, double h)
{
  ContactSolver& solver = world.solver;
  if (solver.counter > kLastCount) restartCounter(solver);
  setLength(solver, h);
  solver.start = start;
  solver.end = end;
  for (SolverSlab& slab : solver.slabs) slab.squeezed = 0;
  solver.least_impact = std::max(kNoImpact, kImpactInSteps * world.scene.forces.gravity.norm() * h);
  solver.step_mark = solver.counter + 1;
  accelerate(world);
  findMovingNeighbours(world);
  updateNeighbours(world);
  if (!solver.anyAwake() && solver.moving.empty()) return;
  if (!solver.moving.empty()) keepStartPositions(solver);
  resolveImpacts(world);
  solveContacts(world);
  findPressing(solver);
  eachSlab(world, [&](SolverSlab& slab) { applyContacts(world, slab); });
  if (solver.pressing > 0.0) limitEnergies(solver);
  eachSlab(world, [&](SolverSlab& slab) { endStep(solver, slab); });
  if (solver.pressing > 0.0) findSqueezed(world);
  updateSleep(world);
}
}  // namespace

void applyRotation(ContactSolver& solver, std::size_t slot)
{
  const Vector3d rotation = solver.pending_rotation[slot];
  if (rotation.isZero(0.0)) return;
  Quaterniond& q = solver.q[slot];
  solver.pending_rotation[slot].setZero();
  const double x = 0.25 * rotation.squaredNorm();  // of half the angle, squared
  if (x > 1e-2)
  {
    q = turned(q, rotation, 1.0);
    return;
  }
  count(Law::Orientation);
  // Taylor series: the next terms are below 1e-17.
  const double sine = 1.0 + x * (-1.0 / 6 + x * (1.0 / 120 + x * (-1.0 / 5040 + x * (1.0 / 362880 - x / 39916800))));
  const double cosine = 1.0 + x * (-1.0 / 2 + x * (1.0 / 24 + x * (-1.0 / 720 + x * (1.0 / 40320 - x / 3628800))));
  const Vector3d axis = (0.5 * sine) * rotation;
  q = Quaterniond(cosine, axis.x(), axis.y(), axis.z()) * q;
  q.coeffs() *= 1.5 - 0.5 * q.squaredNorm();  // back to length 1
}

void stepSolver(WorldWithSolver& world, double start, double end, double longest_step)
{
  ContactSolver& solver = world.solver;
  if (solver.ball.empty()) return;
  const double duration = end - start;
  const long steps =
      std::max(1L, std::lround(std::ceil(duration / shortEnough(world, start, end, longest_step) - 1e-9)));
  const double h = duration / static_cast<double>(steps);
  const auto startOf = [&](long i) { return i == steps ? end : start + h * static_cast<double>(i); };
  for (long i = 0; i < steps && !solver.ball.empty(); ++i)
  {
    step(world, startOf(i), startOf(i + 1), h);
    if (i + 1 < steps) takeOutSqueezed(world);
  }
  if (solver.ball.empty()) return;
  updateActive(world);
  eachSlab(world,
           [&](SolverSlab& slab)
           {
             for (const std::uint32_t i : slab.awake)
             {
               storeBall(world, i, end);
               world.balls[solver.ball[i]].wake();
             }
           });
  takeOutSqueezed(world);  // last: slots of others change
  for (SolverSlab& slab : solver.slabs)
  {
    world.status.squeezed += slab.squeezed;
    world.status.not_finite |= slab.not_finite;
    slab.not_finite = false;
  }
}
}  // namespace ping_pong
