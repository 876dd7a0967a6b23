// Flight without anything to meet.
#include "draw.h"
#include "sampled.h"
#include "scene_parts.h"

namespace ping_pong::bench
{
namespace
{
Start startVacuumFlight(const ChartScene& chart, int n, int)
{
  Random random(1, static_cast<std::uint64_t>(n));
  BallState state;
  state.v_WB = random.uniform(Vector3d(-10, -10, 5), Vector3d(10, 10, 15));
  Start start;
  start.scene = emptyScene(chart.name, contactLaw(1.0, 0.0));
  addBall(start.scene, BallParams(), state);
  const Vector3r v = state.v_WB.cast<Real>(), g(0, 0, -static_cast<Real>(kGravity));
  TruePath path;
  path.samples = sampled(chart,
                         [&](Real t) {
                           return TrueState{t * v + 0.5L * t * t * g, v + t * g, Vector3r::Zero()};
                         });
  start.truth = {path};
  return start;
}
}  // namespace

ChartScene vacuumFlight()
{
  ChartScene chart;
  chart.name = "flight_vacuum";
  chart.title = "Free flight in vacuum, 10 s";
  chart.duration = 10.0;
  chart.sample_period = 1.0;
  chart.steps = oneTwoFive(1e-1, 1e-4);
  chart.tolerances = {1e-6};
  chart.reference = "closed form";
  return withStarts(chart, startVacuumFlight);
}
}  // namespace ping_pong::bench
