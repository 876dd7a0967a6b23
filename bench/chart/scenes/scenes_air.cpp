// Flight through air, and bounces with spin and friction.
#include "air_scenes.h"
#include "draw.h"
#include "sampled.h"
#include "scene_parts.h"

namespace ping_pong::bench
{
namespace
{
constexpr double kDragCoefficient = 0.45;

Start startAirFlight(const ChartScene& chart, int n, int refinement)
{
  Random random(4, static_cast<std::uint64_t>(n));
  BallState state;
  state.v_WB = randomVector(random, 2.0, 20.0);
  state.w_WB = randomVector(random, 0.0, 300.0);
  Start start;
  start.scene = emptyScene(chart.name, contactLaw(1.0, 0.0));
  addAir(start.scene, DragLaw::constant(kDragCoefficient));
  addBall(start.scene, BallParams(), state);
  start.truth = {airTruth(airTask(chart, start.scene, refinement)).value()};
  return start;
}

Start startSpinBounce(const ChartScene& chart, int n, int refinement, bool air)
{
  Random random(5, static_cast<std::uint64_t>(n));
  BallState state;
  state.p_WB.z() = random.uniform(0.15, 0.45);
  state.v_WB.x() = random.uniform(2.0, 8.0);
  state.w_WB = random.uniform(Vector3d::Constant(-100.0), Vector3d::Constant(100.0));
  Start start;
  start.scene = emptyScene(chart.name, contactLaw(0.9, 0.25));
  if (air) addAir(start.scene, DragLaw::constant(kDragCoefficient));
  addFloor(start.scene);
  addBall(start.scene, BallParams(), state);
  AirTask task = airTask(chart, start.scene, refinement);
  task.grounds = {Ground()};
  start.truth = {airTruth(task).value()};
  return start;
}
}  // namespace

ChartScene airFlight()
{
  return withStarts(airChart("flight_air", "Free flight with drag and Magnus force, 2 s"), startAirFlight);
}

ChartScene spinBounce()
{
  return withStarts(airChart("spin_bounce", "Bounces with spin and friction in air, 2 s"),
                    [](const ChartScene& chart, int n, int refinement)
                    { return startSpinBounce(chart, n, refinement, true); });
}

ChartScene spinBounceVacuum()
{
  ChartScene chart = airChart("spin_bounce_vacuum", "Bounces with spin and friction in vacuum, 2 s");
  chart.tolerances = {1e-6};
  return withStarts(
      chart, [](const ChartScene& copy, int n, int refinement) { return startSpinBounce(copy, n, refinement, false); });
}
}  // namespace ping_pong::bench
