#include "body_markers.h"

#include <ros/console.h>
#include <urdf_parser/urdf_parser.h>

#include <fstream>
#include <optional>
#include <sstream>

#include "ping_pong_sim/room.h"
#include "ros/base/conversions.h"
#include "soft_shadow.h"

namespace ping_pong_sim
{
namespace
{
using visualization_msgs::Marker;

constexpr double kEdgeWidth = 0.01;  ///< of the lines that show a room [m]
/// 12 m of the infinite floor, lit in the middle.
constexpr char kFloorMesh[] = "package://ping_pong_sim/meshes/floor.dae";

void setScale(Marker& marker, double x, double y, double z)
{
  marker.scale.x = x;
  marker.scale.y = y;
  marker.scale.z = z;
}

void setColor(Marker& marker, float r, float g, float b, float a)
{
  marker.color.r = r;
  marker.color.g = g;
  marker.color.b = b;
  marker.color.a = a;
}

// RViz reads package:// and file://; anything else is taken relative to the URDF.
std::string meshUrl(const std::string& name, const std::string& urdf_path)
{
  if (name.find("://") != std::string::npos) return name;
  return name[0] == '/' ? "file://" + name : "file://" + urdf_path.substr(0, urdf_path.rfind('/') + 1) + name;
}

bool setGeometry(const urdf::Geometry& geometry, const std::string& urdf_path, Marker& marker)
{
  if (const auto* box = dynamic_cast<const urdf::Box*>(&geometry))
  {
    marker.type = Marker::CUBE;
    setScale(marker, box->dim.x, box->dim.y, box->dim.z);
  }
  else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&geometry))
  {
    marker.type = Marker::CYLINDER;
    setScale(marker, 2.0 * cylinder->radius, 2.0 * cylinder->radius, cylinder->length);
  }
  else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(&geometry))
  {
    marker.type = Marker::SPHERE;
    setScale(marker, 2.0 * sphere->radius, 2.0 * sphere->radius, 2.0 * sphere->radius);
  }
  else if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(&geometry))
  {
    marker.type = Marker::MESH_RESOURCE;
    marker.mesh_resource = meshUrl(mesh->filename, urdf_path);
    setScale(marker, mesh->scale.x, mesh->scale.y, mesh->scale.z);
  }
  else
  {
    return false;
  }
  return true;
}

void setPose(const urdf::Pose& origin, Marker& marker)
{
  marker.pose.position.x = origin.position.x;
  marker.pose.position.y = origin.position.y;
  marker.pose.position.z = origin.position.z;
  origin.rotation.getQuaternion(marker.pose.orientation.x, marker.pose.orientation.y, marker.pose.orientation.z,
                                marker.pose.orientation.w);
}

void setMaterial(const urdf::Visual& visual, const urdf::ModelInterface& model, Marker& marker)
{
  urdf::MaterialConstSharedPtr material = visual.material;
  if (!material) material = model.getMaterial(visual.material_name);
  if (material)
    setColor(marker, material->color.r, material->color.g, material->color.b, material->color.a);
  else if (marker.type == Marker::MESH_RESOURCE)
    marker.mesh_use_embedded_materials = true;
  else
    setColor(marker, 0.7f, 0.7f, 0.7f, 1.0f);
}

Marker floorPicture(const std::string& frame)
{
  Marker floor = makeMarker(frame, frame, 0, Marker::MESH_RESOURCE);
  floor.frame_locked = true;
  floor.mesh_resource = kFloorMesh;
  floor.mesh_use_embedded_materials = true;
  setScale(floor, 1.0, 1.0, 1.0);
  return floor;
}
/// The edges of a room: its walls would hide what is inside.
Marker roomPicture(const std::string& frame, const ping_pong::Vector3d& size)
{
  Marker room = makeMarker(frame, frame, 0, Marker::LINE_LIST);
  room.frame_locked = true;
  setScale(room, kEdgeWidth, 0.0, 0.0);
  setColor(room, 0.62f, 0.80f, 0.92f, 1.0f);
  const auto corner = [&](int bits)
  {
    return toPoint({(bits & 1 ? 0.5 : -0.5) * size.x(), (bits & 2 ? 0.5 : -0.5) * size.y(), bits & 4 ? size.z() : 0.0});
  };
  for (int from = 0; from < 8; ++from)
    for (const int axis : {1, 2, 4})
    {
      if (from & axis) continue;
      room.points.push_back(corner(from));
      room.points.push_back(corner(from | axis));
    }
  return room;
}
}  // namespace

std::string readText(const std::string& path)
{
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void appendBody(const ping_pong::Body& body, Markers& markers)
{
  if (body.urdf_path.empty())
  {
    const std::optional<ping_pong::Vector3d> room = ping_pong::roomSize(body);
    markers.push_back(room ? roomPicture(body.name, *room) : floorPicture(body.name));
    return;
  }
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(readText(body.urdf_path));
  if (!model || !model->getRoot())
  {
    ROS_WARN_STREAM(body.urdf_path << ": no picture of body " << body.name);
    return;
  }
  int id = 0;
  for (const urdf::VisualSharedPtr& visual : model->getRoot()->visual_array)
  {
    Marker marker = makeMarker(body.name, body.name, id++, Marker::CUBE);
    marker.frame_locked = true;
    setPose(visual->origin, marker);
    if (!visual->geometry || !setGeometry(*visual->geometry, body.urdf_path, marker)) continue;
    setMaterial(*visual, *model, marker);
    if (visual->material_name == kSoftShadow && marker.type == Marker::CUBE) makeSoft(marker);
    markers.push_back(marker);
  }
}
}  // namespace ping_pong_sim
