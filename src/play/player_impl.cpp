#include "player_impl.h"

#include <algorithm>
#include <cmath>

namespace ping_pong::play
{
namespace
{
constexpr double kLookAgain = 0.040;                    // until a plan is tried again that was not found [s]
constexpr double kNoMoreChanges = 0.015;                // before the hit a stroke is as it is [s]
constexpr double kHandBack = 0.22, kHandHeight = 0.08;  // of the free hand: behind the end line, above the surface [m]
constexpr double kTossSpeed = 2.5;                      // rises by 30 cm; the law asks for 16 [m/s]
constexpr double kServeSide = -0.15;                    // the hand is so far to the right [m]
constexpr double kServeError = 0.4;                     // of the errors of a stroke: the ball is one's own
constexpr int kFresh = 10;                              // own strokes of a rally before the hand tires
constexpr double kTiring = 0.003;                       // of the face's angle, more with each later stroke [rad]
constexpr double kMostTired = 0.060;                    // [rad]: half of the strokes miss
constexpr double kServeAside = 0.25;                    // and the racket waits so far aside of it [m]
constexpr double kInHandReach = 0.10;                   // a still ball so near to the hand is in it [m]
constexpr double kTick = 1e-3;                          // if none is told [s]
constexpr double kInHand = 0.25;                        // a ball slower than this is not in play yet [m/s]
constexpr double kFar = 1e9;                            // later than any time [s]

BallParams ballOf(const Scene& scene)
{
  if (!scene.balls.empty()) return scene.balls.front().params;
  return BallParams();  // of material "ball", the first of every scene
}
}  // namespace

Player::Impl::Impl(const Scene& scene, const PlayerParams& its_params)
    : params(its_params),
      level(levelTraits(params.level)),
      court(scene, params.end),
      ball(ballOf(scene)),
      blade(scene, params.paddle, ball),
      drive(limitsOf(blade.limits(), level)),
      ready(court, blade, drive),
      planner(scene, court, blade, ball, drive.limits()),
      estimate(scene, court, ball, level, params.seed),
      random(params.seed, 0)
{
}

// The one that was followed, while it is there and comes; else the soonest of those that come to this end.
const SeenBall* Player::Impl::ballToPlay(const Observation& now)
{
  const SeenBall* best = nullptr;
  double soonest = kFar;
  for (const SeenBall& seen : now.balls)
  {
    const double x = court.toOwn(Pose{seen.p_WB, Quaterniond::Identity()}).p.x();
    const double vx = court.turnedToOwn(seen.v_WB).x();
    const bool followed = has_ball && seen.id == ball_id;
    const double behind = x + court.halfLength() + 2.0;
    double when = vx < -0.1 && behind > 0.0 ? behind / -vx : followed ? 10.0 : 20.0;
    if (followed) when -= plan ? 5.0 : 0.1;
    if (when < soonest) soonest = when, best = &seen;
  }
  return best;
}

StrokeError Player::Impl::drawError()
{
  const double share = serving ? kServeError : 1.0;
  // Two hands that never tire would never end a rally: from some strokes on the face of the racket is held less well.
  const double tired = params.style == Style::Cooperative ? 0.0 : kTiring * std::max(0, strokes - kFresh);
  const double angle = std::hypot(level.angle, std::min(tired, kMostTired));
  StrokeError drawn;
  for (int i = 0; i < 3; ++i) drawn.place[i] = share * level.place * random.normal();
  drawn.pitch = share * angle * random.normal();
  drawn.yaw = share * angle * random.normal();
  drawn.speed = share * level.stroke_speed * random.normal();
  return drawn;
}

bool Player::Impl::window(double& from, double& to) const
{
  if (!serving) return estimate.window(from, to);
  const Prediction& prediction = estimate.prediction();
  if (prediction.empty()) return false;
  from = prediction.start();
  to = prediction.bounces().empty() ? prediction.end() : prediction.bounces().front().time;
  return true;
}

// The ball is expected at the hit as the plan has it; what is left is less than what a look is wrong by.
bool Player::Impl::asPlanned() const
{
  const BallState at = estimate.prediction().at(plan->path.hit.time);
  return (at.p_WB - plan->in.p_WB).norm() < 0.1 * level.see_place &&
         (at.v_WB - plan->in.v_WB).norm() < 0.1 * level.see_velocity;
}

void Player::Impl::think(bool refine, const RacketNow& racket)
{
  const Prediction& prediction = estimate.prediction();
  if (plan && racket.time > plan->path.hit.time - kNoMoreChanges) return;
  if (plan && !stale)
  {
    if (!refine || asPlanned()) return;
    const std::optional<StrokePlan> better = planner.refined(*plan, prediction, racket, error, serving);
    stale = !better;  // another stroke is looked for in the next tick: each has its share of work
    if (better) plan = better;
    return;
  }
  if (racket.time < try_again) return;
  double from, to;
  if (!window(from, to)) return plan.reset();
  if (!plan && !failed) error = drawError();
  const std::vector<StrokeWish> wishes = serving
                                             ? chooseServes(params.style, court.halfLength(), court.halfWidth(), random)
                                             : chooseStrokes(planner.incoming(prediction, from, to), params.style,
                                                             court.halfLength(), court.halfWidth(), random);
  const std::optional<StrokePlan> found = planner.plan(prediction, from, to, racket, wishes, error, serving);
  plans += found.has_value();
  unplayable += !found && !plan && !failed;
  failed = !found && !plan;
  if (found) plan = found;  // else what there is is better than nothing
  stale = false;
  try_again = racket.time + kLookAgain;
}

void Player::Impl::forgetBall()
{
  has_ball = stale = false;
  estimate.forget();
  plan.reset();
}

void Player::Impl::reset()
{
  forgetBall();
  ready.leave();
  served = serving = failed = stale = false;
  try_again = 0.0;
  strokes = 0;
}

BallState Player::Impl::toss() const
{
  BallState thrown;
  thrown.p_WB = Vector3d(-court.halfLength() - kHandBack, kServeSide, kHandHeight);
  thrown.v_WB = Vector3d(0.0, 0.0, kTossSpeed);
  return court.toWorld(thrown);
}

void Player::Impl::follow(const SeenBall& seen, const Observation& now, const RacketNow& racket)
{
  if (!has_ball || seen.id != ball_id) forgetBall(), strokes = 0;
  has_ball = true;
  ball_id = seen.id;
  BallState state;
  state.p_WB = seen.p_WB;
  state.v_WB = seen.v_WB;
  state.w_WB = seen.w_WB;
  const bool still = seen.v_WB.norm() < kInHand;
  if (now.to_serve && still && (seen.p_WB - toss().p_WB).norm() < kInHandReach) served = serving = false;
  if (now.to_serve && still && !served && !serving) return;  // in the hand
  serving = now.to_serve && !served;
  estimate.feel(serving);
  const BallEstimate::News news = estimate.update(now.time, court.toOwn(state));
  if (news == BallEstimate::News::Struck)
  {
    failed = false;
    try_again = 0.0;
    if (plan && racket.time < plan->path.hit.time) plan.reset();
  }
  think(news == BallEstimate::News::Changed, racket);
}

PaddleCommand Player::Impl::toWorld(PaddleCommand command) const
{
  command.a_W = court.turnedToWorld(command.a_W);
  command.alpha_W = court.turnedToWorld(command.alpha_W);
  return command;
}

PaddleCommand Player::Impl::moved(const RacketNow& racket, double tick)
{
  if (plan && racket.time >= plan->path.over() - 1e-9) plan.reset();
  if (!plan) return ready.command(racket, tick, estimate, serving ? kServeSide - kServeAside : 0.0);
  ready.leave();
  const RacketPath& path = plan->path;
  if (racket.time >= path.hit.time - 1e-9 && !estimate.mine())
  {
    estimate.struckByMe();
    ++strokes;
    served = serving;
    serving = false;
    estimate.feel(false);
  }
  const double turned_at = path.direct ? path.hit.time : path.start.time;
  return drive.command(racket.pose, racket.twist, racket.time, tick, path.next(racket.time, tick), path.attitude,
                       turned_at);
}

PaddleCommand Player::Impl::update(const Observation& now)
{
  if (now.time < last_time) reset();  // the world was put back
  last_time = now.time;
  if (!now.to_serve) served = false;
  const RacketNow racket{
      now.time, court.toOwn(now.pose), {court.turnedToOwn(now.twist.v), court.turnedToOwn(now.twist.w)}};
  if (const SeenBall* seen = ballToPlay(now))
    follow(*seen, now, racket);
  else if (has_ball)
    forgetBall();
  const double tick = now.tick > 0.0 ? now.tick : kTick;
  return toWorld(ready.guarded(moved(racket, tick), racket, tick));
}
}  // namespace ping_pong::play
