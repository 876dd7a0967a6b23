#include "umpire_node.h"

#include "ping_pong_sim/SpawnBall.h"
#include "ping_pong_sim/scene_loader.h"
#include "result_file.h"
#include "ros/base/conversions.h"
#include "umpire_messages.h"

namespace ping_pong_sim
{
namespace game = ping_pong::game;
using ping_pong::Vector3d;

namespace
{
constexpr double kUnseen = 0.2;  ///< after which a ball that was thrown should have been seen [s]

game::Rules rulesOf(const std::string& name, int best_of, bool change_ends)
{
  game::Rules rules = game::rulesPreset(name);
  if (best_of > 0) rules.games = best_of;
  rules.change_ends = rules.change_ends && change_ends;
  game::checkRules(rules);
  return rules;
}
}  // namespace

UmpireNode::UmpireNode(ros::NodeHandle& nh, ros::NodeHandle& private_nh, const UmpireParams& params)
    : params_(params), scene_(ping_pong::loadScene(params.scene_path)), simulator_(nh, params.simulator, nullptr)
{
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i) body_of_[scene_.bodies[i].name] = i;
  const game::Court court = game::findCourt(scene_);
  umpire_ = std::make_unique<game::Umpire>(court, rulesOf(params.rules, params.best_of, params.change_ends));
  for (std::size_t end = 0; end < 2; ++end) racket_[end] = scene_.bodies[court.racket[end]].pose.p;

  score_ = nh.advertise<Score>("score", 10, true);
  calls_ = nh.advertise<UmpireCall>("umpire_call", 100);
  const ros::TransportHints fast = ros::TransportHints().tcpNoDelay();
  contacts_ = nh.subscribe("contacts", 10000, &UmpireNode::onContact, this, fast);
  balls_ = nh.subscribe("balls", 10000, &UmpireNode::onBalls, this, fast);
  const boost::function<void(const PaddleStates::ConstPtr&)> keep = [this](const PaddleStates::ConstPtr& message)
  {
    for (const PaddleState& paddle : message->paddles)
      for (std::size_t end = 0; end < 2; ++end)
        if (paddle.name == scene_.bodies[umpire_->court().racket[end]].name)
          racket_[end] = fromPoint(paddle.pose.position, "pose");
  };
  paddles_ = nh.subscribe<PaddleStates>("paddles", 1, keep, {}, fast);
  new_match_ = private_nh.advertiseService("new_match", &UmpireNode::newMatch, this);
  toss_ = private_nh.advertiseService("toss", &UmpireNode::toss, this);
  publishScore();
}

void UmpireNode::onContact(const Contact& message)
{
  const auto body = body_of_.find(message.other);
  if (!message.with_ball && body == body_of_.end()) return;  // of another scene
  events_.add(contactOf(message, message.with_ball ? ping_pong::kNone : body->second), wallSeconds());
}

void UmpireNode::onBalls(const BallStates& message)
{
  if (message.time < last_time_) events_.clear();  // the world was reset: what was on its way is of another time
  last_time_ = message.time;
  last_stamp_ = message.header.stamp;
  events_.add(tickOf(message), wallSeconds());
}

bool UmpireNode::rightScene()
{
  const SimStatus* status = simulator_.status();
  const bool right = status == nullptr || status->scene == scene_.name;
  if (!right && !scene_told_)
    notice("the simulator runs scene '" + status->scene + "'; this match is played in '" + scene_.name +
           "': nothing is judged until it is back");
  scene_told_ = !right;
  return right;
}

void UmpireNode::update()
{
  if (!rightScene()) return events_.clear();
  events_.release(
      wallSeconds(), [this](const ping_pong::Contact& contact) { judge(contact); },
      [this](const TickEnd& tick) { judge(tick); });
  publish();
}

