#include "player_node.h"

#include "ping_pong_sim/PaddleCommand.h"
#include "ping_pong_sim/scene_loader.h"
#include "plan_markers.h"
#include "ros/base/conversions.h"
#include "teleop/sim_link.h"

namespace ping_pong_sim
{
namespace play = ping_pong::play;

namespace
{
constexpr double kPatience = 3.0;     ///< for the umpire's answer [s]
constexpr double kAskAgain = 0.5;     ///< after a refusal [s]
constexpr double kTossHeight = 0.3;   ///< the law asks for 0.16 [m]
constexpr double kLongestTick = 0.1;  ///< between two messages; longer is a pause or a reset [s]
}  // namespace

PlayerNode::PlayerNode(ros::NodeHandle& nh, ros::NodeHandle& private_nh, const PlayerNodeParams& params)
    : params_(params), scene_(ping_pong::loadScene(params.scene_path))
{
  makePlayer();
  commands_ = nh.advertise<PaddleCommand>(params_.paddle + "/command", 1);
  if (params_.show_plan) plan_ = private_nh.advertise<visualization_msgs::MarkerArray>("plan", 1);
  const ros::TransportHints fast = ros::TransportHints().tcpNoDelay();
  paddles_ = nh.subscribe("paddles", 1, &PlayerNode::onPaddles, this, fast);
  balls_ = nh.subscribe("balls", 1, &PlayerNode::onBalls, this, fast);
  score_topic_ = nh.subscribe("score", 10, &PlayerNode::onScore, this, fast);
  level_topic_ = nh.subscribe("player_level", 1, &PlayerNode::onLevel, this);
  asker_.start([] {});
}

// At the end where the paddle starts.
void PlayerNode::makePlayer()
{
  play::PlayerParams p;
  p.paddle = params_.paddle;
  p.level = params_.level;
  p.style = params_.style;
  p.seed = params_.seed;
  p.end = play::endOfPaddle(scene_, params_.paddle);
  player_ = std::make_unique<play::Player>(scene_, p);
}

void PlayerNode::onPaddles(const PaddleStates& message)
{
  for (const PaddleState& paddle : message.paddles)
  {
    if (paddle.name != params_.paddle) continue;
    now_.pose = fromPose(paddle.pose, "pose");
    now_.twist = fromTwist(paddle.twist, "twist");
    paddle_time_ = message.time;
  }
  act();
}

void PlayerNode::onBalls(const BallStates& message)
{
  const double since = message.time - now_.time;
  if (since < 0.0 || since > 1.0) player_->reset();  // another time: the world was reset, or the player stood still
  if (since > 0.0 && since < kLongestTick) now_.tick = since;
  now_.time = message.time;
  watchNewest(message);
  act();
}

// The ball in play is the newest: others lie about.
void PlayerNode::watchNewest(const BallStates& message)
{
  now_.balls.clear();
  if (message.balls.empty()) return;
  const BallState& ball = message.balls.back();  // they are ordered by id
  if (ball.id != ball_) player_->reset();
  ball_ = ball.id;
  now_.balls.push_back({ball.id, fromPoint(ball.pose.position, "position"), fromVector(ball.twist.linear, "linear"),
                        fromVector(ball.twist.angular, "angular")});
}

// Once both have come for the same instant.
void PlayerNode::act()
{
  if (paddle_time_ != now_.time) return;
  now_.to_serve = serves();
  commands_.publish(toCommand(player_->update(now_)));
  showPlan();
}

void PlayerNode::onScore(const Score& message)
{
  score_ = message;
  const bool mine = message.paddles[message.server == 0 ? 0 : 1] == params_.paddle;
  const bool between =
      message.state == "before service" || message.state == "rally over" || message.state == "game over";
  const bool turn = mine && between && message.winner < 0;
  if (turn && !turn_) turn_since_ = now_.time;
  turn_ = turn;
}

bool PlayerNode::serves() const
{
  if (!score_ || score_->paddles[score_->server == 0 ? 0 : 1] != params_.paddle) return false;
  return turn_ || score_->state == "in hand" || score_->state == "toss";
}

void PlayerNode::onLevel(const std_msgs::UInt8& message)
{
  if (message.data == params_.level) return;
  if (message.data < play::kLowestLevel || message.data > play::kHighestLevel)
  {
    ROS_WARN_STREAM("player_level: " << static_cast<int>(message.data) << ": expected 1 to 5; stays at "
                                     << params_.level);
    return;
  }
  params_.level = message.data;
  makePlayer();
}

void PlayerNode::update()
{
  if (!turn_ || asking_ || now_.time - turn_since_ < params_.serve_after || wallSeconds() - last_wall_ < kAskAgain)
    return;
  last_wall_ = wallSeconds();
  Toss exchange;
  exchange.request.position = toPoint(player_->toss().p_WB);
  exchange.request.height = kTossHeight;
  asking_ = true;
  asker_.post([this, exchange] { ask(exchange); });
}

// In a thread of its own: the simulator may wait for this player's command before it gives anybody a ball.
void PlayerNode::ask(Toss exchange)
{
  if (!toss_.isValid()) toss_ = ros::NodeHandle().serviceClient<Toss>(params_.umpire + "/toss");
  const bool answered = deadline_.run(
      kPatience, [&] { return toss_.call(exchange); }, [this] { toss_.shutdown(); });
  if (answered && !exchange.response.success)
    ROS_DEBUG_STREAM("the umpire gives no ball: " << exchange.response.message);
  asking_ = false;
}

void PlayerNode::showPlan()
{
  if (plan_ && plan_.getNumSubscribers() > 0) plan_.publish(planMarkers(*player_, now_.time));
}
}  // namespace ping_pong_sim
