#include "handle_markers.h"

#include <cmath>

namespace ping_pong_sim
{
namespace
{
using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::Marker;

InteractiveMarker emptyHandle(const std::string& name, const FramePose& pose, double size)
{
  InteractiveMarker handle;
  handle.header.frame_id = "world";
  handle.name = name;
  handle.description = "";
  handle.pose = toMessage(pose);
  handle.scale = static_cast<float>(size);
  return handle;
}

Marker bead(double diameter, float r, float g, float b, float a)
{
  Marker marker;
  marker.type = Marker::SPHERE;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = diameter;
  marker.color.r = r;
  marker.color.g = g;
  marker.color.b = b;
  marker.color.a = a;
  return marker;
}

InteractiveMarkerControl beadControl(const Marker& marker)
{
  InteractiveMarkerControl control;
  control.name = "drag";
  control.interaction_mode = InteractiveMarkerControl::MOVE_3D;
  control.always_visible = false;
  control.orientation.w = 1.0;
  control.markers.push_back(marker);
  return control;
}

// RViz draws arrow and ring itself; they belong to the control's own x axis.
void addAxis(const Eigen::Vector3d& axis, const std::string& name, InteractiveMarker& handle)
{
  const Eigen::Quaterniond q = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), axis);
  InteractiveMarkerControl control;
  control.orientation = toMessage(FramePose{{}, q}).orientation;
  control.name = "move_" + name;
  control.interaction_mode = InteractiveMarkerControl::MOVE_AXIS;
  handle.controls.push_back(control);
  control.name = "turn_" + name;
  control.interaction_mode = InteractiveMarkerControl::ROTATE_AXIS;
  handle.controls.push_back(control);
}
}  // namespace

InteractiveMarker bodyHandle(const std::string& name, const FramePose& pose, double size)
{
  InteractiveMarker handle = emptyHandle(name, pose, size);
  addAxis(Eigen::Vector3d::UnitX(), "x", handle);
  addAxis(Eigen::Vector3d::UnitY(), "y", handle);
  addAxis(Eigen::Vector3d::UnitZ(), "z", handle);
  handle.controls.push_back(beadControl(bead(0.2 * size, 1.0f, 0.9f, 0.4f, 0.6f)));
  return handle;
}

InteractiveMarker ballHandle(const std::string& name, const FramePose& pose, double radius)
{
  InteractiveMarker handle = emptyHandle(name, {pose.p, Eigen::Quaterniond::Identity()}, 0.15);
  handle.controls.push_back(beadControl(bead(3.0 * radius, 1.0f, 0.9f, 0.4f, 0.3f)));
  return handle;
}

InteractiveMarker throwHandle(const std::string& name, const Eigen::Vector3d& p_W)
{
  InteractiveMarker handle = emptyHandle(name, {p_W, Eigen::Quaterniond::Identity()}, 0.15);
  handle.controls.push_back(beadControl(bead(0.035, 0.3f, 1.0f, 0.5f, 0.9f)));
  handle.controls.back().always_visible = true;
  return handle;
}

InteractiveMarker arrow(const std::string& name, const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W)
{
  InteractiveMarker handle = emptyHandle(name, {from_W, Eigen::Quaterniond::Identity()}, 0.15);
  InteractiveMarkerControl control;
  control.name = "look";
  control.interaction_mode = InteractiveMarkerControl::NONE;
  control.always_visible = true;
  control.orientation.w = 1.0;
  Marker marker = bead(0.0, 0.3f, 1.0f, 0.5f, 0.9f);
  marker.type = Marker::ARROW;
  marker.points = {toPointMessage(Eigen::Vector3d::Zero()), toPointMessage(to_W - from_W)};
  marker.scale.x = 0.008;  // shaft
  marker.scale.y = 0.02;   // head
  control.markers.push_back(marker);
  handle.controls.push_back(control);
  return handle;
}
}  // namespace ping_pong_sim