void UmpireNode::judge(const ping_pong::Contact& contact)
{
  const std::optional<ping_pong::BallId> ball = umpire_->ball();
  if (ball && contact.ball == *ball && !contact.with_ball &&
      scene_.bodies[contact.body].kind == ping_pong::BodyKind::Kinematic)
  {
    stroke_speed_ = contact.v_after.norm();
    stroke_spin_ = contact.w_after.norm();
  }
  umpire_->contact(contact);
}

void UmpireNode::judge(const TickEnd& tick)
{
  if (tick.time < time_) idle_since_ = tick.time;
  time_ = tick.time;
  if (thrown_) beginService(tick);
  const std::optional<ping_pong::BallId> ball = umpire_->ball();
  if (!ball)
  {
    umpire_->clock(tick.time);
    return watchServer();
  }
  idle_since_ = tick.time;
  for (const SeenBall& seen : tick.balls)
    if (seen.id == *ball) return umpire_->ballAt(tick.time, seen.state);
  umpire_->let(tick.time, "ball " + std::to_string(*ball) + " is gone");
}

// The ball that was thrown is seen for the first time.
void UmpireNode::beginService(const TickEnd& tick)
{
  for (const SeenBall& seen : tick.balls)
  {
    if (seen.id != *thrown_) continue;
    const game::Service service{seen.id, seen.radius, std::nullopt};
    ping_pong::Refusal refusal = umpire_->putInPlay(tick.time, service);
    if (!refusal) refusal = umpire_->thrown(tick.time, seen.state);
    if (refusal) notice("ball " + std::to_string(seen.id) + " is not in play: " + refusal.reason);
    thrown_.reset();
    return;
  }
  if (tick.time < thrown_at_ + kUnseen) return;
  notice("ball " + std::to_string(*thrown_) + " is gone before it was seen: it is thrown again");
  thrown_.reset();
}

// A server who is gone does not keep the other waiting for ever.
void UmpireNode::watchServer()
{
  if (params_.serve_within <= 0.0 || umpire_->score().winner || time_ - idle_since_ < params_.serve_within) return;
  char reason[80];
  std::snprintf(reason, sizeof(reason), "has not served within %.6g s", params_.serve_within);
  umpire_->forfeit(time_, umpire_->score().server, reason);
}

bool UmpireNode::newMatch(NewMatch::Request& request, NewMatch::Response& response)
{
  response.message = startMatch(request);
  response.success = response.message.empty();
  return true;
}

