#include "paddle/paddle_drive.h"

#include <algorithm>
#include <cmath>

namespace ping_pong
{
namespace
{
constexpr double kArrived = 1e-12;  // rounding of positions [m, rad] and velocities [m/s, rad/s] near 1

Vector3d clamped(const Vector3d& x, double length)
{
  const double norm = x.norm();
  return norm > length ? Vector3d(length / norm * x) : x;
}

// Velocity at the end of the motion, after h, that brings `wanted` nearer within the limits.
Vector3d reachable(const Vector3d& now, const Vector3d& wanted, double speed, double acceleration, double h)
{
  return now + clamped(clamped(wanted, speed) - now, acceleration * h);
}

// Speed at the end of this motion from which a drive with this acceleration still stops within the distance, braking in
// whole motions of the same length: v^2/(2 a) + v h = distance.
double stoppingSpeed(double distance, double acceleration, double h)
{
  return 2.0 * distance / (h + std::sqrt(h * h + 2.0 * distance / acceleration));
}

// Velocity towards a target `offset` away that itself moves with `target`; `now` is the present velocity.
Vector3d approach(const Vector3d& offset, const Vector3d& target, const Vector3d& now, double acceleration, double h)
{
  const Vector3d ahead = offset - 0.5 * h * (now - target);  // what the present speed covers in h
  const double distance = ahead.norm();
  if (distance < kArrived) return target;
  return target + stoppingSpeed(distance, acceleration, h) / distance * ahead;
}

Vector3d rotationVector(const Quaterniond& q)
{
  const Eigen::AngleAxisd turn(q.w() < 0.0 ? Quaterniond(-q.coeffs()) : q);
  return turn.angle() * turn.axis();
}

struct WantedTwist
{
  Vector3d v, w;  // at the end of the motion
};

WantedTwist wantedTwist(const PaddleCommand& command, const DriveLimits& limits, const Pose& pose, const Twist& now,
                        double h)
{
  switch (command.mode)
  {
    case PaddleCommand::Mode::Acceleration:
      return {now.v + h * clamped(command.a_W, limits.acceleration),
              now.w + h * clamped(command.alpha_W, limits.angular_acceleration)};
    case PaddleCommand::Mode::Velocity:
      return {command.twist.v, command.twist.w};
    case PaddleCommand::Mode::Pose:
      return {approach(command.pose.p - pose.p, command.twist.v, now.v, limits.acceleration, h),
              approach(rotationVector(command.pose.q * pose.q.conjugate()), command.twist.w, now.w,
                       limits.angular_acceleration, h)};
    case PaddleCommand::Mode::Hold:
      break;
  }
  return {Vector3d::Zero(), Vector3d::Zero()};
}
// Constant acceleration from one velocity to the next; what is as good as there is there, so that a paddle stands still.
void ramp(Vector3d& now, Vector3d& acceleration, const Vector3d& next, double h)
{
  if ((next - now).norm() <= kArrived * (1.0 + next.norm()))
    now = next;
  else
    acceleration = (next - now) / h;
}
}  // namespace

BodyMotion followCommand(const PaddleCommand& command, const DriveLimits& limits, const BodyMotion& from, double start,
                         double h)
{
  BodyMotion motion;
  motion.start = start;
  motion.pose = from.poseAt(start - from.start);
  motion.twist = from.twistAt(start - from.start);
  const WantedTwist wanted = wantedTwist(command, limits, motion.pose, motion.twist, h);
  const Vector3d v = reachable(motion.twist.v, wanted.v, limits.speed, limits.acceleration, h);
  const Vector3d w = reachable(motion.twist.w, wanted.w, limits.angular_speed, limits.angular_acceleration, h);
  ramp(motion.twist.v, motion.a_WB, v, h);
  ramp(motion.twist.w, motion.alpha_WB, w, h);
  return motion;
}
}  // namespace ping_pong
