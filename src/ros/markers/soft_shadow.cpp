#include "soft_shadow.h"

#include <algorithm>
#include <cmath>

namespace ping_pong_sim
{
namespace
{
constexpr int kSegments = 48;       ///< around
constexpr int kRings = 8;           ///< from the rim to where it is darkest
constexpr double kRim = 0.6;        ///< width of the part that fades, as a part of the shorter edge
constexpr double kRoundness = 0.4;  ///< exponent of the outline: 1 is an ellipse, 0 a rectangle

geometry_msgs::Point onRing(double length, double width, int segment)
{
  const double angle = 2.0 * M_PI * (segment + 0.5) / kSegments;
  const auto rounded = [](double x) { return std::copysign(std::pow(std::abs(x), kRoundness), x); };
  geometry_msgs::Point point;
  point.x = 0.5 * length * rounded(std::cos(angle));
  point.y = 0.5 * width * rounded(std::sin(angle));
  return point;
}
}  // namespace

void makeSoft(visualization_msgs::Marker& box)
{
  const double length = box.scale.x;
  const double width = box.scale.y;
  const double rim = kRim * std::min(length, width);
  box.type = visualization_msgs::Marker::TRIANGLE_LIST;
  box.scale.x = box.scale.y = box.scale.z = 1.0;
  const auto add = [&](int ring, int segment)
  {
    std_msgs::ColorRGBA color = box.color;
    color.a *= static_cast<float>(std::min(ring, kRings)) / kRings;
    const double in = rim * ring / kRings;
    box.points.push_back(ring > kRings ? geometry_msgs::Point() : onRing(length - in, width - in, segment));
    box.colors.push_back(color);
  };
  for (int ring = 0; ring <= kRings; ++ring)  // the last one ends in the middle
  {
    for (int segment = 0; segment < kSegments; ++segment)
    {
      add(ring, segment);
      add(ring, segment + 1);
      add(ring + 1, segment);
      if (ring == kRings) continue;
      add(ring, segment + 1);
      add(ring + 1, segment + 1);
      add(ring + 1, segment);
    }
  }
}
}  // namespace ping_pong_sim
