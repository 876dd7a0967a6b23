#include "blob_shadows.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ros/base/conversions.h"

namespace ping_pong_sim
{
namespace
{
using ping_pong::Vector3d;

constexpr std::size_t kMost = 1000;      ///< discs; more cost RViz more than the balls themselves
constexpr std::size_t kFewBalls = 50;    ///< so many have discs of twelve corners; more of six
constexpr double kGap = 0.0015;          ///< above the surface, so that both do not flicker [m]
constexpr double kHighest = 1.0;         ///< above the plate; from higher a shadow would be a blur [m]
constexpr double kLevel = 0.999;         ///< cosine of the slope up to which a plate counts as level
constexpr double kSmallestPlate = 0.05;  ///< area of plates that shadows are drawn on [m^2]
constexpr float kDarkness = 0.45f;

/// The upper side of a level box, or all of the floor.
struct Plate
{
  double height;          ///< [m]
  Vector3d centre_W;      ///< [m]
  Vector3d x_W, y_W;      ///< along its edges
  double half_x, half_y;  ///< [m]

  bool covers(const Vector3d& p_W) const
  {
    const Vector3d away = p_W - centre_W;
    return std::abs(away.dot(x_W)) <= half_x && std::abs(away.dot(y_W)) <= half_y;
  }
};

std::optional<Plate> plateOf(const ping_pong::Shape& shape, const ping_pong::Pose& X_WB)
{
  const Eigen::Matrix3d R_WS = X_WB.q * shape.R_BS;
  const Vector3d p_WS = X_WB.p + X_WB.q * shape.p_BS;
  if (shape.kind == ping_pong::ShapeKind::HalfSpace && R_WS(2, 2) >= kLevel)
    return Plate{p_WS.z(), p_WS, Vector3d::UnitX(), Vector3d::UnitY(), HUGE_VAL, HUGE_VAL};
  const Vector3d& half = shape.half_size;
  if (shape.kind != ping_pong::ShapeKind::Box || R_WS(2, 2) < kLevel) return std::nullopt;
  if (4.0 * half.x() * half.y() < kSmallestPlate) return std::nullopt;
  return Plate{p_WS.z() + half.z(), p_WS, R_WS.col(0), R_WS.col(1), half.x(), half.y()};
}

/// The highest first.
std::vector<Plate> platesOf(const ping_pong::World& world)
{
  std::vector<Plate> plates;
  for (std::size_t i = 0; i < world.bodyCount(); ++i)
  {
    if (world.body(i).kind != ping_pong::BodyKind::Static) continue;
    for (const ping_pong::Shape& shape : world.body(i).shapes)
    {
      if (const std::optional<Plate> plate = plateOf(shape, world.bodyPose(i))) plates.push_back(*plate);
    }
  }
  std::sort(plates.begin(), plates.end(), [](const Plate& a, const Plate& b) { return a.height > b.height; });
  return plates;
}

void appendDisc(const Vector3d& centre, double radius, int corners, visualization_msgs::Marker& marker)
{
  const auto corner = [&](int i)
  {
    const double angle = 2.0 * M_PI * i / corners;
    return toPoint(centre + radius * Vector3d(std::cos(angle), std::sin(angle), 0.0));
  };
  for (int i = 1; i + 1 < corners; ++i)  // as few triangles as possible: they are what costs RViz time
  {
    marker.points.push_back(corner(0));
    marker.points.push_back(corner(i));
    marker.points.push_back(corner(i + 1));
  }
}
}  // namespace

visualization_msgs::Marker blobShadows(const Simulation& simulation, const Vector3d& light_W)
{
  using visualization_msgs::Marker;
  const ping_pong::World& world = simulation.world();
  Marker marker = makeMarker("world", "shadows", 0, Marker::TRIANGLE_LIST);
  marker.header.stamp = simulation.clock().now();
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color.a = kDarkness;
  const std::vector<Plate> plates = platesOf(world);
  const int corners = world.ballCount() > kFewBalls ? 6 : 12;
  for (std::size_t i = 0; i < std::min(world.ballCount(), kMost); ++i)
  {
    const Vector3d p_W = world.ballState(i).p_WB;
    const Vector3d ray = p_W - light_W;
    if (ray.z() >= 0.0) continue;  // lit from below
    for (const Plate& plate : plates)
    {
      if (plate.height > p_W.z()) continue;
      const double reach = (plate.height + kGap - light_W.z()) / ray.z();  // 1 at the ball
      const Vector3d centre = light_W + reach * ray;
      if (!plate.covers(centre)) continue;
      if (p_W.z() - plate.height < kHighest) appendDisc(centre, reach * world.ballParams(i).radius, corners, marker);
      break;
    }
  }
  if (marker.points.empty()) marker.action = Marker::DELETE;
  return marker;
}
}  // namespace ping_pong_sim
