#include "plan_markers.h"

#include "ros/base/conversions.h"

namespace ping_pong_sim
{
namespace play = ping_pong::play;
using ping_pong::Vector3d;

namespace
{
constexpr double kSpacing = 0.01;  // between points of the path [s]

visualization_msgs::Marker marker(const char* name, int type, double size, const ping_pong::Color& color)
{
  visualization_msgs::Marker m;
  m.header.frame_id = "world";
  m.ns = name;
  m.type = type;
  m.pose.orientation.w = 1.0;
  m.scale.x = m.scale.y = m.scale.z = size;
  m.color = toColor(color);
  return m;
}

void show(visualization_msgs::Marker& m, bool there)
{
  m.action = there ? visualization_msgs::Marker::ADD : visualization_msgs::Marker::DELETE;
}
}  // namespace

visualization_msgs::MarkerArray planMarkers(const play::Player& player, double time)
{
  const auto inWorld = [&player](const Vector3d& p_O)
  {
    ping_pong::BallState state;
    state.p_WB = p_O;
    return toPoint(player.court().toWorld(state).p_WB);
  };
  visualization_msgs::Marker path =
      marker("path", visualization_msgs::Marker::LINE_STRIP, 0.006, {1.0, 0.85, 0.2, 0.9});
  visualization_msgs::Marker hit = marker("hit", visualization_msgs::Marker::SPHERE, 0.05, {1.0, 0.3, 0.2, 0.7});
  visualization_msgs::Marker target =
      marker("target", visualization_msgs::Marker::CYLINDER, 0.12, {0.3, 1.0, 0.4, 0.6});
  target.scale.z = 0.004;

  const play::Prediction& prediction = player.prediction();
  double last = time - kSpacing;
  if (!prediction.empty())
    for (const play::PathSample& sample : prediction.samples())
    {
      if (sample.time < last + kSpacing) continue;
      last = sample.time;
      path.points.push_back(inWorld(sample.state.p_WB));
    }
  show(path, path.points.size() > 1);

  const play::StrokePlan* plan = player.plan();
  show(hit, plan != nullptr);
  show(target, plan != nullptr);
  if (plan != nullptr)
  {
    hit.pose.position = inWorld(plan->in.p_WB);
    target.pose.position = inWorld({plan->wish.target_x, plan->wish.target_y, target.scale.z});
  }
  visualization_msgs::MarkerArray array;
  array.markers = {path, hit, target};
  return array;
}
}  // namespace ping_pong_sim
