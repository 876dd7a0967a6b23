#include "conversions.h"

#include <cmath>

namespace ping_pong_sim
{
namespace
{
constexpr double kLargestInput = 1e6;  ///< [m], [m/s], [rad/s], ...: beyond is a mistake, and squares must stay finite
constexpr double kSmallestQuaternion = 1e-3;  ///< shorter ones are taken for "not set"

ping_pong::Vector3d checked(double x, double y, double z, const std::string& field)
{
  return {checkedNumber(x, field + ".x"), checkedNumber(y, field + ".y"), checkedNumber(z, field + ".z")};
}

ping_pong::PaddleCommand::Mode fromMode(std::uint8_t mode)
{
  using Mode = ping_pong::PaddleCommand::Mode;
  switch (mode)
  {
    case PaddleCommand::HOLD:
      return Mode::Hold;
    case PaddleCommand::ACCELERATION:
      return Mode::Acceleration;
    case PaddleCommand::VELOCITY:
      return Mode::Velocity;
    case PaddleCommand::POSE:
      return Mode::Pose;
    default:
      throw InputError("mode: " + std::to_string(mode) + ": expected 0 (HOLD) to 3 (POSE)");
  }
}
}  // namespace

geometry_msgs::Point toPoint(const ping_pong::Vector3d& v)
{
  geometry_msgs::Point point;
  point.x = v.x();
  point.y = v.y();
  point.z = v.z();
  return point;
}

geometry_msgs::Vector3 toVector(const ping_pong::Vector3d& v)
{
  geometry_msgs::Vector3 vector;
  vector.x = v.x();
  vector.y = v.y();
  vector.z = v.z();
  return vector;
}

geometry_msgs::Quaternion toQuaternion(const ping_pong::Quaterniond& q)
{
  geometry_msgs::Quaternion quaternion;
  quaternion.x = q.x();
  quaternion.y = q.y();
  quaternion.z = q.z();
  quaternion.w = q.w();
  return quaternion;
}

geometry_msgs::Pose toPose(const ping_pong::Pose& pose)
{
  geometry_msgs::Pose message;
  message.position = toPoint(pose.p);
  message.orientation = toQuaternion(pose.q);
  return message;
}

geometry_msgs::Transform toTransform(const ping_pong::Pose& pose)
{
  geometry_msgs::Transform message;
  message.translation = toVector(pose.p);
  message.rotation = toQuaternion(pose.q);
  return message;
}

geometry_msgs::Twist toTwist(const ping_pong::Twist& twist)
{
  geometry_msgs::Twist message;
  message.linear = toVector(twist.v);
  message.angular = toVector(twist.w);
  return message;
}

std::uint8_t toMode(ping_pong::PaddleCommand::Mode mode)
{
  using Mode = ping_pong::PaddleCommand::Mode;
  switch (mode)
  {
    case Mode::Acceleration:
      return PaddleCommand::ACCELERATION;
    case Mode::Velocity:
      return PaddleCommand::VELOCITY;
    case Mode::Pose:
      return PaddleCommand::POSE;
    case Mode::Hold:
      break;
  }
  return PaddleCommand::HOLD;
}

PaddleCommand toCommand(const ping_pong::PaddleCommand& command)
{
  PaddleCommand message;
  message.header.frame_id = "world";
  message.mode = toMode(command.mode);
  message.pose = toPose(command.pose);
  message.twist = toTwist(command.twist);
  message.accel.linear = toVector(command.a_W);
  message.accel.angular = toVector(command.alpha_W);
  return message;
}

std_msgs::ColorRGBA toColor(const ping_pong::Color& color)
{
  std_msgs::ColorRGBA message;
  message.r = color.r;
  message.g = color.g;
  message.b = color.b;
  message.a = color.a;
  return message;
}

double checkedNumber(double value, const std::string& field)
{
  if (!std::isfinite(value)) throw InputError(field + ": " + std::to_string(value) + ": expected a finite number");
  if (std::abs(value) > kLargestInput)
  {
    throw InputError(field + ": " + std::to_string(value) + ": expected at most 1e6 in magnitude");
  }
  return value;
}

ping_pong::Vector3d fromPoint(const geometry_msgs::Point& p, const std::string& field)
{
  return checked(p.x, p.y, p.z, field);
}

ping_pong::Vector3d fromVector(const geometry_msgs::Vector3& v, const std::string& field)
{
  return checked(v.x, v.y, v.z, field);
}

ping_pong::Quaterniond fromQuaternion(const geometry_msgs::Quaternion& q, const std::string& field)
{
  const ping_pong::Vector3d xyz = checked(q.x, q.y, q.z, field);
  const ping_pong::Quaterniond quaternion(checkedNumber(q.w, field + ".w"), xyz.x(), xyz.y(), xyz.z());
  if (quaternion.norm() < kSmallestQuaternion)
  {
    throw InputError(field + ": zero quaternion: expected a rotation (w: 1 for none)");
  }
  return quaternion.normalized();
}

ping_pong::Pose fromPose(const geometry_msgs::Pose& pose, const std::string& field)
{
  ping_pong::Pose result;
  result.p = fromPoint(pose.position, field + ".position");
  result.q = fromQuaternion(pose.orientation, field + ".orientation");
  return result;
}

ping_pong::Twist fromTwist(const geometry_msgs::Twist& twist, const std::string& field)
{
  ping_pong::Twist result;
  result.v = fromVector(twist.linear, field + ".linear");
  result.w = fromVector(twist.angular, field + ".angular");
  return result;
}

ping_pong::Color fromColor(const std_msgs::ColorRGBA& color)
{
  for (const float channel : {color.r, color.g, color.b, color.a})
  {
    if (!(channel >= 0.0f && channel <= 1.0f)) throw InputError("color: expected four numbers from 0 to 1");
  }
  if (color.a == 0.0f) return {};
  return {color.r, color.g, color.b, color.a};
}

ping_pong::PaddleCommand fromCommand(const PaddleCommand& message)
{
  ping_pong::PaddleCommand command;
  command.mode = fromMode(message.mode);
  command.twist = fromTwist(message.twist, "twist");
  command.a_W = fromVector(message.accel.linear, "accel.linear");
  command.alpha_W = fromVector(message.accel.angular, "accel.angular");
  command.pose.p = fromPoint(message.pose.position, "pose.position");
  const geometry_msgs::Quaternion& q = message.pose.orientation;
  checked(q.x, q.y, q.z, "pose.orientation");
  checkedNumber(q.w, "pose.orientation.w");
  if (command.mode == ping_pong::PaddleCommand::Mode::Pose) command.pose = fromPose(message.pose, "pose");
  return command;
}

bool isWorldFrame(const std::string& frame_id)
{
  return frame_id.empty() || frame_id == "world";
}

ping_pong::Pose framePose(const ping_pong::World& world, const std::string& frame_id)
{
  if (isWorldFrame(frame_id)) return {};
  const std::size_t body = world.findBody(frame_id);
  if (body == ping_pong::kNone)
  {
    throw InputError("frame_id: " + frame_id + ": expected world or the name of a body");
  }
  return world.bodyPose(body);
}

ping_pong::Pose poseInWorld(const ping_pong::Pose& X_WF, const ping_pong::Pose& X_FB)
{
  ping_pong::Pose X_WB;
  X_WB.p = X_WF.p + X_WF.q * X_FB.p;
  X_WB.q = (X_WF.q * X_FB.q).normalized();
  return X_WB;
}

ping_pong::Twist twistInWorld(const ping_pong::Pose& X_WF, const ping_pong::Twist& twist_F)
{
  ping_pong::Twist twist_W;
  twist_W.v = X_WF.q * twist_F.v;
  twist_W.w = X_WF.q * twist_F.w;
  return twist_W;
}

ping_pong::PaddleCommand commandInWorld(const ping_pong::Pose& X_WF, const ping_pong::PaddleCommand& command_F)
{
  ping_pong::PaddleCommand command_W = command_F;
  command_W.pose = poseInWorld(X_WF, command_F.pose);
  command_W.twist = twistInWorld(X_WF, command_F.twist);
  command_W.a_W = X_WF.q * command_F.a_W;
  command_W.alpha_W = X_WF.q * command_F.alpha_W;
  return command_W;
}
}  // namespace ping_pong_sim
