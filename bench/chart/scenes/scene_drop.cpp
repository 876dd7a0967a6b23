// A ball is dropped and comes to rest after endless bounces in finite time.
#include "closed_forms.h"
#include "draw.h"
#include "sampled.h"
#include "scene_parts.h"

namespace ping_pong::bench
{
namespace
{
Start startDropToRest(const ChartScene& chart, int n, int)
{
  constexpr double kRestitution = 0.9;
  Random random(2, static_cast<std::uint64_t>(n));
  const BallParams ball;
  BallState state;
  state.p_WB.z() = random.uniform(0.25, 0.35);
  Start start;
  start.scene = emptyScene(chart.name, contactLaw(kRestitution, 0.0));
  addFloor(start.scene);
  addBall(start.scene, ball, state);
  const Real radius = ball.radius;
  const BouncingToRest bouncing(static_cast<Real>(state.p_WB.z()) - radius, kRestitution, kGravity);
  TruePath path;
  path.samples = sampled(chart,
                         [&](Real t)
                         {
                           const Vertical now = bouncing.at(t);
                           return TrueState{{0.0L, 0.0L, now.z + radius}, {0.0L, 0.0L, now.v}, Vector3r::Zero()};
                         });
  path.events = bouncing.bounces(1e-3L);
  start.truth = {path};
  return start;
}
}  // namespace

ChartScene dropToRest()
{
  ChartScene chart;
  chart.name = "drop_to_rest";
  chart.title = "Drop to rest, e = 0.9, 8 s";
  chart.duration = 8.0;
  chart.sample_period = 0.1;
  chart.steps = oneTwoFive(1e-1, 1e-5);
  chart.tolerances = {1e-6};
  chart.reference = "closed form";
  return withStarts(chart, startDropToRest);
}
}  // namespace ping_pong::bench
