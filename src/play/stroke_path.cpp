#include "stroke_path.h"

#include <algorithm>
#include <cmath>

namespace ping_pong::play
{
namespace
{
constexpr int kWorkOfAPath = 6;        // to look at a path costs as much as so many flights
constexpr double kMargin = 0.012;      // between racket and table [m]
constexpr double kBallMargin = 0.010;  // between racket and ball before the hit [m]
constexpr double kSwings[] = {0.11, 0.08, 0.055, 0.035,
                              0.0};                 // length of the swing [s]; 0: at once from where the racket is
constexpr double kFollows[] = {0.12, 0.07, 0.045};  // of the follow-through [s]
constexpr double kLongestDirect = 0.25;             // a way without a swing bends far out in more time [s]
constexpr double kBetweenLooks = 0.015;             // at an approach [s]
constexpr double kLeaving = 0.05;                   // so long the racket may still be where it should not go to [s]
constexpr double kMeeting = 0.012;       // so long before the hit racket and ball are near each other by intent [s]
constexpr double kBetweenPlaces = 0.02;  // at swing and follow-through: the guard shall find nothing between them [m]

int looksAt(const Waypoint& from, const Waypoint& to)
{
  return std::clamp(static_cast<int>((to.p - from.p).norm() / kBetweenPlaces), 4, 40);
}

double smooth(double s)
{
  return s * s * (3.0 - 2.0 * s);
}
}  // namespace

Reach::Reach(const Court& court) : low_(-court.halfLength() - 3.5, -2.3, -0.55), high_(-0.22, 2.3, 1.5) {}

bool Reach::holds(const Vector3d& p) const
{
  return (p.array() >= low_.array()).all() && (p.array() <= high_.array()).all();
}

StrokePaths::StrokePaths(const Court& court, const Blade& blade, const DriveLimits& limits)
    : court_(court), blade_(blade), limits_(limits), reach_(court)
{
}

// As the racket comes it can stop before the table at any time, as TableGuard asks for.
bool StrokePaths::clearApproach(const RacketPath& path, const Prediction& prediction, const RacketNow& now) const
{
  const Waypoint& first = path.direct ? path.hit : path.start;
  const double time = first.time - now.time;
  const int looks = std::clamp(static_cast<int>(time / kBetweenLooks), 6, 60);
  for (int i = 1; i <= looks; ++i)
  {
    const double s = static_cast<double>(i) / looks, t = now.time + s * time;
    if (t < now.time + kLeaving) continue;
    const PathPoint at = onCubic(now.pose.p, now.twist.v, now.time, first, t);
    const Pose pose{at.p, now.pose.q.slerp(smooth(s), path.attitude)};
    if (!reach_.holds(at.p) || !blade_.clearOfTable(pose, court_, kMargin)) return false;
    if (!blade_.stopsBeforeTable(pose, at.v, limits_.acceleration, court_, kMargin)) return false;
    const bool away = t > path.hit.time - kMeeting || t < prediction.start();
    if (!away && !blade_.clearOfBall(pose, prediction.at(t).p_WB, kBallMargin)) return false;
  }
  return true;
}

bool StrokePaths::clear(const RacketPath& path, const Prediction& prediction, const RacketNow& now) const
{
  const auto free = [&](const Vector3d& p, double t)
  {
    const Pose pose{p, path.attitude};
    if (!reach_.holds(p) || !blade_.clearOfTable(pose, court_, kMargin)) return false;
    const bool away = t > path.hit.time - kMeeting || t < prediction.start();
    return away || blade_.clearOfBall(pose, prediction.at(t).p_WB, kBallMargin);
  };
  const int swing_looks = path.direct ? 0 : looksAt(path.start, path.hit), follow_looks = looksAt(path.hit, path.end);
  for (int i = 1; i <= swing_looks; ++i)
  {
    const double t = path.start.time + (path.hit.time - path.start.time) * i / swing_looks;
    if (!free(onCubic(path.start.p, path.start.v, path.start.time, path.hit, t).p, t)) return false;
  }
  for (int i = 1; i <= follow_looks; ++i)
  {
    const double t = path.hit.time + (path.end.time - path.hit.time) * i / follow_looks;
    if (!free(onCubic(path.hit.p, path.hit.v, path.hit.time, path.end, t).p, t)) return false;
  }
  return clearApproach(path, prediction, now);
}

bool StrokePaths::layFor(double swing, double follow, const Prediction& prediction, const RacketNow& now,
                         RacketPath& path) const
{
  const double speed = kSpare * limits_.speed, most = kSpare * limits_.acceleration;
  const double v = path.hit.v.norm();
  follow = std::max(follow, v / (0.8 * most));
  path.direct = swing == 0.0;
  path.end = {path.hit.time + follow, path.hit.p + 0.5 * follow * path.hit.v, Vector3d::Zero()};
  path.start = {path.hit.time - swing, path.hit.p - 0.5 * swing * path.hit.v, Vector3d::Zero()};
  if (path.direct ? path.hit.time - now.time > kLongestDirect : v > 0.8 * most * swing) return false;
  const Waypoint& first = path.direct ? path.hit : path.start;
  const double turn = rotationBetween(now.pose.q, path.attitude).norm();
  const double turning = restToRest(turn, kSpare * limits_.angular_speed, kSpare * limits_.angular_acceleration);
  if (first.time - now.time < turning) return false;
  return withinLimits(now.pose.p, now.twist.v, now.time, first, speed, most) && clear(path, prediction, now);
}

bool StrokePaths::lay(const StrokeTarget& target, const StrokeError& error, const Prediction& prediction,
                      const RacketNow& now, int& work, RacketPath& path) const
{
  const RacketImpact& impact = target.impact;
  const Vector3d level = impact.n_W.cross(Vector3d::UnitZ()).normalized();
  const Quaterniond off = Quaterniond(Eigen::AngleAxisd(error.pitch, level)) *
                          Quaterniond(Eigen::AngleAxisd(error.yaw, impact.n_W.cross(level).normalized()));
  const Vector3d n = (off * impact.n_W).normalized();
  path.attitude = blade_.attitude(n, target.face);
  path.hit = {target.time, target.ball - blade_.reach(target.face) * n + error.place,
              (1.0 + error.speed) * impact.v_WP};
  for (const double swing : kSwings)
    for (const double follow : kFollows)
    {
      work -= kWorkOfAPath;
      if (layFor(swing, follow, prediction, now, path)) return true;
    }
  return false;
}
}  // namespace ping_pong::play
