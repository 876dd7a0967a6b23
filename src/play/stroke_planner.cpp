#include "stroke_planner.h"

#include <algorithm>
#include <cmath>

namespace ping_pong
{
namespace
{
constexpr double kSpare = 0.9;             // of the limits is planned with; the rest is for ticks that straddle a waypoint
constexpr double kMargin = 0.012;          // between racket and table [m]
constexpr double kBallMargin = 0.010;      // between racket and ball before the hit [m]
constexpr double kSoonest = 0.02;          // from now to the hit [s]
constexpr double kMuchTooSoon = 0.6;        // of the time from rest to rest: no need to try
constexpr double kCandidateStep = 0.010;   // [s]
constexpr std::size_t kMostCandidates = 5; // of each wish
constexpr double kApart = 0.035;           // between candidates that are tried [s]
constexpr double kOverEdge = 0.03;         // gap between ball and own end line when struck from below [m]
constexpr double kServeLine = 0.03;        // a serve is struck so far behind the end line, the ball's surface [m]
constexpr double kServeHeight = 0.20;      // of the centre when a serve is struck [m]
constexpr int kMostWork = 300;              // of one plan, in flights: about 2 ms
constexpr int kWorkOfAPath = 6;             // to look at a path costs as much as so many flights
constexpr double kLessSpin[] = {1.0, 0.6, 0.3, 0.0};        // of the change that is wished, until the racket can do it
constexpr double kSwings[] = {0.11, 0.08, 0.055, 0.035, 0.0};  // length of the swing [s]; 0: at once from where the racket is
constexpr double kLongestDirect = 0.25;     // a way without a swing bends far out in more time [s]
constexpr double kBetweenLooks = 0.015;     // at an approach [s]
constexpr double kLeaving = 0.05;           // so long the racket may still be where it should not go to [s]
constexpr double kFollows[] = {0.12, 0.07, 0.045};          // [s]

struct Box
{
  Vector3d low, high;
};

// Where the blade's centre may be, from the middle of the end line [m]: what a quick player reaches.
Box reach(const Court& court)
{
  const double end = -court.halfLength();
  return {{end - 3.5, -2.3, -0.55}, {-0.22, 2.3, 1.5}};
}

bool inside(const Box& box, const Vector3d& p)
{
  return (p.array() >= box.low.array()).all() && (p.array() <= box.high.array()).all();
}

double smooth(double s)
{
  return s * s * (3.0 - 2.0 * s);
}
}  // namespace

StrokePlanner::StrokePlanner(const Scene& scene, const Court& court, const Blade& blade, const BallParams& ball,
                             const DriveLimits& limits)
    : court_(court),
      blade_(blade),
      ball_(ball),
      forces_(court.ownScene(scene, ball).forces),
      model_(forces_, ball_),
      table_(scene.surfaces.at(ball.material, court.surfaceMaterial())),
      limits_(limits)
{
  flyer_.model = &model_;
  flyer_.edge_x = -court.halfLength();
}

Incoming StrokePlanner::incoming(const Prediction& prediction, double from, double to) const
{
  Incoming in;
  const BallState first = prediction.at(from + 1e-3);
  in.speed = first.v_WB.norm();
  in.topspin = -first.w_WB.y();  // it comes along -x
  in.highest = first.p_WB.z();
  for (double t = from; t < to; t += kCandidateStep)
  {
    const Vector3d p = prediction.at(t).p_WB;
    if (p.x() > -court_.halfLength() - 1.0) in.highest = std::max(in.highest, p.z());
  }
  in.is_short = prediction.at(to - 1e-3).p_WB.x() > -court_.halfLength();
  return in;
}

std::vector<StrokePlanner::Candidate> StrokePlanner::candidates(const Prediction& prediction, double from, double to,
                                                                const RacketNow& now, const StrokeWish& wish,
                                                                bool serve) const
{
  std::vector<Candidate> all;
  const Box box = reach(court_);
  for (double t = std::max(from + 0.004, now.time + kSoonest); t < to - 0.004; t += kCandidateStep)
  {
    const BallState ball = prediction.at(t);
    if (!inside(box, ball.p_WB)) continue;
    const double way = std::max(0.0, (ball.p_WB - now.pose.p).norm() - 0.1);
    if (t - now.time < kMuchTooSoon * restToRest(way, limits_.speed, limits_.acceleration)) continue;
    double cost;
    if (serve)
    {
      if (ball.v_WB.z() > -0.3 || ball.p_WB.x() > -court_.halfLength() - ball_.radius - kServeLine) continue;
      cost = std::abs(ball.p_WB.z() - kServeHeight) / 0.2;
      if (ball.p_WB.z() < 0.05) continue;
    }
    else
    {
      const double height = (ball.p_WB.z() - wish.hit_height) / 0.25, depth = (ball.p_WB.x() - wish.hit_x) / 0.45;
      cost = height * height + depth * depth + 0.05 * ball.v_WB.z() * ball.v_WB.z() +
             0.3 * std::max(0.0, 0.25 - (t - now.time)) / 0.25;
    }
    all.push_back({t, cost});
  }
  std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  std::vector<Candidate> best;
  for (const Candidate& candidate : all)
  {
    const bool apart = std::all_of(best.begin(), best.end(), [&](const Candidate& taken)
                                   { return std::abs(taken.time - candidate.time) > kApart; });
    if (apart) best.push_back(candidate);
    if (best.size() == kMostCandidates) break;
  }
  return best;
}

Vector3d StrokePlanner::spinWish(const StrokeWish& wish, const BallState& in, double share) const
{
  if (!wish.brush) return in.w_WB;
  const Vector3d way = Vector3d(wish.target_x - in.p_WB.x(), wish.target_y - in.p_WB.y(), 0.0).normalized();
  const Vector3d wanted = wish.topspin * Vector3d::UnitZ().cross(way) + wish.sidespin * Vector3d::UnitZ();
  return in.w_WB + share * (wanted - in.w_WB);
}

// The ball's way out and the racket's velocity, with as much of the spin as the racket's speed allows.
bool StrokePlanner::aim(StrokePlan& plan, bool serve, Flyer flyer, const Vector3d& guess) const
{
  const Surface& law = blade_.law(plan.face);
  for (const double share : kLessSpin)
  {
    if (!plan.wish.brush && share < 1.0) return false;
    const Vector3d wanted = spinWish(plan.wish, plan.in, share);
    const SpinOf spin = [&](const Vector3d& v) { return reachableSpin(law, ball_, plan.in, v, wanted); };
    const Vector3d target(plan.wish.target_x, plan.wish.target_y, ball_.radius);
    const double over_net = court_.netHeight() + ball_.radius + plan.wish.over_net;
    std::optional<AimedShot> shot;
    if (serve)
    {
      const TableBounce off = [&](BallState& ball)
      { bounce(table_, ball_, ball, Vector3d::Zero(), Vector3d::UnitZ()); };
      for (const double faster : {1.0, 1.2, 0.85, 1.4, 0.7})
        if (!shot)
          shot = serveToTarget(flyer, plan.in.p_WB, spin, off,
                               {target, plan.wish.own_bounce, faster * plan.wish.speed, over_net});
    }
    else
    {
      const double time = guess.isZero() ? plan.wish.flight_time : plan.shot.arc.duration;
      const ShotWish wish = {target, time, 1.3, over_net, ball_.radius + kOverEdge};
      shot = shotToTarget(flyer, plan.in.p_WB, spin, wish, guess);
    }
    if (!shot) continue;
    const std::optional<RacketImpact> impact = invertStroke(law, ball_, plan.in, shot->out.v_WB, wanted);
    if (!impact || impact->v_WP.norm() > kSpare * limits_.speed) continue;
    plan.shot = *shot;
    plan.impact = *impact;
    return true;
  }
  return false;
}

bool StrokePlanner::clear(const RacketPath& path, const Prediction& prediction, const RacketNow& now) const
{
  constexpr int kSwingLooks = 8, kFollowLooks = 6;
  const Waypoint& first = path.direct ? path.hit : path.start;
  const int approach_looks = std::clamp(static_cast<int>((first.time - now.time) / kBetweenLooks), 6, 60);
  const Box box = reach(court_);
  const auto free = [&](const Pose& pose, double t)
  {
    if (!inside(box, pose.p) || !blade_.clearOfTable(pose, court_, kMargin)) return false;
    const bool before = t < path.hit.time - 0.012 && t > prediction.start();
    return !before || blade_.clearOfBall(pose, prediction.at(t).p_WB, kBallMargin);
  };
  if (!path.direct)
    for (int i = 1; i <= kSwingLooks; ++i)
    {
      const double t = path.start.time + (path.hit.time - path.start.time) * i / kSwingLooks;
      if (!free({onCubic(path.start.p, path.start.v, path.start.time, path.hit, t), path.attitude}, t)) return false;
    }
  for (int i = 1; i <= kFollowLooks; ++i)
  {
    const double t = path.hit.time + (path.end.time - path.hit.time) * i / kFollowLooks;
    if (!free({onCubic(path.hit.p, path.hit.v, path.hit.time, path.end, t), path.attitude}, t)) return false;
  }
  for (int i = 1; i <= approach_looks; ++i)
  {
    const double s = static_cast<double>(i) / approach_looks, t = now.time + s * (first.time - now.time);
    const Pose pose{onCubic(now.pose.p, now.twist.v, now.time, first, t), now.pose.q.slerp(smooth(s), path.attitude)};
    if (t > now.time + kLeaving && !free(pose, t)) return false;  // where it is now it is, and leaves
  }
  return true;
}

bool StrokePlanner::layFor(StrokePlan& plan, double swing, double follow, const Prediction& prediction,
                           const RacketNow& now) const
{
  RacketPath& path = plan.path;
  const double speed = kSpare * limits_.speed, most = kSpare * limits_.acceleration;
  const double v = path.hit.v.norm();
  follow = std::max(follow, v / (0.8 * most));
  path.direct = swing == 0.0;
  path.end = {path.hit.time + follow, path.hit.p + 0.5 * follow * path.hit.v, Vector3d::Zero()};
  path.start = {path.hit.time - swing, path.hit.p - 0.5 * swing * path.hit.v, Vector3d::Zero()};
  if (path.direct ? path.hit.time - now.time > kLongestDirect : v > 0.8 * most * swing) return false;
  const Waypoint& first = path.direct ? path.hit : path.start;
  const double turn = rotationBetween(now.pose.q, path.attitude).norm();
  const double time = first.time - now.time;
  const double turning = restToRest(turn, kSpare * limits_.angular_speed, kSpare * limits_.angular_acceleration);
  if (time < turning || !withinLimits(now.pose.p, now.twist.v, now.time, first, speed, most)) return false;
  return clear(path, prediction, now);
}

bool StrokePlanner::lay(StrokePlan& plan, double time, const Prediction& prediction, const RacketNow& now,
                        const StrokeError& error, int& work) const
{
  const Vector3d level = plan.impact.n_W.cross(Vector3d::UnitZ()).normalized();
  const Quaterniond off = Quaterniond(Eigen::AngleAxisd(error.pitch, level)) *
                          Quaterniond(Eigen::AngleAxisd(error.yaw, plan.impact.n_W.cross(level).normalized()));
  const Vector3d n = (off * plan.impact.n_W).normalized();
  plan.path.attitude = blade_.attitude(n, plan.face);
  plan.path.hit = {time, plan.in.p_WB - blade_.reach(plan.face) * n + error.place,
                   (1.0 + error.speed) * plan.impact.v_WP};
  for (const double swing : kSwings)
    for (const double follow : kFollows)
    {
      work -= kWorkOfAPath;
      if (layFor(plan, swing, follow, prediction, now)) return true;
    }
  return false;
}

std::optional<StrokePlan> StrokePlanner::plan(const Prediction& prediction, double from, double to,
                                              const RacketNow& now, const std::vector<StrokeWish>& wishes,
                                              const StrokeError& error, bool serve) const
{
  int work = kMostWork;
  Flyer flyer = flyer_;
  flyer.left = &work;
  for (const StrokeWish& wish : wishes)
    for (const Candidate& candidate : candidates(prediction, from, to, now, wish, serve))
    {
      if (work <= 0) return std::nullopt;
      StrokePlan plan;
      plan.wish = wish;
      plan.in = prediction.at(candidate.time);
      plan.face = plan.in.p_WB.y() < 0.05 || serve ? Face::Forehand : Face::Backhand;
      if (aim(plan, serve, flyer, Vector3d::Zero()) && lay(plan, candidate.time, prediction, now, error, work)) return plan;
    }
  return std::nullopt;
}

std::optional<StrokePlan> StrokePlanner::refined(const StrokePlan& plan, const Prediction& prediction,
                                                 const RacketNow& now, const StrokeError& error, bool serve) const
{
  StrokePlan better = plan;
  better.in = prediction.at(plan.path.hit.time);
  int work = kMostWork;
  Flyer flyer = flyer_;
  flyer.left = &work;
  if (!aim(better, serve, flyer, plan.shot.out.v_WB) || !lay(better, plan.path.hit.time, prediction, now, error, work)) return std::nullopt;
  return better;
}
}  // namespace ping_pong
