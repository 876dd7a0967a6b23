#include "solver/squeezed_in_solver.h"

#include <algorithm>
#include <cmath>

#include "solver/seams.h"
#include "state/free_space.h"
#include "state/squeeze.h"

namespace ping_pong
{
namespace
{
constexpr double kPartOfRadius = 0.25;  // way of a body in a step, of the radius of a ball near it;
constexpr double kMostPieces = 64.0;    // but no more steps than this instead of one
constexpr double kOneContact =
    1e-3;  // hits sooner after each other are one: a contact of a real ball lasts as long [s]
constexpr double kFlees =
    8.0;  // times the speed of a body: two surfaces press no ball out faster. Planes tilted by 1 / 8
constexpr double kElastic = 2.0;  // the same for balls that others press on: what an elastic hit by the body gives
constexpr double kDeep = 1e-4;    // overlap that there is no room for [m],
constexpr double kPartOfWay =
    0.5;  // and this part of the way of the body, where an iteration that was cut short may leave it

double sizeOf(const Body& body)
{
  double size = 0.0;
  for (const Shape& shape : body.shapes) size = std::max(size, shape.p_BS.norm() + shape.half_size.norm());
  return size;
}

// The least radius of balls that a body may come near until `end`; infinite if there are none.
double leastRadiusNear(const ContactSolver& solver, const Vector3d& p_WB, double reach, double duration)
{
  double least = kNever;
  for (std::size_t i = 0; i < solver.movers.size(); ++i)
  {
    const double radius = solver.radius(i), near = reach + radius + duration * solver.movers[i].v.norm();
    if ((solver.movers[i].p - p_WB).squaredNorm() < near * near) least = std::min(least, radius);
  }
  return least;
}

const BodyNeighbour& neighbourOf(const ContactSolver& solver, const BodyConstraint& constraint)
{
  return constraint.moving ? solver.moving[constraint.neighbour] : solver.bodies[constraint.neighbour];
}

// Twice a kinetic energy by the mass, that of the spin with it [m^2/s^2].
double energyOf(const BallParams& ball, const Vector3d& v, const Vector3d& w)
{
  return v.squaredNorm() + ball.inertia * ball.radius * ball.radius * w.squaredNorm();
}

// What contacts have added to the energy of a ball beyond what a body that presses accounts for; negative if they have taken some.
double excessOf(const ContactSolver& solver, std::size_t i)
{
  const BallParams& ball = solver.params(i);
  const Change& change = solver.changes[i];
  const Vector3d &v = solver.movers[i].v, &w = solver.w[i];
  const Vector3d v_before = v - change.v.head<3>().cast<double>();
  const Vector3d w_before = w - change.surface_velocity.head<3>().cast<double>() / ball.radius;
  const double now = energyOf(ball, v, w), before = energyOf(ball, v_before, w_before);
  if (now <= before) return now - before;
  const double of_body = ((solver.carried_by[i] & ContactSolver::kByBall) != 0 ? kElastic : kFlees) * solver.pressing;
  return std::max(now - std::max(before, of_body * of_body), 0.0);
}

bool presses(const SolverSlab& slab, const BodyConstraint& constraint)
{
  return slab.body_batches[constraint.index.batch()].normal[constraint.index.lane()] > 0.0f;
}

// Deeper than before and than the contacts of this step may leave it.
bool hasNoRoom(const WorldWithSolver& world, const BodyConstraint& constraint)
{
  const ContactSolver& solver = world.solver;
  const std::uint32_t i = constraint.ball;
  const BodyNeighbour& neighbour = neighbourOf(solver, constraint);
  const double radius = solver.radius(i);
  const double overlap = radius - nearestOf(world, neighbour, solver.movers[i].p, solver.h).distance;
  if (overlap <= kDeep) return false;
  const bool others = (solver.carried_by[i] & ContactSolver::kByBall) != 0;
  const double left = others ? kPartOfWay * solver.h * solver.pressing : 0.0;
  return overlap > kDeep + left &&
         overlap > radius - nearestOf(world, neighbour, solver.start_positions[i], 0.0).distance;
}
}  // namespace

double shortEnough(const WorldWithSolver& world, double start, double end, double longest)
{
  const double duration = end - start, most = std::min(longest, duration);
  double least = kNever, h = longest;
  for (const SolverBallType& type : world.solver.ball_types) least = std::min(least, type.params.radius);
  for (const BodyRecord& body : world.bodies)
  {
    if (!body.moving) continue;
    const BodyFrame frame = frameAt(body.motion, start - body.motion.start);
    const double size = sizeOf(body.body),
                 speed = frame.v_WB.norm() + frame.w_WB.norm() * size + duration * frame.a_WB.norm();
    if (speed * most <= kPartOfRadius * least) continue;
    const double radius = leastRadiusNear(world.solver, frame.p_WB, size + duration * speed, duration);
    if (radius < kNever) h = std::min(h, std::max(kPartOfRadius * radius / speed, most / kMostPieces));
  }
  return h;
}

void keepStartPositions(ContactSolver& solver)
{
  for (std::size_t i = 0; i < solver.movers.size(); ++i) solver.start_positions[i] = solver.movers[i].p;
}

bool takesAlong(ContactSolver& solver, const BodyNeighbour& neighbour, double t)
{
  BodyHit& last = solver.last_hits[neighbour.ball];
  const double now = solver.start + t;
  const bool again = (last.other || last.body != neighbour.body) && now - last.time < kOneContact;
  last = {now, neighbour.body, again};
  return again;
}

void limitImpulse(const BallParams& ball, const BallState& before, double speed, BallState& after, Vector3d& impulse)
{
  const double gyration = ball.inertia * ball.radius * ball.radius;  // energies are in (m/s)^2
  const auto product = [gyration](const Vector3d& v, const Vector3d& w, const Vector3d& v2, const Vector3d& w2)
  { return v.dot(v2) + gyration * w.dot(w2); };
  const double had = product(before.v_WB, before.w_WB, before.v_WB, before.w_WB);
  const double room = std::max(speed * speed - had, 0.0);
  const Vector3d dv = after.v_WB - before.v_WB, dw = after.w_WB - before.w_WB;
  const double a = product(dv, dw, dv, dw),
               b = product(before.v_WB, before.w_WB, dv, dw);  // a part of the change adds (a part + 2 b) part
  if (a + 2.0 * b <= room) return;
  const double part = std::clamp((std::sqrt(b * b + a * room) - b) / a, 0.0, 1.0);
  after.v_WB = before.v_WB + part * dv;
  after.w_WB = before.w_WB + part * dw;
  impulse *= part;
}

void noteOther(ContactSolver& solver, std::uint32_t ball)
{
  solver.last_hits[ball].other = true;
}

void findPressing(ContactSolver& solver)
{
  solver.pressing = 0.0;
  if (solver.moving.empty()) return;
  for (const SolverSlab& slab : solver.slabs)
    for (const BodyConstraint& constraint : slab.body_constraints)
      if (constraint.moving && presses(slab, constraint))
        solver.pressing = std::max(solver.pressing, constraint.u.norm());
}

void limitEnergies(ContactSolver& solver)
{
  double lost = 0.0, gained = 0.0;
  for (std::size_t i = 0; i < solver.movers.size(); ++i)
  {
    const double excess = solver.params(i).mass * excessOf(solver, i);
    (excess > 0.0 ? gained : lost) += std::abs(excess);
  }
  if (gained <= lost) return;
  for (std::size_t i = 0; i < solver.movers.size(); ++i)
  {
    const double excess = excessOf(solver, i);
    if (excess <= 0.0) continue;
    Vector3d &v = solver.movers[i].v, &w = solver.w[i];
    const double part = std::sqrt(1.0 - (1.0 - lost / gained) * excess / energyOf(solver.params(i), v, w));
    v *= part;
    w *= part;
  }
}

void findSqueezed(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  for (const SolverSlab& slab : solver.slabs)
    for (const BodyConstraint& constraint : slab.body_constraints)
      if (hasNoRoom(world, constraint))
        solver.squeezed.push_back({solver.ball[constraint.ball], solver.start_positions[constraint.ball]});
  const auto before = [](const SqueezedBall& a, const SqueezedBall& b) { return a.ball < b.ball; };
  const auto same = [](const SqueezedBall& a, const SqueezedBall& b) { return a.ball == b.ball; };
  std::sort(solver.squeezed.begin(), solver.squeezed.end(), before);
  solver.squeezed.erase(std::unique(solver.squeezed.begin(), solver.squeezed.end(), same), solver.squeezed.end());
}

void takeOutSqueezed(WorldWithSolver& world)
{
  ContactSolver& solver = world.solver;
  for (const SqueezedBall& ball : solver.squeezed)
  {
    BallRecord& record = world.balls[ball.ball];
    storeBall(world, slotOf(solver, ball.ball), solver.end);
    dropFromSolver(solver, ball.ball);
    BallState state = record.stateAt(solver.end);
    state.p_WB = ball.p_WB;
    state.w_WB.setZero();
    pushOutOfStill(world, state.p_WB, record.params().radius);
    squeeze(world, record, state, solver.end);
  }
  solver.squeezed.clear();
}
}  // namespace ping_pong
