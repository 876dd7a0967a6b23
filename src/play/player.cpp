#include "player.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "ball_estimate.h"

namespace ping_pong
{
namespace
{
constexpr double kReadyBack = 0.45, kReadyHeight = 0.20;   // behind the end line, above the surface [m]
constexpr double kReturnTime = 0.30;                       // to the ready place, if nothing hurries [s]
constexpr double kEase = 0.5;                              // of the limits, on that way
constexpr double kLookAgain = 0.040;                       // until a plan is tried again that was not found [s]
constexpr double kNoMoreChanges = 0.015;                   // before the hit a stroke is as it is [s]
constexpr double kHandBack = 0.22, kHandHeight = 0.08;     // of the free hand: behind the end line, above the surface [m]
constexpr double kTossSpeed = 2.5;                         // rises by 30 cm; the law asks for 16 [m/s]
constexpr double kServeSide = -0.15;                       // the hand is so far to the right [m]
constexpr double kInHand = 0.25;                           // a ball slower than this is not in play yet [m/s]
constexpr double kKeepAway = 0.35, kDodge = 0.60;          // from a ball that is going out [m]
constexpr double kFar = 1e9;

BallParams ballOf(const Scene& scene)
{
  if (!scene.balls.empty()) return scene.balls.front().params;
  return BallParams();  // of material "ball", the first of every scene
}
}  // namespace

struct Player::Impl
{
  Impl(const Scene& scene, const PlayerParams& its_params);

  PaddleCommand update(const Observation& now);
  const SeenBall* ballToPlay(const Observation& now);
  void follow(const SeenBall& ball, const Observation& now);
  void think(bool refine, const RacketNow& racket, bool serve);
  bool window(bool serve, double& from, double& to) const;
  bool asPlanned() const;
  StrokeError drawError();
  PaddleCommand goHome(const RacketNow& racket, double tick);
  Vector3d home(double time) const;
  PaddleCommand toWorld(PaddleCommand command) const;

