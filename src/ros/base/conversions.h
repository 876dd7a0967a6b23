// Between messages and the plain structs of the physics. Whatever comes in is checked; whatever goes out is in SI and
// in W.
#pragma once

#include <geometry_msgs/Accel.h>
#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Twist.h>
#include <geometry_msgs/Vector3.h>
#include <std_msgs/ColorRGBA.h>

#include <stdexcept>
#include <string>

#include "ping_pong_sim/PaddleCommand.h"
#include "ping_pong_sim/world.h"

namespace ping_pong_sim
{
/// Input that is refused; what() is the reason.
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// --- Out ---
geometry_msgs::Point toPoint(const ping_pong::Vector3d& v);
geometry_msgs::Vector3 toVector(const ping_pong::Vector3d& v);
geometry_msgs::Quaternion toQuaternion(const ping_pong::Quaterniond& q);
geometry_msgs::Pose toPose(const ping_pong::Pose& pose);
geometry_msgs::Transform toTransform(const ping_pong::Pose& pose);
geometry_msgs::Twist toTwist(const ping_pong::Twist& twist);
std::uint8_t toMode(ping_pong::PaddleCommand::Mode mode);
/// In the world's frame.
PaddleCommand toCommand(const ping_pong::PaddleCommand& command);
std_msgs::ColorRGBA toColor(const ping_pong::Color& color);

// --- In. All throw InputError with the field's name for values that are not finite or beyond 1e6 ---
double checkedNumber(double value, const std::string& field);
ping_pong::Vector3d fromPoint(const geometry_msgs::Point& p, const std::string& field);
ping_pong::Vector3d fromVector(const geometry_msgs::Vector3& v, const std::string& field);
/// Normalises; throws if (nearly) zero.
ping_pong::Quaterniond fromQuaternion(const geometry_msgs::Quaternion& q, const std::string& field);
ping_pong::Pose fromPose(const geometry_msgs::Pose& pose, const std::string& field);
ping_pong::Twist fromTwist(const geometry_msgs::Twist& twist, const std::string& field);
/// Alpha 0: the default colour.
ping_pong::Color fromColor(const std_msgs::ColorRGBA& color);
/// The numbers of a command, still in the frame of its header. Checks all fields, the orientation only for mode POSE.
ping_pong::PaddleCommand fromCommand(const PaddleCommand& message);

// --- Frames ---
/// Is it "world" or empty?
bool isWorldFrame(const std::string& frame_id);
/// Where the frame is now: identity for world or empty, else the pose of the body of that name. Throws InputError.
ping_pong::Pose framePose(const ping_pong::World& world, const std::string& frame_id);
ping_pong::Pose poseInWorld(const ping_pong::Pose& X_WF, const ping_pong::Pose& X_FB);
ping_pong::Twist twistInWorld(const ping_pong::Pose& X_WF, const ping_pong::Twist& twist_F);
ping_pong::PaddleCommand commandInWorld(const ping_pong::Pose& X_WF, const ping_pong::PaddleCommand& command_F);
}  // namespace ping_pong_sim
