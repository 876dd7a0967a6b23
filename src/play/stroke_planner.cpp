#include "stroke_planner.h"

#include <algorithm>
#include <cmath>

namespace ping_pong::play
{
namespace
{
constexpr double kSoonest = 0.02;           // from now to the hit [s]
constexpr double kMuchTooSoon = 0.6;        // of the time from rest to rest: no need to try
constexpr double kCandidateStep = 0.010;    // [s]
constexpr std::size_t kMostCandidates = 5;  // of each wish
constexpr double kApart = 0.035;            // between candidates that are tried [s]
constexpr double kOverEdge = 0.03;          // gap between ball and own end line when struck from below [m]
constexpr double kServeLine = 0.03;         // a serve is struck so far behind the end line, the ball's surface [m]
constexpr double kServeHeight = 0.20;       // of the centre when a serve is struck [m]
constexpr int kMostWork = 250;              // of one plan, in flights: about 2 ms
constexpr int kWorkOfAPath = 6;             // to look at a path costs as much as so many flights
constexpr double kLessSpin[] = {1.0, 0.6, 0.3, 0.0};  // of the change that is wished, until the racket can do it

StrokeTarget aimOf(const StrokePlan& plan, double time)
{
  return {time, plan.in.p_WB, plan.face, plan.impact};
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
      limits_(limits),
      paths_(court, blade, limits)
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
  const Reach reach(court_);
  for (double t = std::max(from + 0.004, now.time + kSoonest); t < to - 0.004; t += kCandidateStep)
  {
    const BallState ball = prediction.at(t);
    if (!reach.holds(ball.p_WB)) continue;
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
    const bool apart =
        std::all_of(best.begin(), best.end(),
                    [&](const Candidate& taken) { return std::abs(taken.time - candidate.time) > kApart; });
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
      if (aim(plan, serve, flyer, Vector3d::Zero()) &&
          paths_.lay(aimOf(plan, candidate.time), error, prediction, now, work, plan.path))
        return plan;
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
  if (!aim(better, serve, flyer, plan.shot.out.v_WB) ||
      !paths_.lay(aimOf(better, plan.path.hit.time), error, prediction, now, work, better.path))
    return std::nullopt;
  return better;
}
}  // namespace ping_pong::play
