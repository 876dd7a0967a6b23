#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "game/court.h"

namespace ping_pong::game
{
namespace
{
[[noreturn]] void refuse(const Scene& scene, const std::string& why)
{
  throw std::invalid_argument("scene '" + scene.name + "': " + why);
}

const std::string& materialOf(const Scene& scene, const Shape& shape)
{
  static const std::string kUnnamed = "unnamed part";
  return shape.material < scene.materials.size() ? scene.materials[shape.material] : kUnnamed;
}

Matrix3d axesInWorld(const Body& body, const Shape& shape)
{
  return body.pose.q.toRotationMatrix() * shape.R_BS;
}

struct Top
{
  std::size_t body = kNone;
  std::size_t shape = kNone;
  double area = 0.0;
};

// Area of the face of a box that looks up.
double areaOfTop(const Matrix3d& R_WS, const Vector3d& half)
{
  int up = 0;
  R_WS.row(2).cwiseAbs().maxCoeff(&up);
  return 4.0 * half[(up + 1) % 3] * half[(up + 2) % 3];
}

Top findTop(const Scene& scene)
{
  Top top;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    for (std::size_t s = 0; s < scene.bodies[b].shapes.size(); ++s)
    {
      const Body& body = scene.bodies[b];
      const Shape& shape = body.shapes[s];
      if (body.kind != BodyKind::Static || shape.kind != ShapeKind::Box || materialOf(scene, shape) != "table")
        continue;
      if (top.body != kNone && top.body != b)
        refuse(scene, "two tables, '" + scene.bodies[top.body].name + "' and '" + body.name + "': a match needs one");
      const double area = areaOfTop(axesInWorld(body, shape), shape.half_size);
      if (area > top.area) top = {b, s, area};
    }
  if (top.body == kNone)
    refuse(scene, "no table: a match needs a static body with a box of material 'table', as urdf/table.urdf");
  return top;
}

// Pose and size of the upper face: x along its length.
void layFrame(const Body& body, const Shape& shape, Court& court)
{
  const Matrix3d R_WS = axesInWorld(body, shape);
  int up = 0;
  R_WS.row(2).cwiseAbs().maxCoeff(&up);
  int along = (up + 1) % 3;
  int across = (up + 2) % 3;
  if (shape.half_size[along] < shape.half_size[across]) std::swap(along, across);
  const Vector3d z_W = (R_WS(2, up) < 0.0 ? -1.0 : 1.0) * R_WS.col(up);
  Vector3d x_W = R_WS.col(along);
  const bool turned = std::abs(x_W.x()) > 1e-9 ? x_W.x() < 0.0 : x_W.y() < 0.0;
  if (turned) x_W = -x_W;
  Matrix3d R_WT;
  R_WT << x_W, z_W.cross(x_W), z_W;
  court.half_length = shape.half_size[along];
  court.half_width = shape.half_size[across];
  court.X_WT.q = Quaterniond(R_WT).normalized();
  court.X_WT.p = body.pose.p + body.pose.q * shape.p_BS + shape.half_size[up] * z_W;
  court.X_WB = body.pose;
  court.X_BT.q = (body.pose.q.conjugate() * court.X_WT.q).normalized();
  court.X_BT.p = body.pose.toB(court.X_WT.p);
}

void giveRoles(const Scene& scene, const Top& top, Court& court)
{
  court.roles.resize(scene.bodies.size());
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    for (std::size_t s = 0; s < scene.bodies[b].shapes.size(); ++s)
    {
      const Body& body = scene.bodies[b];
      Court::ShapeRole role;
      role.name = materialOf(scene, body.shapes[s]);
      if (body.kind == BodyKind::Kinematic)
        role.part = Part::Racket;
      else if (b == top.body && s == top.shape)
        role.part = Part::Court;
      else if (role.name == "net" || role.name == "post")
        role.part = Part::Net;
      court.roles[b].push_back(role);
    }
}

/// How far a shape goes along an axis of T, from the origin of T [m].
double extent(const Court& court, const Body& body, const Shape& shape, const Vector3d& axis_T)
{
  const Vector3d axis_W = court.X_WT.q * axis_T;
  return supportDistance(shape, body.pose.q.conjugate() * axis_W) + axis_W.dot(body.pose.p - court.X_WT.p);
}

void measureNet(const Scene& scene, Court& court)
{
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    for (std::size_t s = 0; s < scene.bodies[b].shapes.size(); ++s)
    {
      const Court::ShapeRole& role = court.roles[b][s];
      if (role.part != Part::Net) continue;
      const auto reach = [&](const Vector3d& axis_T)
      { return extent(court, scene.bodies[b], scene.bodies[b].shapes[s], axis_T); };
      court.net_reach = std::max({court.net_reach, reach(Vector3d::UnitX()), reach(-Vector3d::UnitX())});
      if (role.name != "net") continue;
      court.net_height = std::max(court.net_height, reach(Vector3d::UnitZ()));
      court.net_half_width = std::max({court.net_half_width, reach(Vector3d::UnitY()), reach(-Vector3d::UnitY())});
    }
  if (court.net_height <= 0.0)
    refuse(scene, "no net: a match needs a static shape of material 'net' above the table, as in urdf/table.urdf");
}

void findRackets(const Scene& scene, Court& court)
{
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
  {
    if (scene.bodies[b].kind != BodyKind::Kinematic) continue;
    const End end = court.positionInT(scene.bodies[b].pose.p).x() < 0.0 ? End::Minus : End::Plus;
    std::size_t& racket = court.racket[index(end)];
    if (racket != kNone)
      refuse(scene, "two paddles, '" + scene.bodies[racket].name + "' and '" + scene.bodies[b].name +
                        "', start at the " + name(end) + " end: a match needs one at each");
    racket = b;
    for (const Shape& shape : scene.bodies[b].shapes)
    {
      double& reach = court.racket_reach[index(end)];
      reach = std::max(reach, shape.p_BS.norm() + boundingRadius(shape));
    }
  }
  for (const End end : {End::Minus, End::Plus})
    if (court.racket[index(end)] == kNone)
      refuse(scene,
             std::string("no paddle starts at the ") + name(end) + " end of the table: a match needs one at each");
}
}  // namespace

Court findCourt(const Scene& scene)
{
  Court court;
  const Top top = findTop(scene);
  court.table = top.body;
  layFrame(scene.bodies[top.body], scene.bodies[top.body].shapes[top.shape], court);
  giveRoles(scene, top, court);
  measureNet(scene, court);
  findRackets(scene, court);
  return court;
}
}  // namespace ping_pong::game
