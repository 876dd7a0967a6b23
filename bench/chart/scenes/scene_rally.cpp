// Shots over a table with a net, through air.
#include <stdexcept>

#include "air_scenes.h"
#include "ping_pong_sim/shots.h"
#include "sampled.h"
#include "scene_parts.h"
#include "testing/hit_reference.h"

namespace ping_pong::bench
{
namespace
{
const Vector3d kTable(kTableLength, kTableWidth, 0.025);  // playing surface at kTableHeight [m]
const Vector3d kNet(0.002, 1.83, kNetHeight);             // [m]
const Vector3d kTableMiddle(0, 0, kTableHeight - 0.5 * 0.025);
const Vector3d kNetMiddle(0, 0, kTableHeight + 0.5 * kNetHeight);

// Shots that touch the net or the edge of the table: this truth knows level ground only.
bool nearNetOrEdge(const Vector3r& p, double radius)
{
  constexpr double kMargin = 5e-3;  // [m]
  const Vector3d q = p.cast<double>();
  if (distanceToBox(q - kNetMiddle, 0.5 * kNet) < radius + kMargin) return true;
  const bool above = std::abs(q.x()) < 0.5 * kTable.x() - kMargin && std::abs(q.y()) < 0.5 * kTable.y() - kMargin;
  return !above && distanceToBox(q - kTableMiddle, 0.5 * kTable) < radius + kMargin;
}

Scene rallyScene(const ChartScene& chart, const Shot& shot)
{
  Scene scene = emptyScene(chart.name, contactLaw(0.93, 0.25));
  addAir(scene, DragLaw());  // the default: drag grows with spin
  addFloor(scene);
  addBox(scene, "table", BodyKind::Static, kTable, {kTableMiddle, Quaterniond::Identity()});
  addBox(scene, "net", BodyKind::Static, kNet, {kNetMiddle, Quaterniond::Identity()});
  BallState state;
  state.p_WB = shot.p_TB + Vector3d(0, 0, kTableHeight);
  state.v_WB = shot.v_TB;
  state.w_WB = shot.w_TB;
  addBall(scene, BallParams(), state);
  return scene;
}

Start startRally(const ChartScene& chart, int n, int refinement)
{
  constexpr double kScatter = 0.05;
  constexpr int kTries = 100;
  for (int attempt = 0; attempt < kTries; ++attempt)
  {
    const auto seed = static_cast<std::uint64_t>(n * kTries + attempt);
    Start start;
    start.scene = rallyScene(chart, scattered(drawnShot(static_cast<std::uint64_t>(n)), kScatter, seed));
    AirTask task = airTask(chart, start.scene, refinement);
    task.grounds = {{kTableHeight, 0.5L * kTable.x(), 0.5L * kTable.y()}, Ground()};
    const double radius = start.scene.balls[0].params.radius;
    task.forbidden = [radius](const Vector3r& p) { return nearNetOrEdge(p, radius); };
    const std::optional<TruePath> path = airTruth(task);
    if (!path) continue;
    start.truth = {*path};
    return start;
  }
  throw std::runtime_error("rally: every shot touches the net or an edge");
}

bool underTable(const BallState& ball)
{
  const Vector3d& p = ball.p_WB;
  return p.z() < kTableHeight && std::abs(p.x()) < 0.5 * kTable.x() && std::abs(p.y()) < 0.5 * kTable.y();
}
}  // namespace

ChartScene rally()
{
  ChartScene chart = airChart("rally", "Rally: table, net, air, spin and friction, 1.2 s");
  chart.duration = 1.2;
  chart.lost = underTable;
  return withStarts(chart, startRally);
}
}  // namespace ping_pong::bench
