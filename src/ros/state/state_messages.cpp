#include "state_messages.h"

#include "ros/base/conversions.h"

namespace ping_pong_sim
{
namespace
{
constexpr char kWorld[] = "world";
constexpr char kNewestBall[] = "newest_ball";

void setHeader(std_msgs::Header& header, const ros::Time& stamp)
{
  header.stamp = stamp;
  header.frame_id = kWorld;
}

void setFrame(geometry_msgs::TransformStamped& transform, const ros::Time& stamp, const std::string& child,
              const ping_pong::Pose& pose)
{
  setHeader(transform.header, stamp);
  transform.child_frame_id = child;
  transform.transform = toTransform(pose);
}
}  // namespace

std::string ballFrame(ping_pong::BallId id)
{
  return "ball_" + std::to_string(id);
}

void fillBalls(const Simulation& simulation, BallStates& message)
{
  const ping_pong::World& world = simulation.world();
  setHeader(message.header, simulation.clock().now());
  message.time = world.time();
  message.balls.resize(world.ballCount());
  for (std::size_t i = 0; i < world.ballCount(); ++i)
  {
    const ping_pong::BallState state = world.ballState(i);
    BallState& ball = message.balls[i];
    ball.id = world.ballId(i);
    ball.pose = toPose({state.p_WB, state.q_WB});
    ball.twist = toTwist({state.v_WB, state.w_WB});
    ball.radius = world.ballParams(i).radius;
    ball.resting = world.resting(i);
  }
}

void fillPaddles(const Simulation& simulation, PaddleStates& message)
{
  const ping_pong::World& world = simulation.world();
  setHeader(message.header, simulation.clock().now());
  message.time = world.time();
  message.paddles.resize(simulation.paddles().size());
  for (std::size_t i = 0; i < simulation.paddles().size(); ++i)
  {
    const PaddleControl& control = *simulation.paddles()[i];
    PaddleState& paddle = message.paddles[i];
    paddle.name = world.body(control.body()).name;
    paddle.pose = toPose(world.bodyPose(control.body()));
    paddle.twist = toTwist(world.bodyTwist(control.body()));
    paddle.mode = toMode(world.bodyCommand(control.body()).mode);
    paddle.command_age = control.commandAge(simulation.elapsed());
  }
}

void fillMovingFrames(const Simulation& simulation, tf2_msgs::TFMessage& message)
{
  const ping_pong::World& world = simulation.world();
  const ros::Time stamp = simulation.clock().now();
  const std::size_t balls = world.ballCount();
  message.transforms.resize(simulation.paddles().size() + simulation.ballsByName() + (balls > 0 ? 1 : 0));
  std::size_t next = 0;
  for (const auto& paddle : simulation.paddles())
  {
    setFrame(message.transforms[next++], stamp, world.body(paddle->body()).name, world.bodyPose(paddle->body()));
  }
  const auto setBall = [&](const std::string& frame, std::size_t i)
  {
    const ping_pong::BallState state = world.ballState(i);
    setFrame(message.transforms[next++], stamp, frame, {state.p_WB, state.q_WB});
  };
  for (std::size_t i = 0; i < simulation.ballsByName(); ++i) setBall(ballFrame(world.ballId(i)), i);
  if (balls > 0) setBall(kNewestBall, balls - 1);  // they are in the order of their ids
}

void fillStaticFrames(const Simulation& simulation, tf2_msgs::TFMessage& message)
{
  const ping_pong::World& world = simulation.world();
  message.transforms.clear();
  for (std::size_t i = 0; i < world.bodyCount(); ++i)
  {
    if (world.body(i).kind != ping_pong::BodyKind::Static) continue;
    message.transforms.emplace_back();
    setFrame(message.transforms.back(), simulation.clock().now(), world.body(i).name, world.bodyPose(i));
  }
  for (const auto& prop : simulation.props())
  {
    if (!isShown(world, prop.first)) continue;
    message.transforms.emplace_back();
    setFrame(message.transforms.back(), simulation.clock().now(), prop.first, prop.second);
  }
}

Contact toContact(const Simulation& simulation, const ping_pong::Contact& contact)
{
  Contact message;
  setHeader(message.header, simulation.stampOf(contact));
  message.time = contact.time;
  message.ball = contact.ball;
  message.with_ball = contact.with_ball;
  message.other_ball = contact.with_ball ? contact.other_ball : 0;
  message.other = contact.with_ball ? ballFrame(contact.other_ball) : simulation.world().body(contact.body).name;
  message.shape = contact.with_ball ? -1 : static_cast<int>(contact.shape);
  message.point = toPoint(contact.p_WC);
  message.normal = toVector(contact.n_W);
  message.velocity_before = toVector(contact.v_before);
  message.velocity_after = toVector(contact.v_after);
  message.spin_before = toVector(contact.w_before);
  message.spin_after = toVector(contact.w_after);
  message.velocity_other = toVector(contact.v_other);
  message.impulse = toVector(contact.impulse);
  return message;
}
}  // namespace ping_pong_sim
