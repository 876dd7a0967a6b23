#include "trails.h"

#include <algorithm>
#include <iterator>

#include "ros/base/conversions.h"

namespace ping_pong_sim
{
namespace
{
constexpr double kLength = 0.7;     ///< simulated time that a trail shows [s]
constexpr double kInterval = 0.01;  ///< between its points [s]
constexpr double kWidth = 0.007;    ///< [m]
constexpr float kOpacity = 0.6f;    ///< at the ball
}  // namespace

void Trails::observe(const Simulation& simulation)
{
  const ping_pong::World& world = simulation.world();
  if (simulation.isDrawnAsList()) return clear();
  const double now = simulation.elapsed();
  // The centre at each impact, so that a bounce is a corner and not cut.
  for (const ping_pong::Contact& contact : world.contacts())
  {
    const std::size_t i = world.findBall(contact.ball);
    if (i == ping_pong::kNone) continue;
    const double time = now - (world.time() - contact.time);
    paths_[contact.ball].push_back({time, contact.p_WC + world.ballParams(i).radius * contact.n_W});
  }
  for (std::size_t i = 0; i < world.ballCount(); ++i) add(paths_[world.ballId(i)], {now, world.ballState(i).p_WB});
  for (auto path = paths_.begin(); path != paths_.end();)
  {
    Path& points = path->second;
    while (!points.empty() && now - points.front().time > kLength) points.pop_front();
    path = points.empty() ? paths_.erase(path) : std::next(path);
  }
}

void Trails::add(Path& path, const Point& point) const
{
  if (path.empty() || point.time - path.back().time >= kInterval - 1e-9) path.push_back(point);
}

visualization_msgs::Marker Trails::marker(const Simulation& simulation) const
{
  using visualization_msgs::Marker;
  const ping_pong::World& world = simulation.world();
  const double now = simulation.elapsed();
  Marker marker = makeMarker("world", "trails", 0, Marker::LINE_LIST);
  marker.header.stamp = simulation.clock().now();
  marker.scale.x = kWidth;
  marker.color.a = 0.99f;  // below one: RViz then blends
  for (const auto& entry : paths_)
  {
    const std::size_t ball = world.findBall(entry.first);
    if (ball == ping_pong::kNone) continue;
    std_msgs::ColorRGBA color = toColor(world.ballParams(ball).color);
    Path path = entry.second;
    path.push_back({now, world.ballState(ball).p_WB});
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      if ((path[i].p_W - path[i - 1].p_W).norm() < 1e-4) continue;
      for (const std::size_t end : {i - 1, i})
      {
        color.a = kOpacity * static_cast<float>(std::max(0.0, 1.0 - (now - path[end].time) / kLength));
        marker.points.push_back(toPoint(path[end].p_W));
        marker.colors.push_back(color);
      }
    }
  }
  if (marker.points.empty()) marker.action = Marker::DELETE;
  return marker;
}
}  // namespace ping_pong_sim
