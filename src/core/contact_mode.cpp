#include "contact_mode.h"

#include <cmath>

namespace ping_pong
{
namespace
{
constexpr double kLift = 1e-12;          // height of bounces that no longer count [m]
constexpr double kNoHopSpeed = 1e-9;     // hops below 1e-19 m under gravity, even where e = 1 [m/s]
constexpr double kKeepSpeed = 1e-6;      // a support is left by moving away faster than this [m/s]
constexpr double kKeepGap = 1e-6;        // or from further than this [m]
constexpr double kStillSpeed = 1e-12;    // below: rounding, the ball lies still [m/s]
constexpr double kStillFraction = 1e-12; // tangential acceleration below this part of the free one is rounding
constexpr double kPiece = 2.5e-4;        // longest quintic piece on a curved or turning surface [s]

struct Place
{
  const Shape& shape;
  BodyFrame frame;
};

Place placeOf(const WorldState& world, const Supports::Surface& surface, double t)
{
  const BodyRecord& body = world.bodies[surface.body];
  return {body.shapes()[surface.shape], frameAt(body.frame(), t - body.frame().start)};
}

// The ball is put on the surface and moves along it; false if it is off the surface or moves away or into it.
bool projectOn(const Place& place, double radius, BallState& ball)
{
  const Gap gap = gapTo(place.shape, place.frame, ball.p_WB, ball.v_WB, radius);
  if (std::abs(gap.gap) > kKeepGap || std::abs(gap.rate) > kKeepSpeed) return false;
  ball.p_WB -= gap.gap * gap.n_W;
  ball.v_WB -= gap.rate * gap.n_W;
  return true;
}

void dropSurfacesLeft(const WorldState& world, BallRecord& ball, BallState& state, double t)
{
  for (std::size_t i = ball.supports.count; i-- > 0;)
    if (!projectOn(placeOf(world, ball.supports.list[i], t), ball.params.radius, state)) ball.supports.remove(i);
}

bool allFlatAndNotTurning(const WorldState& world, const Supports& supports, const BallState& ball, double t)
{
  for (std::size_t i = 0; i < supports.count; ++i)
  {
    const Place place = placeOf(world, supports.list[i], t);
    if (world.bodies[supports.list[i].body].frame().turning()) return false;
    const Vector3d p_BQ = place.frame.R_WB.transpose() * (ball.p_WB - place.frame.p_WB);
    if (!proximity(place.shape, p_BQ).flat()) return false;
  }
  return true;
}

bool onMovingBody(const WorldState& world, const Supports& supports)
{
  for (std::size_t i = 0; i < supports.count; ++i)
    if (world.bodies[supports.list[i].body].moving) return true;
  return false;
}

double leavesFirstFace(const WorldState& world, const Supports& supports, const Segment& path, double t)
{
  double first = kNever;
  for (std::size_t i = 0; i < supports.count; ++i)
  {
    const BodyRecord& body = world.bodies[supports.list[i].body];
    first = std::min(first, leavesFace(path, body.shapes()[supports.list[i].shape], body.frame(), t, kNever));
  }
  return first;
}

void slideOnFaces(const WorldState& world, const Supports& supports, const BallState& state, const Vector3d& a, double t,
                  double window_end, Segment& path)
{
  const bool still = state.v_WB.norm() < kStillSpeed && a.isZero(0.0);
  path.degree = still ? 0 : 2;
  path.c[1] = still ? Vector3d(Vector3d::Zero()) : state.v_WB;
  path.c[2] = 0.5 * a;
  path.end = leavesFirstFace(world, supports, path, t);
  // On a moving body the caller plans anew at the next window; the path only has to reach it.
  if (onMovingBody(world, supports) && path.end > window_end) path.end = kNever;
}

Vector3d cleaned(const Vector3d& a, const Vector3d& free)
{
  return a.norm() < kStillFraction * free.norm() ? Vector3d(Vector3d::Zero()) : a;
}

struct Derivative
{
  Vector3d v, a;
};

// Classic Runge-Kutta step of the held motion.
BallState heldStep(const WorldState& world, const Supports& supports, const BallState& start, double t, double h)
{
  AccelerationBounds bounds;
  const auto slope = [&](const Derivative& before, double part) {
    BallState at = start;
    at.p_WB += part * h * before.v;
    at.v_WB += part * h * before.a;
    return Derivative{at.v_WB, heldAcceleration(world, supports, at, t + part * h, bounds)};
  };
  const Derivative k1 = slope({Vector3d::Zero(), Vector3d::Zero()}, 0.0);
  const Derivative k2 = slope(k1, 0.5);
  const Derivative k3 = slope(k2, 0.5);
  const Derivative k4 = slope(k3, 1.0);
  BallState end = start;
  end.p_WB += h / 6.0 * (k1.v + 2.0 * k2.v + 2.0 * k3.v + k4.v);
  end.v_WB += h / 6.0 * (k1.a + 2.0 * k2.a + 2.0 * k3.a + k4.a);
  return end;
}

// Quintic with position, velocity and acceleration of both ends.
void hermite(const BallState& from, const Vector3d& a0, const BallState& to, const Vector3d& a1, double h, Segment& path)
{
  const Vector3d p = to.p_WB - from.p_WB - h * from.v_WB - 0.5 * h * h * a0;
  const Vector3d v = h * (to.v_WB - from.v_WB - h * a0);
  const Vector3d a = h * h * (a1 - a0);
  path.degree = 5;
  path.c[1] = from.v_WB;
  path.c[2] = 0.5 * a0;
  path.c[3] = (10.0 * p - 4.0 * v + 0.5 * a) / (h * h * h);
  path.c[4] = (-15.0 * p + 7.0 * v - a) / (h * h * h * h);
  path.c[5] = (6.0 * p - 3.0 * v + 0.5 * a) / (h * h * h * h * h);
}

void slideOnCurve(const WorldState& world, const BallRecord& ball, const BallState& state, const Vector3d& a, double t,
                  double window_end, Segment& path)
{
  const double h = onMovingBody(world, ball.supports) && window_end > t ? std::min(kPiece, window_end - t) : kPiece;
  BallState end = heldStep(world, ball.supports, state, t, h);
  for (std::size_t i = 0; i < ball.supports.count; ++i)
    projectOn(placeOf(world, ball.supports.list[i], t + h), ball.params.radius, end);
  AccelerationBounds bounds;
  hermite(state, a, end, heldAcceleration(world, ball.supports, end, t + h, bounds), h, path);
  path.end = t + h;
}
}  // namespace

bool bouncingEnds(double rate, double press, double restitution)
{
  if (press <= 0.0) return false;
  if (rate <= kNoHopSpeed) return true;
  return restitution < 1.0 && rate * rate < 2.0 * press * kLift;
}

double timeOfRemainingBounces(double rate, double press, double restitution)
{
  return restitution < 1.0 ? 2.0 * rate / (press * (1.0 - restitution)) : 0.0;
}

Vector3d heldAcceleration(const WorldState& world, const Supports& supports, const BallState& ball, double t,
                          AccelerationBounds& bounds)
{
  bounds.count = supports.count;
  for (std::size_t i = 0; i < supports.count; ++i)
  {
    const Place place = placeOf(world, supports.list[i], t);
    const Vector3d d = ball.p_WB - place.frame.p_WB;
    bounds.list[i].n = place.frame.R_WB * proximity(place.shape, place.frame.R_WB.transpose() * d).normal;
    bounds.list[i].b = -gapAcceleration(place.shape, place.frame, ball.p_WB, ball.v_WB, Vector3d::Zero());
  }
  return constrainedAcceleration(freeAcceleration(world.scene.forces), bounds);
}

void planPath(const WorldState& world, BallRecord& ball, BallState state, double t, double window_end)
{
  ++ball.version;
  Vector3d a = Vector3d::Zero();
  if (!ball.supports.none())
  {
    dropSurfacesLeft(world, ball, state, t);
    AccelerationBounds bounds;
    a = heldAcceleration(world, ball.supports, state, t, bounds);
    for (std::size_t i = ball.supports.count; i-- > 0;)
      if (!bounds.loaded[i]) ball.supports.remove(i);
  }
  ball.path = fly(state, t, world.scene.forces);
  if (ball.supports.none()) return;
  if (allFlatAndNotTurning(world, ball.supports, state, t))
    slideOnFaces(world, ball.supports, state, cleaned(a, freeAcceleration(world.scene.forces)), t, window_end, ball.path);
  else
    slideOnCurve(world, ball, state, a, t, window_end, ball.path);
}
}  // namespace ping_pong
