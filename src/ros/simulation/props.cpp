#include "props.h"

namespace ping_pong_sim
{
namespace
{
// Aims the x axis of a frame at a point; its y axis stays level.
ping_pong::Pose lookingAt(const ping_pong::Vector3d& p, const ping_pong::Vector3d& target)
{
  const ping_pong::Vector3d x = (target - p).normalized();
  const ping_pong::Vector3d y = ping_pong::Vector3d::UnitZ().cross(x).normalized();
  Eigen::Matrix3d axes;
  axes << x, y, x.cross(y);
  ping_pong::Pose pose;
  pose.p = p;
  pose.q = ping_pong::Quaterniond(axes);
  return pose;
}
}  // namespace

Props defaultProps()
{
  const ping_pong::Vector3d table(0.0, 0.0, 0.76);
  return {{"light", lookingAt({-0.6, 0.9, 3.2}, table)}, {"camera", lookingAt({-3.2, 0.4, 1.8}, table)}};
}

ping_pong::Pose propPose(const ping_pong::Vector3d& p, const ping_pong::Vector3d& rpy)
{
  using ping_pong::Vector3d;
  ping_pong::Pose pose;
  pose.p = p;
  pose.q = Eigen::AngleAxisd(rpy.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vector3d::UnitY()) *
           Eigen::AngleAxisd(rpy.x(), Vector3d::UnitX());
  return pose;
}

bool isShown(const ping_pong::World& world, const std::string& prop)
{
  return world.findBody(prop) == ping_pong::kNone;
}
}  // namespace ping_pong_sim
