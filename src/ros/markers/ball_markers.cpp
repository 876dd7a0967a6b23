#include "ball_markers.h"

#include <cmath>
#include <map>

#include "ros/base/conversions.h"
#include "ros/state/state_messages.h"

namespace ping_pong_sim
{
namespace
{
using ping_pong::Vector3d;
using visualization_msgs::Marker;

constexpr int kStripeSegments = 24;
constexpr double kStripeArc = 5.4;         ///< [rad]: an open ring, so that a turn about its own axis shows too
constexpr double kStripeHalfWidth = 0.22;  ///< as an angle seen from the centre [rad]
constexpr double kStripeRadius = 1.02;     ///< of the ball's

// Dark on light balls, white on dark ones.
ping_pong::Color contrast(const ping_pong::Color& color)
{
  const float luminance = 0.30f * color.r + 0.59f * color.g + 0.11f * color.b;
  return luminance > 0.45f ? ping_pong::Color{0.10f, 0.12f, 0.35f, 1.0f} : ping_pong::Color{1.0f, 1.0f, 1.0f, 1.0f};
}

Vector3d onStripe(double along, double across)
{
  return {std::sin(across), std::cos(across) * std::cos(along), std::cos(across) * std::sin(along)};
}

std::vector<geometry_msgs::Point> stripePoints(double ball_radius)
{
  const double radius = kStripeRadius * ball_radius;
  std::vector<geometry_msgs::Point> points;
  const auto add = [&](double along, double across) { points.push_back(toPoint(radius * onStripe(along, across))); };
  for (int i = 0; i < kStripeSegments; ++i)
  {
    const double from = kStripeArc * i / kStripeSegments;
    const double to = kStripeArc * (i + 1) / kStripeSegments;
    for (const double edge : {-kStripeHalfWidth, 0.0})  // two flat strips follow the sphere better than one
    {
      const double other = edge + kStripeHalfWidth;
      add(from, edge);
      add(to, edge);
      add(to, other);
      add(from, edge);
      add(to, other);
      add(from, other);
    }
  }
  return points;
}

void setSize(Marker& marker, double size)
{
  marker.scale.x = size;
  marker.scale.y = size;
  marker.scale.z = size;
}
// Then a marker needs no colour per ball, two fifths of its bytes.
bool haveOneColor(const ping_pong::World& world)
{
  const auto same = [](const ping_pong::Color& a, const ping_pong::Color& b)
  { return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a; };
  for (std::size_t i = 1; i < world.ballCount(); ++i)
    if (!same(world.ballParams(i).color, world.ballParams(0).color)) return false;
  return true;
}
}  // namespace

Marker makeMarker(const std::string& frame, const std::string& ns, int id, int type)
{
  Marker marker;
  marker.header.frame_id = frame;
  marker.ns = ns;
  marker.id = id;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  return marker;
}

Marker deleteAllMarkers()
{
  Marker marker;
  marker.header.frame_id = "world";
  marker.action = Marker::DELETEALL;
  return marker;
}

void appendSingleBalls(const ping_pong::World& world, Markers& markers)
{
  for (std::size_t i = 0; i < world.ballCount(); ++i)
  {
    const ping_pong::BallParams& params = world.ballParams(i);
    const int id = static_cast<int>(world.ballId(i));
    Marker ball = makeMarker(ballFrame(world.ballId(i)), "balls", id, Marker::SPHERE);
    ball.frame_locked = true;
    setSize(ball, 2.0 * params.radius);
    ball.color = toColor(params.color);
    markers.push_back(ball);

    Marker stripe = makeMarker(ballFrame(world.ballId(i)), "stripes", id, Marker::TRIANGLE_LIST);
    stripe.frame_locked = true;
    setSize(stripe, 1.0);
    stripe.color = toColor(contrast(params.color));
    stripe.points = stripePoints(params.radius);
    markers.push_back(stripe);
  }
}

void appendCrowd(const ping_pong::World& world, const ros::Time& stamp, Markers& markers)
{
  const bool one_color = haveOneColor(world);
  std::map<int, Marker> lists;  // by radius in tenths of a millimetre: one list has one size
  for (std::size_t i = 0; i < world.ballCount(); ++i)
  {
    const ping_pong::BallParams& params = world.ballParams(i);
    const int radius = static_cast<int>(std::lround(params.radius * 1e4));
    auto found = lists.find(radius);
    if (found == lists.end())
    {
      Marker list = makeMarker("world", "crowd", radius, Marker::SPHERE_LIST);
      list.header.stamp = stamp;
      setSize(list, 2.0 * params.radius);
      list.color = toColor(params.color);
      list.points.reserve(world.ballCount());
      if (!one_color) list.colors.reserve(world.ballCount());
      found = lists.emplace(radius, list).first;
    }
    found->second.points.push_back(toPoint(world.ballState(i).p_WB));
    if (!one_color) found->second.colors.push_back(toColor(params.color));
  }
  for (auto& entry : lists) markers.push_back(std::move(entry.second));
}
}  // namespace ping_pong_sim
