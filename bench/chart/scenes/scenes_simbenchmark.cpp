// SimBenchmark's "bouncing", "elastic 666" and "666" (leggedrobotics/SimBenchmark) with its parameters.
#include <cmath>

#include "closed_forms.h"
#include "draw.h"
#include "sampled.h"
#include "scene_parts.h"

namespace ping_pong::bench
{
namespace
{
BallParams heavyBall()  // of SimBenchmark
{
  BallParams ball;
  ball.radius = 0.1;
  ball.mass = 10.0;
  ball.inertia = kSolidInertia;
  return ball;
}

TruePath bouncingInPlace(const ChartScene& chart, const Vector3d& p, Real radius)
{
  const ElasticBouncing bouncing({p.z() - radius, 0.0L}, kGravity);
  TruePath path;
  path.samples = sampled(chart,
                         [&](Real t)
                         {
                           const Vertical now = bouncing.at(t);
                           return TrueState{{p.x(), p.y(), now.z + radius}, {0.0L, 0.0L, now.v}, Vector3r::Zero()};
                         });
  for (Real t = bouncing.firstBounce(); t < chart.duration; t += bouncing.period()) path.events.push_back(t);
  path.bounces = static_cast<int>(path.events.size());
  return path;
}

// Start 0 is SimBenchmark's. Its 49 balls fall in step, which a lucky step length would meet; the other start has them
// fall from heights of their own.
Start startBouncing(const ChartScene& chart, int n, int)
{
  Start start;
  start.scene = emptyScene(chart.name, contactLaw(1.0, 0.0));
  addFloor(start.scene);
  Random random(42, static_cast<std::uint64_t>(n));
  for (int i = 0; i < 7; ++i)
    for (int k = 0; k < 7; ++k)
    {
      BallState state;
      state.p_WB = Vector3d(2.0 * i, 2.0 * k, n == 0 ? 5.0 : random.uniform(4.9, 5.1));
      addBall(start.scene, heavyBall(), state);
      start.truth.push_back(bouncingInPlace(chart, state.p_WB, heavyBall().radius));
    }
  return start;
}

// 6 x 6 x 6 balls, the lowest at this height [m], fall on the floor and on each other.
Start start666(const ChartScene& chart, int n, double restitution, double height)
{
  Start start;
  start.scene = emptyScene(chart.name, contactLaw(restitution, 0.0));
  addFloor(start.scene);
  Random random(42, static_cast<std::uint64_t>(n));
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 6; ++k)
      {
        BallState state;
        state.p_WB = 0.21 * Vector3d(i, j, k) + random.uniform(Vector3d::Zero(), Vector3d::Constant(1e-3));
        state.p_WB.z() += height;
        addBall(start.scene, heavyBall(), state);
      }
  return start;
}

// What both scenes of them have in common.
ChartScene chart666(const std::string& name, double restitution, double height)
{
  ChartScene chart;
  chart.name = name;
  chart.duration = 10.0;
  chart.sample_period = 0.1;
  chart.steps = oneTwoFive(2e-2, 1e-4);
  chart.tolerances = {1e-6};
  chart.starts = 2;
  return withStarts(chart, [restitution, height](const ChartScene& its, int n, int)
                    { return start666(its, n, restitution, height); });
}
}  // namespace

ChartScene bouncing()
{
  ChartScene chart;
  chart.name = "bouncing";
  chart.title = "SimBenchmark bouncing: 49 elastic balls, 20 s";
  chart.duration = 20.0;
  chart.sample_period = 0.2;
  chart.steps = oneTwoFive(1e-1, 1e-5);
  chart.tolerances = {1e-6};
  chart.starts = 2;
  chart.reference = "closed form";
  return withStarts(chart, startBouncing);
}

// They scatter; chaos leaves nothing to compare with.
ChartScene elastic666()
{
  ChartScene chart = chart666("elastic_666", 1.0, 1.101);
  chart.title = "SimBenchmark elastic 666: 216 elastic balls, 10 s";
  chart.measure = Measure::Energy;
  chart.reference = "energy is conserved";
  return chart;
}

// Columns of six balls stand on the floor, out of line by up to a millimetre: they collapse, and all balls end up on
// the floor.
ChartScene inelastic666()
{
  ChartScene chart = chart666("inelastic_666", 0.0, 0.101);
  chart.title = "SimBenchmark 666: 216 balls that do not bounce, 10 s";
  chart.measure = Measure::Overlap;
  chart.reference = "nothing is inside another, and all balls come to lie on the floor";
  chart.settled = [](const BallState& end)
  { return std::abs(end.p_WB.z() - heavyBall().radius) < 0.5 * heavyBall().radius; };
  return chart;
}
}  // namespace ping_pong::bench
