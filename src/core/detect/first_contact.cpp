#include "detect/first_contact.h"

#include <algorithm>
#include <cmath>

#include "base/law_counter.h"
#include "detect/ball_ball.h"
#include "detect/conservative_advancement.h"
#include "geometry/feature.h"

namespace ping_pong
{
namespace
{
// A ball that is still on the face when it should have left it, by rounding, looks again after this time.
constexpr double kLeast = 1e-9;  // [s]

// Bound of the ball's acceleration in the body's turning frame: a_rel + w' x d + w x (w x d) + 2 w x v_rel.
double relativeAccelerationBound(const Segment& path, const BodyMotion& motion, double from, double until)
{
  const double s0 = from - path.start;
  const double T = until - from;
  const double a = path.accelerationBound() + motion.a_WB.norm();
  if (!motion.turning()) return a;
  const double s = from - motion.start;
  const Pose pose = motion.poseAt(s);
  const double v = (path.velocity(s0) - motion.twist.v - s * motion.a_WB).norm() + a * T;
  const double d = (path.position(s0) - pose.p).norm() + v * T;
  const double end = until - motion.start;
  const double w = motion.twist.w.norm() + end * motion.alpha_WB.norm();
  const double alpha = motion.alpha_WB.norm() * (1.0 + w * end);
  return a + alpha * d + w * w * d + 2.0 * w * v;
}

// Cannot come near within the time: speed bound times time is less than the distance of the bounding spheres.
bool outOfReach(const Segment& path, double radius, const Shape& shape, const BodyMotion& motion, double from,
                double until)
{
  const double size = boundingRadius(shape);
  if (!(size < kNever) || !(until < kNever)) return false;
  const double s = from - motion.start;
  const double T = until - from;
  const Pose X_WB = motion.poseAt(s);
  const double distance = (path.position(from - path.start) - X_WB.p - X_WB.q * shape.p_BS).norm() - radius - size;
  const double surface = motion.twist.v.norm() + (s + T) * motion.a_WB.norm() +
                         shape.p_BS.norm() * (motion.twist.w.norm() + (s + T) * motion.alpha_WB.norm());
  const double speed = path.speedBound(from - path.start, until - path.start) + surface;
  return distance > speed * T;
}

struct FaceFrame
{
  Vector3d y, u, a;  // position, velocity, acceleration of the ball in the shape's frame
};

FaceFrame inFace(const Segment& path, const Shape& shape, const BodyMotion& motion, double t)
{
  const BodyFrame frame = frameAt(motion, t - motion.start);
  const double s = t - path.start;
  const Matrix3d R = (frame.R_WB * shape.R_BS).transpose();
  return {shape.R_BS.transpose() * (frame.R_WB.transpose() * (path.position(s) - frame.p_WB) - shape.p_BS),
          R * (path.velocity(s) - frame.v_WB), R * (path.acceleration(s) - frame.a_WB)};
}

// First d > 0 at which y + u d + a d^2/2 passes `limit` > y outwards.
double passes(double y, double u, double a, double limit)
{
  const double gap = limit - y;
  if (gap <= 0.0) return u > 0.0 || (u == 0.0 && a > 0.0) ? 0.0 : kNever;
  // -(a/2) d^2 - u d + gap = 0, smallest positive root.
  const double discriminant = u * u + 2.0 * a * gap;
  if (discriminant < 0.0) return kNever;
  const double root = std::sqrt(discriminant);
  if (u + root > 0.0) return 2.0 * gap / (u + root);
  return kNever;
}

double leavesBoxFace(const FaceFrame& ball, const Vector3d& half)
{
  int face = 0;
  (ball.y.cwiseAbs() - half).maxCoeff(&face);
  double first = kNever;
  for (int i = 0; i < 3; ++i)
  {
    if (i == face) continue;
    const double limit = half[i] + kBorder;
    first = std::min(
        {first, passes(ball.y[i], ball.u[i], ball.a[i], limit), passes(-ball.y[i], -ball.u[i], -ball.a[i], limit)});
  }
  return std::max(first, kLeast);
}

// No earlier than the time to cover the distance to the rim at the bounded speed; the caller looks again then.
double leavesCap(const FaceFrame& ball, double radius)
{
  const double gap = radius + kBorder - std::hypot(ball.y.x(), ball.y.y());
  if (gap <= 0.0) return 0.0;
  const double u = ball.u.norm();
  const double a = ball.a.norm();
  if (u == 0.0 && a == 0.0) return kNever;
  return std::max(2.0 * gap / (u + std::sqrt(u * u + 2.0 * a * gap)), kLeast);
}
}  // namespace

Gap gapTo(const Shape& shape, const BodyFrame& frame, const Vector3d& p_WB, const Vector3d& v_WB, double radius)
{
  const Vector3d d = p_WB - frame.p_WB;
  const Proximity near = proximity(shape, frame.R_WB.transpose() * d);
  Gap gap;
  gap.gap = near.distance - radius;
  gap.n_W = frame.R_WB * near.normal;
  gap.rate = gap.n_W.dot(v_WB - frame.v_WB - frame.w_WB.cross(d));
  return gap;
}

Gap gapTo(const Shape& placed, const Vector3d& p_WB, const Vector3d& v_WB, double radius)
{
  const Proximity near = proximity(placed, p_WB);
  return {near.distance - radius, near.normal.dot(v_WB), near.normal};
}

double gapAcceleration(const Shape& shape, const BodyFrame& frame, const Vector3d& p_WB, const Vector3d& v_WB,
                       const Vector3d& a_WB)
{
  const Vector3d d = p_WB - frame.p_WB;
  const Vector3d& w = frame.w_WB;
  const Proximity near = proximity(shape, frame.R_WB.transpose() * d);
  const Vector3d n = frame.R_WB * near.normal;
  const Vector3d t1 = frame.R_WB * near.t1;
  const Vector3d u = v_WB - frame.v_WB - w.cross(d);
  const Vector3d a = a_WB - frame.a_WB - frame.alpha_WB.cross(d) - w.cross(w.cross(d)) - 2.0 * w.cross(u);
  const double u1 = u.dot(t1);
  const double u2 = u.dot(n.cross(t1));
  return n.dot(a) + near.k1 * u1 * u1 + near.k2 * u2 * u2;
}

Detection firstContact(const Segment& path, double radius, const Shape& shape, const BodyMotion& motion, double from,
                       double until)
{
  if (motion.still()) return firstContact(path, radius, placed(shape, motion.pose), from, until);
  count(meetingLaw(shape.kind));
  count(Law::MeetMoving);
  until = std::min(until, path.end);
  if (from > until || outOfReach(path, radius, shape, motion, from, until)) return {};
  const auto frame = [&](double t) { return frameAt(motion, t - motion.start); };
  // A body that does not turn stays behind its tangent plane: the gap changes at least as the distance from that plane.
  const bool turning = motion.turning();
  const Vector3d a_low = path.aLow() - motion.a_WB;
  const Vector3d a_high = path.aHigh() - motion.a_WB;
  const double bound = turning ? relativeAccelerationBound(path, motion, from, until) : 0.0;
  const auto at = [&](double t)
  {
    const double s = t - path.start;
    const Gap gap = gapTo(shape, frame(t), path.position(s), path.velocity(s), radius);
    return GapSample{gap.gap, gap.rate, turning ? -bound : leastAlong(gap.n_W, a_low, a_high)};
  };
  const auto presses = [&](double t)
  {
    const double s = t - path.start;
    return gapAcceleration(shape, frame(t), path.position(s), path.velocity(s), path.acceleration(s)) < 0.0;
  };
  return advanceConservatively(at, presses, from, until, touchTolerance(path.position(from - path.start), radius));
}

Detection firstContact(const Segment& path1, double radius1, const Segment& path2, double radius2, double from,
                       double until)
{
  count(Law::PairSearch);
  until = std::min({until, path1.end, path2.end});
  if (from > until) return {};
  const double reach = radius1 + radius2;
  if (isParabola(path1) && isParabola(path2) && path1.c[2] == path2.c[2])
    return firstContact(asParabola(path1), asParabola(path2), reach, from, until);
  const double tolerance = touchTolerance(path1.position(from - path1.start), reach);
  const Vector3d a_low = path1.aLow() - path2.aHigh();
  const Vector3d a_high = path1.aHigh() - path2.aLow();
  const auto at = [&](double t)
  {
    const Vector3d d = path1.position(t - path1.start) - path2.position(t - path2.start);
    const Vector3d u = path1.velocity(t - path1.start) - path2.velocity(t - path2.start);
    const double distance = d.norm();
    return GapSample{distance - reach, d.dot(u) / distance, leastAlong(d / distance, a_low, a_high)};
  };
  const auto presses = [&](double t)
  {
    const Vector3d d = path1.position(t - path1.start) - path2.position(t - path2.start);
    const Vector3d u = path1.velocity(t - path1.start) - path2.velocity(t - path2.start);
    const Vector3d pull = path1.acceleration(t - path1.start) - path2.acceleration(t - path2.start);
    return d.dot(pull) + u.squaredNorm() < 0.0;
  };
  return advanceConservatively(at, presses, from, until, tolerance);
}

double leavesFace(const Segment& path, const Shape& shape, const BodyMotion& motion, double from, double until)
{
  double after = kNever;
  switch (shape.kind)
  {
    case ShapeKind::Box:
      after = leavesBoxFace(inFace(path, shape, motion, from), shape.half_size);
      break;
    case ShapeKind::Cylinder:
      after = leavesCap(inFace(path, shape, motion, from), shape.half_size.x());
      break;
    case ShapeKind::Sphere:
    case ShapeKind::HalfSpace:
      break;  // without a border
  }
  return from + after <= until ? from + after : kNever;
}
}  // namespace ping_pong
