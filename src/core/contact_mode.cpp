#include "contact_mode.h"

#include <cmath>

#include "held_motion.h"
#include "fixed_flight.h"

namespace ping_pong
{
namespace
{
constexpr double kLift = 1e-12;             // height of bounces that no longer count [m]
constexpr double kLiftInTolerances = 32.0;  // or this many touch tolerances, far from the origin
constexpr double kKeepGap = 1e-6;           // a support is left from further than this [m]
constexpr double kStillSpeed = 1e-12;       // below: rounding, the ball lies still [m/s]
constexpr double kStillFraction = 1e-12;    // tangential acceleration below this part of the free one is rounding
constexpr double kPiece = 2.5e-4;           // longest quintic piece on a curved or turning surface [s]
constexpr double kFlatPiece = 2e-3;         // and on one flat face, where only air and turning slip bend the path [s]
constexpr int kProjections = 8;
constexpr double kShortestPiece = 1e-9;  // [s]

// The ball is put on the surface and moves along it; false if it is off the surface or moves away or into it.
bool projectOn(const Place& place, double radius, BallState& ball)
{
  const Gap gap = gapTo(place.shape, place.frame, ball.p_WB, ball.v_WB, radius);
  if (std::abs(gap.gap) > kKeepGap || std::abs(gap.rate) > kKeepSpeed) return false;
  ball.p_WB -= gap.gap * gap.n_W;
  ball.v_WB -= gap.rate * gap.n_W;
  return true;
}

// Projecting on one surface shifts the ball on the others: a few rounds bring it onto all.
void settleOnAll(const WorldState& world, const BallRecord& ball, BallState& state, double t)
{
  if (ball.supports.count() < 2) return;
  for (int round = 0; round < kProjections; ++round)
    for (std::size_t i = 0; i < ball.supports.count(); ++i)
      projectOn(placeOf(world, ball, i, t), ball.params().radius, state);
}

void dropSurfacesLeft(const WorldState& world, BallRecord& ball, BallState& state, double t)
{
  for (std::size_t i = ball.supports.count(); i-- > 0;)
    if (!projectOn(placeOf(world, ball, i, t), ball.params().radius, state)) ball.supports.remove(i);
  settleOnAll(world, ball, state, t);
}

bool allFlatAndNotTurning(const WorldState& world, const BallRecord& ball, const BallState& state, double t)
{
  for (std::size_t i = 0; i < ball.supports.count(); ++i)
  {
    const Place place = placeOf(world, ball, i, t);
    if (world.bodies[ball.supports[i].body].frame().turning()) return false;
    const Vector3d p_BQ = place.frame.R_WB.transpose() * (state.p_WB - place.frame.p_WB);
    if (!proximity(place.shape, p_BQ).flat()) return false;
  }
  return true;
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

// Whether the acceleration stays what it is now for as long as the ball stays on its faces.
bool steady(const WorldState& world, const BallRecord& ball, const BallState& state, const HeldMotion& motion, double t)
{
  if (!allFlatAndNotTurning(world, ball, state, t)) return false;
  if (world.scene.forces.dependOnVelocity() && !(state.v_WB.isZero(0.0) && motion.a.isZero(0.0))) return false;
  bool rough = false;
  for (std::size_t i = 0; i < ball.supports.count(); ++i) rough |= placeOf(world, ball, i, t).law.friction > 0.0;
  if (!rough) return true;
  if (ball.supports.count() > 1) return motion.a.isZero(0.0) && motion.alpha.isZero(0.0);
  // Friction keeps its direction while the slip does: it changes along itself.
  const Place place = placeOf(world, ball, 0, t);
  const Vector3d slip = slipOver(place, ball.params(), state);
  const Vector3d n = gapTo(place.shape, place.frame, state.p_WB, state.v_WB, ball.params().radius).n_W;
  const Vector3d change = motion.a - place.frame.a_WB - ball.params().radius * motion.alpha.cross(n);
  return slip.cross(change - n.dot(change) * n).norm() <= 1e-12 * slip.norm() * (change.norm() + 1.0);
}

void moveOnFaces(const WorldState& world, const BallRecord& ball, const BallState& state, const HeldMotion& motion,
                 double t, double window_end, Segment& path)
{
  const bool still = state.v_WB.norm() < kStillSpeed && motion.a.isZero(0.0);
  path.degree = still ? 0 : 2;
  path.c[1] = still ? Vector3d(Vector3d::Zero()) : state.v_WB;
  path.c[2] = 0.5 * motion.a;
  if (!motion.alpha.isZero(0.0)) path.further.make().alpha_WB = motion.alpha;
  path.end = std::min(leavesFirstFace(world, ball.supports, path, t), t + motion.until_grip);
  // On a moving body the caller plans anew at the next window; the path only has to reach it.
  if (onMovingBody(world, ball.supports) && path.end > window_end) path.end = kNever;
}

Vector3d cleaned(const Vector3d& a, const Vector3d& free)
{
  return a.norm() < kStillFraction * free.norm() ? Vector3d(Vector3d::Zero()) : a;
}

// Classic Runge-Kutta step of the held motion.
BallState heldStep(const WorldState& world, const BallRecord& ball, const BallState& start, double t, double h)
{
  struct Slope
  {
    Vector3d v, a, alpha;
  };
  AccelerationBounds bounds;
  const auto slope = [&](const Slope& before, double part)
  {
    BallState at = start;
    at.p_WB += part * h * before.v;
    at.v_WB += part * h * before.a;
    at.w_WB += part * h * before.alpha;
    const HeldMotion motion = heldMotion(world, ball, at, t + part * h, h, bounds);
    return Slope{at.v_WB, motion.a, motion.alpha};
  };
  const Slope k1 = slope({Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()}, 0.0);
  const Slope k2 = slope(k1, 0.5);
  const Slope k3 = slope(k2, 0.5);
  const Slope k4 = slope(k3, 1.0);
  BallState end = start;
  end.p_WB += h / 6.0 * (k1.v + 2.0 * k2.v + 2.0 * k3.v + k4.v);
  end.v_WB += h / 6.0 * (k1.a + 2.0 * k2.a + 2.0 * k3.a + k4.a);
  end.w_WB += h / 6.0 * (k1.alpha + 2.0 * k2.alpha + 2.0 * k3.alpha + k4.alpha);
  return end;
}

// Quintic with position, velocity and acceleration of both ends.
void hermite(const BallState& from, const Vector3d& a0, const BallState& to, const Vector3d& a1, double h,
             Segment& path)
{
  const Vector3d p = to.p_WB - from.p_WB - h * from.v_WB - 0.5 * h * h * a0;
  const Vector3d v = h * (to.v_WB - from.v_WB - h * a0);
  const Vector3d a = h * h * (a1 - a0);
  path.degree = 5;
  path.c[1] = from.v_WB;
  path.c[2] = 0.5 * a0;
  FurtherTerms& further = path.further.make();
  further.c[0] = (10.0 * p - 4.0 * v + 0.5 * a) / (h * h * h);
  further.c[1] = (-15.0 * p + 7.0 * v - a) / (h * h * h * h);
  further.c[2] = (6.0 * p - 3.0 * v + 0.5 * a) / (h * h * h * h * h);
}

void moveOnPiece(const WorldState& world, const BallRecord& ball, const BallState& state, const HeldMotion& motion,
                 double t, double window_end, Segment& path)
{
  double h = ball.supports.count() == 1 && allFlatAndNotTurning(world, ball, state, t) ? kFlatPiece : kPiece;
  if (motion.until_grip > kShortestPiece) h = std::min(h, motion.until_grip);
  if (onMovingBody(world, ball.supports) && window_end > t) h = std::min(h, window_end - t);
  BallState end = heldStep(world, ball, state, t, h);
  for (std::size_t i = 0; i < ball.supports.count(); ++i)
    projectOn(placeOf(world, ball, i, t + h), ball.params().radius, end);
  settleOnAll(world, ball, end, t + h);
  AccelerationBounds bounds;
  hermite(state, motion.a, end, heldMotion(world, ball, end, t + h, h, bounds).a, h, path);
  path.further->alpha_WB = (end.w_WB - state.w_WB) / h;
  path.end = t + h;
  path.boundAcceleration();
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
  if (world.method == Method::Rk4Located) return flyStep(ball, state, t, world.scene.dt);
  // A piece that a contact has cut was long enough: a longer one might have to be tried twice.
  Segment& path = ball.path;
  if (path.degree > 2 && t < path.end) path.further->next_piece = std::min(path.further->next_piece, path.end - path.start);
  fly(state, t, ball.model(), world.scene.tolerance, path);
}

// The path of a ball that lay on surfaces; it may leave some of them now, or all.
void planHeldPath(const WorldState& world, BallRecord& ball, BallState state, double t, double window_end)
{
  dropSurfacesLeft(world, ball, state, t);
  AccelerationBounds bounds;
  HeldMotion motion = heldMotion(world, ball, state, t, 0.0, bounds);
  for (std::size_t i = ball.supports.count(); i-- > 0;)
    if (!bounds.loaded[i]) ball.supports.remove(i);
  if (ball.supports.none()) return planFlight(world, ball, state, t);
  const Vector3d free = ball.model().acceleration(state.v_WB, state.w_WB);
  motion.a = cleaned(motion.a, free);
  motion.alpha = cleaned(ball.params().radius * motion.alpha, free) / ball.params().radius;
  ball.path = flyParabola(state, t, Vector3d::Zero());
  if (steady(world, ball, state, motion, t))
    moveOnFaces(world, ball, state, motion, t, window_end, ball.path);
  else
    moveOnPiece(world, ball, state, motion, t, window_end, ball.path);
}
}  // namespace

double timeOfRemainingBounces(double rate, double press, double restitution)
{
  return restitution < 1.0 ? 2.0 * rate / (press * (1.0 - restitution)) : 0.0;
}

void planPath(const WorldState& world, BallRecord& ball, const BallState& state, double t, double window_end)
{
  ++ball.version;
  ball.supports.passNone();
  if (ball.supports.none())
    planFlight(world, ball, state, t);
  else
    planHeldPath(world, ball, state, t, window_end);
}
}  // namespace ping_pong
