#include "held_motion.h"

#include <cmath>

#include "count.h"

namespace ping_pong
{
namespace
{
// Slip below this is none [m/s].
constexpr double kNoSlip = 1e-12;
// On several rough surfaces at once friction grows with the slip up to this, and is full beyond [m/s].
constexpr double kSoftSlip = 1e-3;
constexpr double kStep = 2.5e-4;  // longest step on several rough surfaces [s]

Vector3d tangential(const Vector3d& x, const Vector3d& n)
{
  return x - n.dot(x) * n;
}

Vector3d normalOf(const Place& place, const Vector3d& p_WB)
{
  return place.frame.R_WB * proximity(place.shape, place.frame.R_WB.transpose() * (p_WB - place.frame.p_WB)).normal;
}

Vector3d limited(const Vector3d& f, double most)
{
  const double norm = f.norm();
  return norm > most ? Vector3d(most / norm * f) : f;
}

// Acceleration of the material point of the surface at the contact.
Vector3d pointAcceleration(const BodyFrame& frame, const Vector3d& p_WC)
{
  const Vector3d d = p_WC - frame.p_WB;
  return frame.a_WB + frame.alpha_WB.cross(d) + frame.w_WB.cross(frame.w_WB.cross(d));
}

// A force per mass f at the touching point also turns the ball.
void push(HeldMotion& motion, const BallParams& ball, const Vector3d& n, const Vector3d& f)
{
  motion.a += f;
  motion.alpha -= n.cross(f) / (ball.inertia * ball.radius);
}

void resistRolling(HeldMotion& motion, const Place& place, const BallParams& ball, const BallState& state,
                   const Vector3d& n, double load)
{
  count(Law::RollingResistance);
  const Vector3d v = tangential(state.v_WB - place.frame.pointVelocity(state.p_WB - ball.radius * n), n);
  const double speed = v.norm();
  if (speed <= kNoSlip) return;
  const Vector3d a = -place.law.rolling_resistance * load / speed * v;
  motion.a += a;
  motion.alpha += n.cross(a) / ball.radius;  // rolling stays rolling
  motion.until_grip = std::min(motion.until_grip, speed / a.norm());
}

// About the normal.
void resistSpin(HeldMotion& motion, const Place& place, const BallParams& ball, const BallState& state,
                const Vector3d& n, double load)
{
  count(Law::SpinFriction);
  const double spin = n.dot(state.w_WB);
  if (std::abs(spin) <= kNoSlip) return;
  const double rate = place.law.spin_friction * load / (ball.inertia * ball.radius);
  motion.alpha -= std::copysign(rate, spin) * n;
  motion.until_grip = std::min(motion.until_grip, std::abs(spin) / rate);
}

// Both end at zero speed, which `until_grip` tells.
void resist(HeldMotion& motion, const Place& place, const BallParams& ball, const BallState& state, const Vector3d& n,
            double load)
{
  if (place.law.rolling_resistance > 0.0) resistRolling(motion, place, ball, state, n, load);
  if (place.law.spin_friction > 0.0) resistSpin(motion, place, ball, state, n, load);
}

void rubOnOne(HeldMotion& motion, const Place& place, const BallParams& ball, const BallState& state, double load,
              double grip_time)
{
  count(Law::Friction);
  const Vector3d n = normalOf(place, state.p_WB);
  const Vector3d slip = slipOver(place, ball, state);
  const double speed = slip.norm();
  const double give = 1.0 + 1.0 / ball.inertia;  // slip changes by this times the friction
  const Vector3d p_WC = state.p_WB - ball.radius * n;
  const Vector3d drift = tangential(motion.a - pointAcceleration(place.frame, p_WC), n);
  const double most = place.law.friction * load;
  const bool slides = speed > kNoSlip && speed > most * give * grip_time;
  const Vector3d stop = grip_time > 0.0 ? Vector3d(slip / grip_time) : Vector3d(Vector3d::Zero());
  const Vector3d f = slides ? Vector3d(-most / speed * slip) : limited(-(drift + stop) / give, most);
  push(motion, ball, n, f);
  if (slides)
  {
    const double loss = -slip.dot(drift + give * f) / speed;  // of slip per time
    if (loss > 0.0) motion.until_grip = speed / loss;
  }
  else
    resist(motion, place, ball, state, n, load);
}
}  // namespace

Place placeOf(const WorldState& world, const BallRecord& ball, std::size_t support, double t)
{
  const Supports::Surface& surface = ball.supports[support];
  const BodyRecord& body = world.bodies[surface.body];
  const Shape& shape = body.shapes()[surface.shape];
  return {shape, world.surface(ball, shape), frameAt(body.frame(), t - body.frame().start)};
}

Vector3d slipOver(const Place& place, const BallParams& ball, const BallState& state)
{
  count(Law::Slip);
  const Vector3d n = normalOf(place, state.p_WB);
  const Vector3d u = place.frame.pointVelocity(state.p_WB - ball.radius * n);
  return tangential(state.v_WB - u, n) - ball.radius * state.w_WB.cross(n);
}

Vector3d smoothAcceleration(const WorldState& world, const BallRecord& ball, const BallState& state, double t,
                            AccelerationBounds& bounds)
{
  bounds.count = ball.supports.count();
  for (std::size_t i = 0; i < ball.supports.count(); ++i)
  {
    const Place place = placeOf(world, ball, i, t);
    bounds.list[i].n = normalOf(place, state.p_WB);
    bounds.list[i].b = -gapAcceleration(place.shape, place.frame, state.p_WB, state.v_WB, Vector3d::Zero());
  }
  return constrainedAcceleration(ball.model().acceleration(state.v_WB, state.w_WB), bounds);
}

HeldMotion heldMotion(const WorldState& world, const BallRecord& ball, const BallState& state, double t,
                      double grip_time, AccelerationBounds& bounds)
{
  HeldMotion motion;
  motion.a = smoothAcceleration(world, ball, state, t, bounds);
  std::size_t loaded = 0;
  bool rough = false;
  for (std::size_t i = 0; i < bounds.count; ++i)
  {
    if (bounds.load[i] <= 0.0) continue;
    ++loaded;
    rough |= placeOf(world, ball, i, t).law.friction > 0.0;
  }
  if (!rough) return motion;
  Vector3d rubbed = Vector3d::Zero();
  if (loaded > 1) rubbed = ball.model().acceleration(state.v_WB, state.w_WB);
  // Friction must not turn the slip round within a step of the integration.
  const double fastest = 0.5 / ((1.0 + 1.0 / ball.params().inertia) * (grip_time > 0.0 ? grip_time : kStep));
  for (std::size_t i = 0; i < bounds.count; ++i)
  {
    if (bounds.load[i] <= 0.0) continue;
    const Place place = placeOf(world, ball, i, t);
    if (loaded == 1)
    {
      rubOnOne(motion, place, ball.params(), state, bounds.load[i], grip_time);
      return motion;
    }
    if (!(place.law.friction > 0.0)) continue;
    count(Law::Friction);
    const Vector3d slip = slipOver(place, ball.params(), state);
    const double rate = place.law.friction * bounds.load[i] / std::max(slip.norm(), kSoftSlip);
    const Vector3d f = -std::min(rate, fastest) * slip;
    rubbed += f;
    push(motion, ball.params(), bounds.list[i].n, f);
  }
  motion.a = constrainedAcceleration(rubbed, bounds);  // friction on one surface presses on the others
  return motion;
}
}  // namespace ping_pong
