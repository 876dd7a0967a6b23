#include "racket_path.h"

#include <algorithm>
#include <cmath>

namespace ping_pong::play
{
namespace
{
constexpr double kSame = 1e-9;      // of a tick: so near to its end is its end
constexpr double kTurnTicks = 4.0;  // what is left of a turn is undone in so many ticks
constexpr double kInside = 1.0 - 1e-9;

Vector3d clamped(const Vector3d& x, double length)
{
  const double norm = x.norm();
  return norm > length ? Vector3d(length / norm * x) : x;
}

// Acceleration of one tick that passes neither limit.
Vector3d allowed(const Vector3d& a, const Vector3d& v, double tick, double speed, double acceleration)
{
  const Vector3d then = clamped(v + tick * clamped(a, kInside * acceleration), kInside * speed);
  return clamped((then - v) / tick, kInside * acceleration);
}
}  // namespace

Vector3d nextAcceleration(const Vector3d& way, const Vector3d& v, const Vector3d& v_goal, double time_left, double tick)
{
  const double T = std::max(time_left, kSame * tick);
  const double ticks = std::ceil(T / tick - kSame);
  const Vector3d dv = v_goal - v;
  if (ticks < 1.5) return dv / T;
  // a_j = alpha + beta w_j, w_j from the middle of tick j to the goal: sum(a_j h_j) = dv, sum(a_j h_j w_j) = dp.
  const Vector3d dp = way - T * v;
  const double last = T - (ticks - 1.0) * tick;
  const double s1 = 0.5 * T * T;
  const double s2 = T * T * T / 3.0 - ((ticks - 1.0) * tick * tick * tick + last * last * last) / 12.0;
  const Vector3d beta = (T * dp - s1 * dv) / (T * s2 - s1 * s1);
  const Vector3d alpha = (dv - s1 * beta) / T;
  return alpha + (T - 0.5 * tick) * beta;
}

PathPoint onCubic(const Vector3d& p, const Vector3d& v, double time, const Waypoint& goal, double at)
{
  const double T = goal.time - time, s = (at - time) / T, s2 = s * s, s3 = s2 * s;
  const Vector3d way = goal.p - p;
  return {p + (3.0 * s2 - 2.0 * s3) * way + T * ((s3 - 2.0 * s2 + s) * v + (s3 - s2) * goal.v),
          (6.0 * (s - s2) / T) * way + (3.0 * s2 - 4.0 * s + 1.0) * v + (3.0 * s2 - 2.0 * s) * goal.v};
}

bool withinLimits(const Vector3d& p, const Vector3d& v, double time, const Waypoint& goal, double speed,
                  double acceleration)
{
  const double T = goal.time - time;
  if (!(T > 0.0)) return false;
  const Vector3d way = goal.p - p;
  const Vector3d a0 = (6.0 / (T * T)) * way - (4.0 * v + 2.0 * goal.v) / T;
  const Vector3d a1 = (-6.0 / (T * T)) * way + (2.0 * v + 4.0 * goal.v) / T;
  if (a0.norm() > acceleration || a1.norm() > acceleration) return false;
  for (const double s : {0.2, 0.4, 0.6, 0.8, 1.0})
    if ((v + T * s * a0 + (0.5 * T * s * s) * (a1 - a0)).norm() > speed) return false;
  return true;
}

double restToRest(double way, double speed, double acceleration)
{
  return std::max(std::sqrt(6.0 * way / acceleration), 1.5 * way / speed);
}

const Waypoint& RacketPath::next(double time, double tick) const
{
  const double tick_end = time + (1.0 - kSame) * tick;
  if (!direct && tick_end < start.time) return start;
  return time < hit.time - kSame * tick ? hit : end;
}

PaddleCommand RacketDrive::command(const Pose& pose, const Twist& twist, double time, double tick, const Waypoint& goal,
                                   const Quaterniond& attitude, double turned_at) const
{
  PaddleCommand command;
  command.mode = PaddleCommand::Mode::Acceleration;
  const Vector3d a = nextAcceleration(goal.p - pose.p, twist.v, goal.v, goal.time - time, tick);
  const Vector3d turn = rotationBetween(pose.q, attitude);
  const double turn_time = std::max(turned_at - time, kTurnTicks * tick);
  const Vector3d alpha = nextAcceleration(turn, twist.w, Vector3d::Zero(), turn_time, tick);
  command.a_W = allowed(a, twist.v, tick, limits_.speed, limits_.acceleration);
  command.alpha_W = allowed(alpha, twist.w, tick, limits_.angular_speed, limits_.angular_acceleration);
  return command;
}

Vector3d rotationBetween(const Quaterniond& from, const Quaterniond& to)
{
  Quaterniond q = to * from.conjugate();
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  return sine < 1e-15 ? Vector3d(2.0 * q.vec()) : Vector3d(2.0 * std::atan2(sine, q.w()) / sine * q.vec());
}
}  // namespace ping_pong::play
