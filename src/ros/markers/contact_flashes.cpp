#include "contact_flashes.h"

#include <cmath>

#include "ros/base/conversions.h"

namespace ping_pong_sim
{
namespace
{
using ping_pong::Vector3d;

constexpr double kLife = 0.5;           ///< simulated time that a flash is seen [s]
constexpr double kSmallRadius = 0.012;  ///< of the disc at the impact [m]
constexpr double kLargeRadius = 0.035;  ///< at the end [m]
constexpr double kGap = 0.0015;         ///< above the surface, so that both do not flicker [m]
constexpr double kSlowest = 0.15;       ///< change of normal speed below which nothing is shown [m/s]
constexpr std::size_t kMost = 100;
constexpr int kCorners = 12;
}  // namespace

void ContactFlashes::observe(const Simulation& simulation)
{
  const double now = simulation.elapsed();
  const ping_pong::World& world = simulation.world();
  for (const ping_pong::Contact& contact : world.contacts())
  {
    if (std::abs((contact.v_after - contact.v_before).dot(contact.n_W)) < kSlowest) continue;
    flashes_.push_back({now - (world.time() - contact.time), contact.p_WC, contact.n_W});
  }
  while (!flashes_.empty() && (flashes_.size() > kMost || now - flashes_.front().time > kLife)) flashes_.pop_front();
}

visualization_msgs::Marker ContactFlashes::marker(const Simulation& simulation) const
{
  using visualization_msgs::Marker;
  Marker marker = makeMarker("world", "contacts", 0, Marker::TRIANGLE_LIST);
  marker.header.stamp = simulation.clock().now();
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color.a = 1.0f;
  for (const Flash& flash : flashes_) appendDisc(flash, (simulation.elapsed() - flash.time) / kLife, marker);
  if (marker.points.empty()) marker.action = Marker::DELETE;
  return marker;
}

/// @param age  0 to 1
void ContactFlashes::appendDisc(const Flash& flash, double age, visualization_msgs::Marker& marker)
{
  const Vector3d t1 = flash.n_W.unitOrthogonal();
  const Vector3d t2 = flash.n_W.cross(t1);
  const Vector3d centre = flash.p_W + kGap * flash.n_W;
  const double radius = kSmallRadius + (kLargeRadius - kSmallRadius) * age;
  std_msgs::ColorRGBA color;
  color.r = 1.0f;
  color.g = 0.95f;
  color.b = 0.5f;
  color.a = static_cast<float>(0.9 * (1.0 - age));
  const auto corner = [&](int i)
  {
    const double angle = 2.0 * M_PI * i / kCorners;
    return toPoint(centre + radius * (std::cos(angle) * t1 + std::sin(angle) * t2));
  };
  for (int i = 0; i < kCorners; ++i)
  {
    marker.points.push_back(toPoint(centre));
    marker.points.push_back(corner(i));
    marker.points.push_back(corner(i + 1));
    marker.colors.insert(marker.colors.end(), 3, color);
  }
}
}  // namespace ping_pong_sim
