// Between Eigen and messages, for the clients of the simulator.
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Vector3.h>

#include <Eigen/Geometry>

namespace ping_pong_sim
{
struct FramePose
{
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
};

inline Eigen::Vector3d fromMessage(const geometry_msgs::Vector3& v)
{
  return {v.x, v.y, v.z};
}

inline Eigen::Vector3d fromMessage(const geometry_msgs::Point& p)
{
  return {p.x, p.y, p.z};
}

inline FramePose fromMessage(const geometry_msgs::Pose& pose)
{
  const geometry_msgs::Quaternion& q = pose.orientation;
  return {fromMessage(pose.position), {q.w, q.x, q.y, q.z}};
}

inline geometry_msgs::Vector3 toVectorMessage(const Eigen::Vector3d& v)
{
  geometry_msgs::Vector3 message;
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

inline geometry_msgs::Point toPointMessage(const Eigen::Vector3d& p)
{
  geometry_msgs::Point message;
  message.x = p.x();
  message.y = p.y();
  message.z = p.z();
  return message;
}

inline geometry_msgs::Pose toMessage(const FramePose& pose)
{
  geometry_msgs::Pose message;
  message.position = toPointMessage(pose.p);
  message.orientation.x = pose.q.x();
  message.orientation.y = pose.q.y();
  message.orientation.z = pose.q.z();
  message.orientation.w = pose.q.w();
  return message;
}
}  // namespace ping_pong_sim
