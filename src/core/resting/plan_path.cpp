#include "resting/plan_path.h"

#include <Eigen/QR>
#include <cmath>
#include <optional>

#include "evolve/flight.h"
#include "evolve/integrators.h"
#include "resting/at_once.h"
#include "resting/constrained_piece.h"
#include "state/body_gap.h"
#include "state/collapse_guard.h"

namespace ping_pong
{
namespace
{
constexpr double kKeepGap = 1e-6;           // a support is left from further than this [m]
constexpr double kStillSpeed = 1e-12;       // below: rounding, the ball lies still [m/s]
constexpr double kRoundedFraction = 1e-12;  // accelerations below this part of all there are are rounding
constexpr double kTouchedFraction = 1e-7;   // parting with less than this part of them, a ball still touches
constexpr double kMostTouched = 1e-3;       // the same where contact and parting have followed each other without end
constexpr int kProjections = 4;             // rounds of Newton: from 1e-6 m to rounding in two
constexpr double kNearlyParallel = 0.02;    // angle between two normals [rad]
constexpr double kShareOfPieces = 0.1;      // of the tolerance
constexpr double kLeastTolerance = 1e-14;   // rounding [m]
constexpr double kTouchedGap = 1e-12;       // a surface this near is touched [m]
constexpr double kSameNormal = 1e-7;        // difference of normals of surfaces that continue each other

// What can be stopped within the grip time is stopped at once: the error is a fraction of g t^2, of the tolerance. Paths that
// end one after the other in no time make it longer, so that they come to an end.
constexpr double kShareOfStops = 1e-3;       // of the tolerance
constexpr double kUsualAcceleration = 10.0;  // about gravity [m/s^2]
constexpr double kShortestGrip = 3e-8;       // g t^2 is 1e-14 m: rounding [s]
constexpr double kShortestPiece = 3e-8;      // [s]
constexpr double kLongestGrip = 1e-3;        // stops what slips at 1 cm/s at most [s]
constexpr double kShortPath = 1e-3;          // [s]
constexpr double kSameTime = 1e-9;           // [s]
constexpr double kShortestMotion = 1e-5;     // of a body: a path may be as much longer [s]
constexpr std::uint32_t kPatience = 50;      // short paths in a row: a few modes may well follow each other at once

// Doubles with every short path beyond patience.
double grown(double time, const Supports& supports)
{
  const std::uint32_t impatient = supports.shortPaths() > kPatience ? supports.shortPaths() - kPatience : 0;
  return std::min(kLongestGrip, std::ldexp(time, static_cast<int>(impatient)));
}

double gripTime(const WorldState& world, const Supports& supports)
{
  return grown(std::max(kShortestGrip, std::sqrt(kShareOfStops * world.scene.tolerance / kUsualAcceleration)),
               supports);
}

Gap gapOver(const WorldState& world, const BallRecord& ball, const Supports::Surface& support, const BallState& state,
            double t)
{
  const BodyRecord& body = world.bodies[support.body];
  return gapOver(body, body.shapes()[support.shape], state, ball.params().radius, t);
}

// Where surfaces throw the ball at each other without end, small impacts are taken by all that it touches.
double keepSpeed(const BallRecord& ball)
{
  return ball.quick_contacts > kManyQuick ? kNoReboundSpeed : kKeepSpeed;
}

bool touches(const Gap& gap, double keep_speed)
{
  return std::abs(gap.gap) <= kKeepGap && std::abs(gap.rate) <= keep_speed;
}

// The ball is put on the surface and moves along it; false if it is off the surface or moves away or into it.
bool projectOn(const Gap& gap, double keep_speed, BallState& ball)
{
  if (!touches(gap, keep_speed)) return false;
  ball.p_WB -= gap.gap * gap.n_W;
  ball.v_WB -= gap.rate * gap.n_W;
  return true;
}

constexpr auto kMostSupports = static_cast<int>(Supports::kMax);
using Normals = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, kMostSupports, 3>;
using GapsAndRates = Eigen::Matrix<double, Eigen::Dynamic, 2, 0, kMostSupports, 2>;

// Gaps and rates of all that the ball touches; false if it is on all of them.
bool offSurfaces(const WorldState& world, const BallRecord& ball, const BallState& state, double t, Normals& normals,
                 GapsAndRates& off)
{
  const double tolerance = touchTolerance(state.p_WB, ball.params().radius);
  normals.resize(ball.supports.count(), 3);
  off.resize(ball.supports.count(), 2);
  normals.setZero();
  off.setZero();
  for (std::size_t i = 0; i < ball.supports.count(); ++i)
  {
    const Gap gap = gapOver(world, ball, ball.supports[i], state, t);
    if (!touches(gap, keepSpeed(ball))) continue;
    normals.row(i) = gap.n_W.transpose();
    off.row(i) << gap.gap, gap.rate;
  }
  return (off.col(0).array().abs() > tolerance).any() || (off.col(1).array().abs() > 1e-16).any();
}

// A support that the ball is in or moves into; one that it moves away from is left as it is.
void pushOff(const Gap& gap, double keep_speed, BallState& ball)
{
  if (!touches(gap, keep_speed)) return;
  ball.p_WB -= std::min(gap.gap, 0.0) * gap.n_W;
  ball.v_WB -= std::min(gap.rate, 0.0) * gap.n_W;
}

// Projecting on one surface shifts the ball on the others. Onto all at once, then, by the least shift; curved ones take a few
// rounds (Newton). Surfaces that nearly continue each other can shift it far: it is pushed out of these one by one, and
// leaves what the steeper one takes it away from.
void projectOnAll(const WorldState& world, const BallRecord& ball, BallState& state, double t)
{
  if (ball.supports.count() < 2) return;
  Normals normals;
  GapsAndRates off;
  for (int round = 0; round < kProjections; ++round)
  {
    if (!offSurfaces(world, ball, state, t, normals, off)) return;
    Eigen::CompleteOrthogonalDecomposition<Normals> solver;
    solver.setThreshold(kNearlyParallel);
    solver.compute(normals);
    const Eigen::Matrix<double, 3, 2> shift = solver.solve(off);
    state.p_WB -= shift.col(0);
    state.v_WB -= shift.col(1);
  }
  for (int round = 0; round < kProjections; ++round)
  {
    if (!offSurfaces(world, ball, state, t, normals, off)) return;
    for (std::size_t i = 0; i < ball.supports.count(); ++i)
      pushOff(gapOver(world, ball, ball.supports[i], state, t), keepSpeed(ball), state);
  }
}

void dropSurfacesLeft(const WorldState& world, BallRecord& ball, BallState& state, double t)
{
  for (std::size_t i = ball.supports.count(); i-- > 0;)
    if (!projectOn(gapOver(world, ball, ball.supports[i], state, t), keepSpeed(ball), state)) ball.supports.remove(i);
  projectOnAll(world, ball, state, t);
}

// The closest point of the shape lies on a plane.
bool onFlat(const BodyRecord& body, const Shape& shape, const BallState& state, double t)
{
  return flat(shape, featureAt(shape, body.seenFrom(state.p_WB, t)));
}

// A face of another shape, flush with what the ball lies on: its normal is the same, and the ball touches it, too.
bool flushFace(const BodyRecord& body, const Shape& shape, const BallRecord& ball, const BallState& state,
               const Vector3d& n_W, double t)
{
  if (!onFlat(body, shape, state, t)) return false;
  const Gap gap = gapOver(body, shape, state, ball.params().radius, t);
  return std::abs(gap.gap) <= flushTolerance(state.p_WB, ball.params().radius) && (gap.n_W - n_W).norm() <= kSameNormal;
}

// Beyond the border of a face a flush one carries the ball on, not the edge between both.
void passToFlushFaces(const WorldState& world, BallRecord& ball, const BallState& state, double t)
{
  for (std::size_t i = ball.supports.count(); i-- > 0;)
  {
    const Supports::Surface support = ball.supports[i];
    const BodyRecord& its_body = world.bodies[support.body];
    if (onFlat(its_body, its_body.shapes()[support.shape], state, t)) continue;
    const Vector3d n = gapOver(world, ball, support, state, t).n_W;
    for (std::size_t b = 0; b < world.bodies.size(); ++b)
    {
      const BodyRecord& body = world.bodies[b];
      if (b != support.body && (body.moving || its_body.moving)) continue;
      for (std::size_t s = 0; s < body.shapes().size(); ++s)
        if (!ball.supports.has(b, s) && flushFace(body, body.shapes()[s], ball, state, n, t))
        {
          ball.supports.replace(i, b, s);
          b = world.bodies.size() - 1;
          break;
        }
    }
  }
}

// What carries the ball already has this normal.
bool supportedAlong(const WorldState& world, const BallRecord& ball, const BallState& state, const Vector3d& n_W,
                    double t)
{
  for (std::size_t i = 0; i < ball.supports.count(); ++i)
    if ((gapOver(world, ball, ball.supports[i], state, t).n_W - n_W).norm() < kSameNormal) return true;
  return false;
}

bool onMovingBody(const WorldState& world, const Supports& supports)
{
  for (std::size_t i = 0; i < supports.count(); ++i)
    if (world.bodies[supports[i].body].moving) return true;
  return false;
}

double leavesFirstFace(const WorldState& world, const Supports& supports, const Segment& path, double t)
{
  double first = kNever;
  for (std::size_t i = 0; i < supports.count(); ++i)
  {
    const BodyRecord& body = world.bodies[supports[i].body];
    first = std::min(first, leavesFace(path, body.shapes()[supports[i].shape], body.frame(), t, kNever));
  }
  return first;
}

// --- closed forms ---

bool along(const Vector3d& x, const Vector3d& change)
{
  return x.cross(change).norm() <= 1e-12 * x.norm() * (change.norm() + 1.0);
}

// What slips and rolls keeps its direction: it changes along itself, or along the direction in which it begins.
bool straight(const Decision& decision, const BallMotion& ball)
{
  const ContactProblem& problem = decision.problem;
  const double begun = noSpeed(ball);
  const auto keeps = [&](Resistance kind, const Vector3d& value, const Vector3d& direction, const Vector3d& rate)
  { return kind != Resistance::Slips || along(value.norm() > begun ? value : direction, rate); };
  for (std::size_t i = 0; i < problem.count; ++i)
  {
    const SupportPoint& at = problem.at[i];
    const SupportMode& mode = problem.mode[i];
    if (!keeps(mode.slip, at.slip, mode.slip_direction, slipRate(at, decision.motion))) return false;
    if (!keeps(mode.roll, at.roll, mode.roll_direction, rollRate(at, decision.motion))) return false;
  }
  return true;
}

bool atRest(const ConstrainedBall& constrained, const Decision& decision, const BallMotion& ball)
{
  for (std::size_t i = 0; i < constrained.count; ++i)
    if (!constrained.surface[i].still) return false;
  return ball.v.norm() < kStillSpeed && decision.motion.a.isZero(0.0) && decision.motion.b.isZero(0.0);
}

// Whether the acceleration stays what it is now for as long as modes and faces do.
bool steady(const ConstrainedBall& constrained, const Decision& decision, const BallMotion& ball)
{
  if (atRest(constrained, decision, ball)) return true;
  if (!constrained.model.constant()) return false;
  if (constrained.model.spinDecay() != 0.0 && !(ball.s.isZero(0.0) && decision.motion.b.isZero(0.0))) return false;
  for (std::size_t i = 0; i < constrained.count; ++i)
    if (!constrained.surface[i].plane()) return false;
  return straight(decision, ball);
}

void moveSteadily(const WorldState& world, BallRecord& ball, const ConstrainedBall& constrained,
                  const Decision& decision, const BallMotion& motion, double t, double window_end)
{
  Segment& path = ball.path;
  const bool still = atRest(constrained, decision, motion);
  path.degree = still ? 0 : 2;
  path.c[1] = still ? Vector3d(Vector3d::Zero()) : motion.v;
  path.c[2] = 0.5 * decision.motion.a;
  if (!decision.motion.b.isZero(0.0)) path.higher.make().alpha_WB = decision.motion.b / constrained.radius;
  if (still) return;
  path.end = std::min(leavesFirstFace(world, ball.supports, path, t), t + slipsFor(decision));
  // On a moving body the caller plans anew at the next window; the path only has to reach it.
  if (onMovingBody(world, ball.supports) && path.end > window_end) path.end = kNever;
}

void moveOnPiece(const WorldState& world, BallRecord& ball, const ConstrainedBall& constrained,
                 const Decision& decision, const BallMotion& motion, double t, double window_end, double next_piece)
{
  const bool moving = onMovingBody(world, ball.supports) && window_end > t;
  const double tolerance = std::max(kShareOfPieces * world.scene.tolerance, kLeastTolerance);
  ball.path.higher.make().spin.make().next_piece = next_piece;
  layConstrainedPiece(constrained, decision, motion, t, moving ? std::max(window_end - t, kShortestMotion) : kNever,
                      tolerance, grown(kShortestPiece, ball.supports), ball.path);
  if (moving && ball.path.end >= window_end - kSameTime)
    ball.path.end = window_end + kShortestMotion;  // see moveSteadily()
  ball.path.boundAcceleration();
}

// --- what carries the ball from now on ---

void removeSupport(std::size_t i, BallRecord& ball, ConstrainedBall& constrained, Decision& decision)
{
  ball.supports.remove(i);
  ContactProblem& problem = decision.problem;
  for (std::size_t k = i; k + 1 < constrained.count; ++k)
  {
    constrained.surface[k] = constrained.surface[k + 1];
    problem.law[k] = problem.law[k + 1];
    problem.at[k] = problem.at[k + 1];
    problem.mode[k] = problem.mode[k + 1];
    decision.forces[k] = decision.forces[k + 1];
  }
  --constrained.count;
  --problem.count;
}

// Supports that carry nothing and part from the ball; those that do neither are still touched. A ball that comes back to a
// surface in the very instant in which it has left it touches it, too: friction turns at once, and what it does next counts.
void dropUnloaded(BallRecord& ball, ConstrainedBall& constrained, Decision& decision, const BallMotion& motion,
                  double t)
{
  const bool again = t <= ball.path.start;
  const double slack = (ball.quick_contacts > kManyQuick ? kMostTouched : kTouchedFraction) * scaleOf(decision.problem);
  for (std::size_t i = constrained.count; i-- > 0;)
  {
    if (decision.problem.mode[i].loaded) continue;
    const SupportPoint& at = decision.problem.at[i];
    const bool parts = at.rate > noSpeed(motion) || (!again && at.n.dot(decision.motion.a) > at.least + slack);
    if (parts) removeSupport(i, ball, constrained, decision);
  }
}

Vector3d cleaned(const Vector3d& a, double scale)
{
  return a.norm() < kRoundedFraction * scale ? Vector3d(Vector3d::Zero()) : a;
}

// What ends straight on planes has a closed form, else what can be stopped within the grip time is. Where Coulomb's law has no
// answer, friction has jammed the ball: all slip ends at once.
Decision decideOrJam(const ConstrainedBall& constrained, BallMotion& motion, double t, double grip_time)
{
  Decision decision = decide(constrained, motion, t, 0.0);
  if (const Grips grips = allThatAlwaysGrips(decision, motion); any(grips))
  {
    gripAtOnce(constrained, grips, nullptr, t, motion);
    decision = decide(constrained, motion, t, 0.0);
  }
  if (decision.answered && steady(constrained, decision, motion)) return decision;
  if (movesSlowly(decision.problem, motion, grip_time))
  {
    const Decision stopping = decide(constrained, motion, t, grip_time);
    gripAtOnce(constrained, stopping.stops, &stopping.problem, t, motion);
    if (any(stopping.stops)) decision = decide(constrained, motion, t, 0.0);
  }
  if (decision.answered) return decision;
  gripAtOnce(constrained, allThatIsRough(constrained), nullptr, t, motion);
  decision = decide(constrained, motion, t, 0.0);
  if (!decision.answered) decision.motion = BallAcceleration();
  return decision;
}

// A step that is far too long for the forces ends nowhere: the ball then keeps its velocity, and the status tells of
// it.
void flyStep(BallRecord& ball, const BallState& state, double t, double h)
{
  ball.path = flyRk4(state, t, ball.model(), h);
  ball.overflows = !ball.path.position(h).allFinite() || !ball.path.velocity(h).allFinite();
  if (!ball.overflows) return;
  ball.path = flyParabola(state, t, Vector3d::Zero());
  ball.path.end = t + h;
}

void planFlight(const WorldState& world, BallRecord& ball, const BallState& state, double t)
{
  if (world.flies_in_steps) return flyStep(ball, state, t, world.scene.dt);
  // A piece that a contact has cut was long enough: a longer one might have to be tried twice.
  Segment& path = ball.path;
  if (path.degree > 2 && t < path.end)
    path.higher->next_piece = std::min(path.higher->next_piece, path.end - path.start);
  fly(state, t, ball.model(), world.scene.tolerance, path);
}

// The path of a ball that lay on surfaces; it may leave some of them now, or all.
void planConstrainedPath(const WorldState& world, BallRecord& ball, BallState state, double t, double window_end)
{
  const bool ended_soon = t >= ball.path.end && t - ball.path.start < kShortPath;
  const double next_piece = ball.path.higher && ball.path.higher->spin ? ball.path.higher->spin->next_piece : 0.0;
  passToFlushFaces(world, ball, state, t);
  dropSurfacesLeft(world, ball, state, t);
  if (ball.supports.none()) return planFlight(world, ball, state, t);
  ball.supports.countShort(ended_soon);
  const double grip_time = gripTime(world, ball.supports);
  ConstrainedBall constrained = constrainedBall(world, ball, state.p_WB, t);
  BallMotion motion = motionOf(state, constrained.radius);
  const Vector3d spin_before = motion.s;
  Decision decision = decideOrJam(constrained, motion, t, grip_time);
  state.v_WB = motion.v;
  if (motion.s != spin_before) state.w_WB = motion.s / constrained.radius;
  dropUnloaded(ball, constrained, decision, motion, t);
  if (ball.supports.none()) return planFlight(world, ball, state, t);
  if (motion.s.norm() < kStillSpeed && motion.v.norm() < kStillSpeed) state.w_WB.setZero();
  const double scale = scaleOf(decision.problem);
  decision.motion.a = cleaned(decision.motion.a, scale);
  decision.motion.b = cleaned(decision.motion.b, scale);
  ball.path = flyParabola(state, t, Vector3d::Zero());
  if (steady(constrained, decision, motion))
    moveSteadily(world, ball, constrained, decision, motion, t, window_end);
  else
    moveOnPiece(world, ball, constrained, decision, motion, t, window_end, next_piece);
}
}  // namespace

double timeOfRemainingBounces(double rate, double press, double restitution)
{
  return restitution < 1.0 ? 2.0 * rate / (press * (1.0 - restitution)) : 0.0;
}

Vector3d accelerationOnSupports(const WorldState& world, const BallRecord& ball, const BallState& state, double t)
{
  if (ball.supports.none()) return ball.model().acceleration(state.v_WB, state.w_WB);
  ConstrainedBall constrained = constrainedBall(world, ball, state.p_WB, t);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < constrained.count; ++i)
    if (touches(gapOver(world, ball, ball.supports[i], state, t), keepSpeed(ball)))
      constrained.surface[kept++] = constrained.surface[i];
  constrained.count = kept;
  return decide(constrained, motionOf(state, constrained.radius), t, 0.0).motion.a;
}

void addTouched(const WorldState& world, BallRecord& ball, const BallState& state, double t)
{
  std::optional<Vector3d> a;  // before anything is added
  for (std::size_t b = 0; b < world.bodies.size(); ++b)
  {
    const BodyRecord& body = world.bodies[b];
    for (std::size_t s = 0; s < body.shapes().size(); ++s)
    {
      const Gap gap = gapOver(body, body.shapes()[s], state, ball.params().radius, t);
      if (std::abs(gap.gap) > kTouchedGap || std::abs(gap.rate) > kNoSeparationSpeed) continue;
      if (supportedAlong(world, ball, state, gap.n_W, t)) continue;
      if (!a) a = accelerationOnSupports(world, ball, state, t);
      if (gapAcceleration(body.shapes()[s], body.at(t), state.p_WB, state.v_WB, *a) < 0.0) ball.supports.add(b, s);
    }
  }
}

void planPath(const WorldState& world, BallRecord& ball, const BallState& state, double t, double window_end)
{
  ++ball.version;
  if (ball.supports.none())
    planFlight(world, ball, state, t);
  else
    planConstrainedPath(world, ball, state, t, window_end);
}
}  // namespace ping_pong
