#include "ready_position.h"

#include <algorithm>
#include <cmath>

namespace ping_pong::play
{
namespace
{
constexpr double kBack = 0.45, kHeight = 0.20;     // behind the end line, above the surface [m]
constexpr double kReturnTime = 0.30;               // to there, if nothing hurries [s]
constexpr double kEase = 0.5;                      // of the limits, on that way
constexpr double kGuard = 0.005;                   // between racket and table, kept at all times [m]
constexpr double kKeepAway = 0.35, kDodge = 0.60;  // from a ball that is not to be touched [m]
constexpr double kAhead = 0.5, kAheadStep = 0.02;  // so far such a ball is looked for [s]
constexpr double kMoved = 0.05;                    // the place has changed by so much: another way [m]
constexpr double kStayTicks = 10.0;                // what puts the racket off its place is undone in so many ticks
}  // namespace

ReadyPosition::ReadyPosition(const Court& court, const Blade& blade, const RacketDrive& drive)
    : court_(court), blade_(blade), drive_(drive)
{
  Matrix3d edge_on;  // tip (z) along x, forehand (x) to the left
  edge_on << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  pose_ = {{-court.halfLength() - kBack, 0.0, kHeight}, Quaterniond(edge_on)};
}

Vector3d ReadyPosition::place(const RacketNow& racket, const BallEstimate& ball, double y) const
{
  Vector3d place = pose_.p;
  place.y() = y;
  double from, to;
  const Prediction& prediction = ball.prediction();
  if (prediction.empty() || ball.mine() || ball.window(from, to)) return place;
  for (double t = racket.time; t < std::min(racket.time + kAhead, prediction.end()); t += kAheadStep)
  {
    const BallState at = prediction.at(t);
    if (at.v_WB.x() >= 0.0 || (at.p_WB - place).norm() >= kKeepAway) continue;
    place.y() = at.p_WB.y() + (at.p_WB.y() > place.y() ? -kDodge : kDodge);
    break;
  }
  return place;
}

PaddleCommand ReadyPosition::command(const RacketNow& racket, double tick, const BallEstimate& ball, double y)
{
  const Vector3d goal = place(racket, ball, y);
  if (!way_ || (way_->p - goal).norm() > kMoved)
  {
    const DriveLimits& limits = drive_.limits();
    const double way = (goal - racket.pose.p).norm() + 0.5 * racket.twist.v.norm() * kReturnTime;
    const double turn = rotationBetween(racket.pose.q, pose_.q).norm();
    const double time = std::max({kReturnTime, restToRest(way, kEase * limits.speed, kEase * limits.acceleration),
                                  restToRest(turn, kEase * limits.angular_speed, kEase * limits.angular_acceleration)});
    way_ = Waypoint{racket.time + time, goal, Vector3d::Zero()};
  }
  Waypoint next = *way_;
  next.time = std::max(next.time, racket.time + kStayTicks * tick);
  return drive_.command(racket.pose, racket.twist, racket.time, tick, next, pose_.q, next.time);
}

PaddleCommand ReadyPosition::guarded(PaddleCommand command, const RacketNow& racket, double tick) const
{
  if (!blade_.clearOfTable(racket.pose, court_, kGuard)) return command;  // it gets out of there
  const double most = drive_.limits().acceleration;
  const Vector3d v = racket.twist.v + tick * command.a_W;
  const Vector3d turn = tick * (racket.twist.w + 0.5 * tick * command.alpha_W);
  Pose then{racket.pose.p + 0.5 * tick * (racket.twist.v + v), racket.pose.q};
  if (!turn.isZero()) then.q = Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * then.q;
  if (blade_.clearOfTable(then, court_, kGuard) && blade_.stopsBeforeTable(then, v, most, court_, kGuard))
    return command;
  const Vector3d brake = -racket.twist.v / tick;
  command.a_W = brake.norm() > most ? Vector3d(most / brake.norm() * brake) : brake;
  return command;
}
}  // namespace ping_pong::play