std::string UmpireNode::startMatch(const NewMatch::Request& request)
{
  if (request.server < -1 || request.server > 1)
    return "server: " + std::to_string(request.server) + ": expected 0, 1 or -1 for one drawn by lot";
  try
  {
    const std::string name = request.rules.empty() ? params_.rules : request.rules;
    const int best_of = request.best_of != 0 ? request.best_of : (request.rules.empty() ? params_.best_of : 0);
    const game::Rules rules = rulesOf(name, best_of, params_.change_ends);
    const bool second = request.server == 1 || (request.server < 0 && ros::WallTime::now().nsec / 1000 % 2 == 1);
    umpire_ = std::make_unique<game::Umpire>(game::findCourt(scene_), rules);
    umpire_->newMatch(time_, second ? game::Player::B : game::Player::A);
    params_.rules = name;
    params_.best_of = best_of;
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  thrown_.reset();
  idle_since_ = time_;
  stroke_speed_ = stroke_spin_ = 0.0;
  notice("a new match: rules " + umpire_->rules().name + ", best of " + std::to_string(umpire_->rules().games));
  publishScore();
  return "";
}

bool UmpireNode::toss(Toss::Request& request, Toss::Response& response)
{
  ping_pong::BallId ball = 0;
  response.message = throwUp(request, ball);
  response.success = response.message.empty();
  response.ball = ball;
  return true;
}

std::string UmpireNode::throwUp(const Toss::Request& request, ping_pong::BallId& ball)
{
  if (!rightScene()) return "the simulator runs another scene";
  if (umpire_->score().winner) return "the match is over: begin a new one";
  if (umpire_->ball() || thrown_) return "a ball is in play";
  constexpr double kHighest = 5.0;  // a ceiling that laws ask for: 2.6.2 knows none
  const double wanted = request.height == 0.0 ? umpire_->rules().toss_height + 0.14 : request.height;
  if (!(wanted > 0.0 && wanted <= kHighest))
    return "height: " + std::to_string(request.height) + ": expected above 0, up to 5 [m]";
  const double g = scene_.forces.gravity.norm();
  if (!(g > 0.0)) return "without gravity no ball comes back";

  if (last_ball_ != 0) simulator_.deleteBall(last_ball_);  // of the rally before; it may be gone already
  SpawnBall exchange;
  try
  {
    exchange.request.position = toPoint(handOf(request));
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  exchange.request.velocity = toVector(-scene_.forces.gravity / g * std::sqrt(2.0 * g * wanted));
  const std::string refusal = simulator_.spawn(exchange);
  if (!refusal.empty()) return refusal;
  ball = exchange.response.id;
  thrown_ = last_ball_ = ball;
  thrown_at_ = last_time_;
  return "";
}

// Where the law wants it: behind the end line and above the playing surface; in front of the racket, so that it can be struck.
Vector3d UmpireNode::handOf(const Toss::Request& request) const
{
  const Vector3d asked = fromPoint(request.position, "position");
  if (asked != Vector3d::Zero()) return asked;
  const game::Court& court = umpire_->court();
  const game::End end = umpire_->endOf(umpire_->score().server);
  const Vector3d p_TR = court.positionInT(racket_[index(end)]);
  const double inside = court.half_width - 0.1;
  constexpr double kBehind = 0.12, kAbove = 0.15;  // of the ball's centre [m]
  return court.X_WT.q *
             Vector3d(sign(end) * (court.half_length + kBehind), std::clamp(p_TR.y(), -inside, inside), kAbove) +
         court.X_WT.p;
}

ros::Time UmpireNode::stamp(double time) const
{
  const double stamp = last_stamp_.toSec() + (time - last_time_);
  return stamp > 0.0 ? ros::Time(stamp) : ros::Time(0);
}

void UmpireNode::publish()
{
  bool over = false;
  for (const game::Call& call : umpire_->takeCalls())
  {
    publishCall(callOf(call), call.time);
    over |= call.kind == game::CallKind::Match;
  }
  publishScore();
  if (over) writeResultFile();
}

void UmpireNode::writeResultFile()
{
  if (params_.result_file.empty()) return;
  try
  {
    writeResult(params_.result_file, *umpire_, params_.players, time_);
  }
  catch (const std::runtime_error& error)
  {
    ROS_ERROR_STREAM("result_file: " << error.what());
  }
}

void UmpireNode::publishScore()
{
  Score message = scoreOf(*umpire_);
  message.header.frame_id = "world";
  for (std::size_t i = 0; i < 2; ++i)
  {
    message.players[i] = params_.players[i];
    message.paddles[i] = scene_.bodies[umpire_->court().racket[index(umpire_->endOf(playerOf(i)))]].name;
  }
  message.stroke_speed = stroke_speed_;
  message.stroke_spin = stroke_spin_;
  message.header.stamp = shown_.header.stamp;
  if (!shown_.rules.empty() && sameScore(message, shown_)) return;
  message.header.stamp = stamp(time_);
  score_.publish(message);
  shown_ = message;
}

void UmpireNode::publishCall(UmpireCall message, double time)
{
  message.header.stamp = stamp(time);
  message.header.frame_id = "world";
  calls_.publish(message);
}

void UmpireNode::notice(const std::string& text)
{
  ROS_INFO_STREAM("umpire: " << text);
  publishCall(noticeOf(*umpire_, text), time_);
}
}  // namespace ping_pong_sim
