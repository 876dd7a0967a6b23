#include "crowd_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ping_pong_sim/room.h"
#include "ping_pong_sim/scene_loader.h"
#include "tray_scene.h"

namespace ping_pong::bench
{
namespace
{
/// Pairs of centres closer than a diameter, by a sort along x: independent of the library's grid.
double deepestPair(const Scene& scene, const std::vector<BallState>& balls)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < balls.size(); ++i)
    if (balls[i].p_WB.allFinite()) order.push_back(i);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return balls[a].p_WB.x() < balls[b].p_WB.x(); });
  double deepest = 0.0;
  for (std::size_t m = 0; m < order.size(); ++m)
    for (std::size_t n = m + 1; n < order.size(); ++n)
    {
      const std::size_t i = order[m], k = order[n];
      const double reach = scene.balls[i].params.radius + scene.balls[k].params.radius;
      const Vector3d d = balls[k].p_WB - balls[i].p_WB;
      if (d.x() > reach) break;
      if (d.squaredNorm() < reach * reach) deepest = std::max(deepest, reach - d.norm());
    }
  return deepest;
}
// Inner size of the room, or of the tray, which is open at the top.
Vector3d insideOf(const Scene& scene)
{
  if (const std::optional<Vector3d> room = roomSize(scene.bodies.front())) return *room;
  const Vector3d tray = traySize(scene.balls.size());
  return {tray.x(), tray.y(), std::numeric_limits<double>::infinity()};
}
}  // namespace

const std::vector<CrowdScene>& crowdScenes()
{
  static const std::vector<CrowdScene> scenes = {
      {"gas", 0.05, 10.0, true}, {"crowd", 0.0, 1.0, false}, {"tray", 0.0, 4.0, false, 0.25, 100.0, {2.5e-3}, true}};
  return scenes;
}

Scene crowdOf(const CrowdScene& crowd, std::size_t balls)
{
  if (crowd.name == "tray") return trayScene(balls);
  LoadOptions options;
  options.balls = balls;
  return loadScene(std::string(SCENES_DIR) + "/" + crowd.name + ".yaml", options);
}

Soundness soundnessOf(const Scene& scene, const std::vector<BallState>& balls)
{
  const Body& room = scene.bodies.front();
  const Vector3d size = insideOf(scene);
  Soundness found;
  found.overlap = deepestPair(scene, balls);
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const BallParams& params = scene.balls[i].params;
    const Vector3d p = balls[i].p_WB - room.pose.p;
    found.fastest = std::max(found.fastest, balls[i].v_WB.norm());
    found.energy += params.mass * (0.5 * balls[i].v_WB.squaredNorm() - scene.forces.gravity.dot(p));
    const double beyond =
        std::max({std::abs(p.x()) - 0.5 * size.x(), std::abs(p.y()) - 0.5 * size.y(), -p.z(), p.z() - size.z()});
    if (!(beyond < 0.0))
      ++found.escaped;
    else
      found.overlap = std::max(found.overlap, beyond + params.radius);
  }
  return found;
}
}  // namespace ping_pong::bench
