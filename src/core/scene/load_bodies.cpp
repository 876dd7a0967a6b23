#include "scene/load_bodies.h"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "ping_pong_sim/room.h"
#include "ping_pong_sim/scene_loader.h"
#include "scene/materials.h"

namespace ping_pong
{
namespace
{
constexpr char kFloor[] = "floor";
constexpr char kWall[] = "wall";

bool isLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool isDigit(char c)
{
  return c >= '0' && c <= '9';
}

/// Letters, digits and _, a letter first: valid as a TF frame and as part of a topic.
bool isFrameName(const std::string& name)
{
  for (const char c : name)
    if (!isLetter(c) && !isDigit(c) && c != '_') return false;
  return !name.empty() && isLetter(name[0]);
}

/// Frames that the simulator itself publishes: world, newest_ball and ball_0, ball_1, ...
bool isReservedFrame(const std::string& name)
{
  const std::string prefix = "ball_";
  if (name == "world" || name == "newest_ball") return true;
  return name.size() > prefix.size() && name.compare(0, prefix.size(), prefix) == 0 &&
         name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
}

std::string readName(const Field& field, const std::vector<Body>& earlier)
{
  const std::string name = field.text();
  if (!isFrameName(name)) field.fail("a frame name of letters, digits and _ that starts with a letter");
  if (isReservedFrame(name))
    field.fail("a name other than world, newest_ball and ball_N, which the simulator uses itself");
  for (const Body& body : earlier)
    if (body.name == name) field.fail("a name that no other body has");
  return name;
}

BodyKind readKind(const Field& field)
{
  const std::string kind = field.text();
  if (kind == "static") return BodyKind::Static;
  if (kind == "kinematic") return BodyKind::Kinematic;
  field.fail("static or kinematic");
}

/// URDF convention: roll about x, then pitch about y, then yaw about z, all about fixed axes.
Quaterniond fromRollPitchYaw(const Vector3d& rpy)
{
  const Quaterniond q = Eigen::AngleAxisd(rpy.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vector3d::UnitY()) *
                        Eigen::AngleAxisd(rpy.x(), Vector3d::UnitX());
  return q.normalized();
}

DriveLimits readLimits(const Field& field)
{
  const Map map(field, {"speed", "acceleration", "angular_speed", "angular_acceleration"});
  DriveLimits limits;
  if (const Field* f = map.find("speed")) limits.speed = f->positiveOrInfinite();
  if (const Field* f = map.find("acceleration")) limits.acceleration = f->positiveOrInfinite();
  if (const Field* f = map.find("angular_speed")) limits.angular_speed = f->positiveOrInfinite();
  if (const Field* f = map.find("angular_acceleration")) limits.angular_acceleration = f->positiveOrInfinite();
  return limits;
}

/// How a paddle starts: a velocity or an angular velocity that its drive can have.
Vector3d readStart(const Field& field, BodyKind kind, double limit, const std::string& unit)
{
  if (kind != BodyKind::Kinematic) field.fail("no motion unless the kind is kinematic");
  const Vector3d start = field.vector();
  if (start.norm() > limit)
    field.fail("at most " + numberText(limit) + " " + unit + ", what the limits of the body allow");
  return start;
}

std::string resolveUrdf(const Field& field, const std::string& scene_path)
{
  const std::filesystem::path folder = std::filesystem::path(scene_path).parent_path();
  const std::string path = (folder / field.text()).lexically_normal().string();
  try
  {
    readFile(path);
  }
  catch (const std::runtime_error& error)
  {
    field.fail("a readable URDF file, but " + path + ": " + error.what());
  }
  return path;
}

/// Factors of the edges of a room for so many times the balls: the balls fill the same part of it.
Vector3d readGrowth(const Field& field, double growth)
{
  const std::string kind = field.text();
  if (kind == "all") return Vector3d::Constant(std::cbrt(growth));
  if (kind == "floor") return {std::sqrt(growth), std::sqrt(growth), 1.0};
  field.fail("all (length, width and height) or floor (length and width)");
}

std::vector<Shape> readRoom(const Field& field, double growth, std::vector<std::string>& materials)
{
  const Map map(field, {"size", "grow", "material"});
  const std::string three = "the inner size [x, y, z], three numbers > 0";
  const std::vector<Field> edges = map.at("size", three).list(3, three);
  Vector3d size(edges[0].positive(), edges[1].positive(), edges[2].positive());
  if (const Field* f = map.find("grow")) size = size.cwiseProduct(readGrowth(*f, growth));
  const Field* material = map.find("material");
  return roomShapes(size, internMaterial(materials, material != nullptr ? readMaterial(*material) : kWall));
}

Body readBody(const Field& field, double growth, Scene& scene)
{
  const Map map(field, {"name", "urdf", "room", "kind", "position", "rpy", "velocity", "angular_velocity", "limits"});
  Body body;
  body.name = readName(map.at("name", "the name of the body"), scene.bodies);
  body.kind = readKind(map.at("kind", "static or kinematic"));
  if (const Field* f = map.find("position")) body.pose.p = f->vector();
  if (const Field* f = map.find("rpy")) body.pose.q = fromRollPitchYaw(f->vector());
  const Field* limits = map.find("limits");
  if (limits != nullptr && body.kind != BodyKind::Kinematic) limits->fail("no limits unless the kind is kinematic");
  if (limits != nullptr) body.limits = readLimits(*limits);
  if (const Field* f = map.find("velocity")) body.twist.v = readStart(*f, body.kind, body.limits.speed, "m/s");
  if (const Field* f = map.find("angular_velocity"))
    body.twist.w = readStart(*f, body.kind, body.limits.angular_speed, "rad/s");
  if (const Field* room = map.find("room"))
  {
    if (const Field* f = map.find("urdf")) f->failWith("beside room", "either a urdf or a room");
    if (body.kind != BodyKind::Static) room->fail("no room unless the kind is static");
    body.shapes = readRoom(*room, growth, scene.materials);
    return body;
  }
  body.urdf_path = resolveUrdf(map.at("urdf", "the path of a URDF file"), scene.path);
  body.shapes = loadShapes(body.urdf_path, scene.materials);
  return body;
}

Body readFloor(const Field& field, Scene& scene)
{
  const Map map(field, {"height", "material"});
  for (const Body& body : scene.bodies)
    if (body.name == kFloor) field.fail("no body of the name floor beside it");
  Body floor;
  floor.name = kFloor;
  if (const Field* f = map.find("height")) floor.pose.p.z() = f->number();
  const Field* material = map.find("material");
  Shape shape;
  shape.kind = ShapeKind::HalfSpace;
  shape.material = internMaterial(scene.materials, material != nullptr ? readMaterial(*material) : kFloor);
  floor.shapes.push_back(shape);
  return floor;
}
}  // namespace

std::string readMaterial(const Field& field)
{
  const std::string name = field.text();
  if (name == kAnyMaterial) field.fail("the name of a material; any stands for all of them");
  return name;
}

void readBodies(const Map& scene_map, double growth, Scene& scene)
{
  if (const Field* bodies = scene_map.find("bodies"))
    for (const Field& field : bodies->list()) scene.bodies.push_back(readBody(field, growth, scene));
  if (const Field* floor = scene_map.find("floor")) scene.bodies.push_back(readFloor(*floor, scene));
}
}  // namespace ping_pong