  PlayerParams params;
  LevelTraits level;
  Court court;
  BallParams ball;
  Blade blade;
  RacketDrive drive;
  StrokePlanner planner;
  BallEstimate estimate;
  Random random;
  Quaterniond ready_attitude;
  std::optional<StrokePlan> plan;
  StrokeError error;
  std::optional<Waypoint> way_home;
  bool served = false, serving = false, failed = false;
  bool has_ball = false;
  BallId ball_id = 0;
  double try_again = 0.0;
  std::uint64_t plans = 0, unplayable = 0;
};

Player::Impl::Impl(const Scene& scene, const PlayerParams& its_params)
    : params(its_params),
      level(levelTraits(params.level)),
      court(scene, params.end),
      ball(ballOf(scene)),
      blade(scene, params.paddle, ball),
      drive(limitsOf(blade.limits(), level)),
      planner(scene, court, blade, ball, drive.limits()),
      estimate(scene, court, ball, level, params.seed),
      random(params.seed, 0)
{
  Matrix3d edge_on;  // tip to the net, forehand to the left: a quarter turn to either stroke
  edge_on << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  ready_attitude = Quaterniond(edge_on);
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
  StrokeError drawn;
  for (int i = 0; i < 3; ++i) drawn.place[i] = level.place * random.normal();
  drawn.pitch = level.angle * random.normal();
  drawn.yaw = level.angle * random.normal();
  drawn.speed = level.stroke_speed * random.normal();
  return drawn;
}

bool Player::Impl::window(bool serve, double& from, double& to) const
{
  if (!serve) return estimate.window(from, to);
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

void Player::Impl::think(bool refine, const RacketNow& racket, bool serve)
{
  if (plan && racket.time > plan->path.hit.time - kNoMoreChanges) return;
  if (plan)
  {
    if (!refine || asPlanned()) return;
    const std::optional<StrokePlan> better = planner.refined(*plan, estimate.prediction(), racket, error, serve);
    if (better)
    {
      plan = better;
      return;
    }
  }
  if (racket.time < try_again) return;  // what there is is better than nothing
  double from, to;
  if (!window(serve, from, to)) return plan.reset();
  const bool again = plan.has_value() || failed;
  if (!again) error = drawError();
  const Incoming in = planner.incoming(estimate.prediction(), from, to);
  const std::vector<StrokeWish> wishes =
      serve ? chooseServes(params.style, court.halfLength(), court.halfWidth(), random)
            : chooseStrokes(in, params.style, court.halfLength(), court.halfWidth(), random);
  plan = planner.plan(estimate.prediction(), from, to, racket, wishes, error, serve);
  plans += plan.has_value();
  unplayable += !plan && !failed;
  failed = !plan;
  try_again = racket.time + kLookAgain;
}

void Player::Impl::follow(const SeenBall& seen, const Observation& now)
{
  if (!has_ball || seen.id != ball_id)
  {
    estimate.forget();
    plan.reset();
    has_ball = true;
    ball_id = seen.id;
  }
  BallState state;
  state.p_WB = seen.p_WB;
  state.v_WB = seen.v_WB;
  state.w_WB = seen.w_WB;
  const RacketNow racket{now.time, court.toOwn(now.pose),
                         {court.turnedToOwn(now.twist.v), court.turnedToOwn(now.twist.w)}};
  const bool in_hand = now.to_serve && !served && seen.v_WB.norm() < kInHand && !serving;
  if (in_hand) return;
  serving = now.to_serve && !served;
  estimate.feel(serving);
  const BallEstimate::News news = estimate.update(now.time, court.toOwn(state));
  if (news == BallEstimate::News::Struck)
  {
    failed = false;
    try_again = 0.0;
    if (plan && racket.time < plan->path.hit.time) plan.reset();
  }
  think(news == BallEstimate::News::Changed, racket, serving);
}

Vector3d Player::Impl::home(double time) const
{
  Vector3d place(-court.halfLength() - kReadyBack, serving || (!has_ball && served) ? kServeSide - 0.25 : 0.0, kReadyHeight);
  double from, to;
  const Prediction& prediction = estimate.prediction();
  if (prediction.empty() || estimate.mine() || estimate.window(from, to)) return place;
  for (double t = time; t < std::min(time + 0.5, prediction.end()); t += 0.02)
  {
    const BallState at = prediction.at(t);
    if (at.v_WB.x() < 0.0 && (at.p_WB - place).norm() < kKeepAway)
    {
      place.y() = at.p_WB.y() + (at.p_WB.y() > place.y() ? -kDodge : kDodge);
      break;
    }
  }
  return place;
}

PaddleCommand Player::Impl::goHome(const RacketNow& racket, double tick)
{
  const Vector3d place = home(racket.time);
  const bool moved = way_home && (way_home->p - place).norm() > 0.05;
  if (!way_home || moved)
  {
    const DriveLimits& limits = drive.limits();
    const double way = (place - racket.pose.p).norm() + 0.5 * racket.twist.v.norm() * kReturnTime;
    const double turn = rotationBetween(racket.pose.q, ready_attitude).norm();
    const double time = std::max({kReturnTime, restToRest(way, kEase * limits.speed, kEase * limits.acceleration),
                                  restToRest(turn, kEase * limits.angular_speed, kEase * limits.angular_acceleration)});
    way_home = Waypoint{racket.time + time, place, Vector3d::Zero()};
  }
  if (racket.time < way_home->time)
    return drive.command(racket.pose, racket.twist, racket.time, tick, *way_home, ready_attitude, way_home->time);
  Waypoint stay = *way_home;
  stay.time = racket.time + 10.0 * tick;
  return drive.command(racket.pose, racket.twist, racket.time, tick, stay, ready_attitude, stay.time);
}

PaddleCommand Player::Impl::toWorld(PaddleCommand command) const
{
  command.a_W = court.turnedToWorld(command.a_W);
  command.alpha_W = court.turnedToWorld(command.alpha_W);
  return command;
}

PaddleCommand Player::Impl::update(const Observation& now)
{
  if (!now.to_serve) served = false;
  if (const SeenBall* seen = ballToPlay(now))
    follow(*seen, now);
  else if (has_ball)
  {
    has_ball = false;
    estimate.forget();
    plan.reset();
  }
  const RacketNow racket{now.time, court.toOwn(now.pose),
                         {court.turnedToOwn(now.twist.v), court.turnedToOwn(now.twist.w)}};
  if (!plan) return toWorld(goHome(racket, now.tick));
  const RacketPath& path = plan->path;
  if (now.time >= path.hit.time - 1e-9 && !estimate.mine())
  {
    estimate.struckByMe();
    served = serving;
    serving = false;
    estimate.feel(false);
  }
  if (now.time >= path.over() - 1e-9)
  {
    plan.reset();
    way_home.reset();
    return toWorld(goHome(racket, now.tick));
  }
  way_home.reset();
  const Waypoint& goal = path.next(now.time, now.tick);
  const double turned_at = path.direct ? path.hit.time : path.start.time;
  return toWorld(drive.command(racket.pose, racket.twist, now.time, now.tick, goal, path.attitude, turned_at));
}

Player::Player(const Scene& scene, const PlayerParams& params) : impl_(std::make_unique<Impl>(scene, params)) {}
Player::~Player() = default;
Player::Player(Player&&) noexcept = default;
Player& Player::operator=(Player&&) noexcept = default;

PaddleCommand Player::update(const Observation& now)
{
  return impl_->update(now);
}

BallState Player::toss() const
{
  BallState ball;
  ball.p_WB = Vector3d(-impl_->court.halfLength() - kHandBack, kServeSide, kHandHeight);
  ball.v_WB = Vector3d(0.0, 0.0, kTossSpeed);
  return impl_->court.toWorld(ball);
}

Pose Player::ready() const
{
  return impl_->court.toWorld(
      Pose{{-impl_->court.halfLength() - kReadyBack, 0.0, kReadyHeight}, impl_->ready_attitude});
}

void Player::reset()
{
  impl_->estimate.forget();
  impl_->plan.reset();
  impl_->way_home.reset();
  impl_->served = impl_->serving = impl_->failed = impl_->has_ball = false;
  impl_->try_again = 0.0;
}

const Court& Player::court() const
{
  return impl_->court;
}
const Prediction& Player::prediction() const
{
  return impl_->estimate.prediction();
}
const StrokePlan* Player::plan() const
{
  return impl_->plan ? &*impl_->plan : nullptr;
}
std::uint64_t Player::plans() const
{
  return impl_->plans;
}
std::uint64_t Player::unplayable() const
{
  return impl_->unplayable;
}
}  // namespace ping_pong
