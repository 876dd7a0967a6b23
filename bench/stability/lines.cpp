#include <algorithm>
#include <cmath>
#include <limits>

#include "situations.h"

namespace ping_pong::stability
{
namespace
{
struct Point
{
  double x, v;
};

// Equal balls that exchange speeds are points that pass through each other once the diameters are taken out: the n-th
// ball is the n-th point.
std::vector<Point> afterExchanges(const Scene& scene, double duration)
{
  std::vector<Point> points;
  for (std::size_t i = 0; i < scene.balls.size(); ++i)
  {
    const BallState& state = scene.balls[i].state;
    points.push_back({state.p_WB.x() - 2.0 * kR * static_cast<double>(i) + duration * state.v_WB.x(), state.v_WB.x()});
  }
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  for (std::size_t i = 0; i < points.size(); ++i) points[i].x += 2.0 * kR * static_cast<double>(i);
  return points;
}
}  // namespace

SceneBuilder cradle(int balls, int incoming, double gap, double restitution, Method method, double dt)
{
  SceneBuilder builder(method, dt);
  builder.restitution(restitution);
  for (int i = 0; i < balls; ++i)
  {
    const double x = (2.0 * kR + gap) * i - (i < incoming ? 0.1 : 0.0);
    builder.ball({x, 0, 0}, {i < incoming ? 1.0 : 0.0, 0, 0});
  }
  return builder;
}

double cradleError(Method method, double dt)
{
  double worst = 0.0;
  for (const double gap : {0.0, 1e-9, 1e-6, 1e-3})
    for (const int incoming : {1, 2, 3})
      for (const bool reversed : {false, true})
      {
        Scene scene = cradle(5, incoming, gap, 1.0, method, dt).build();
        const std::vector<Point> truth = afterExchanges(scene, 0.5);
        if (reversed) std::reverse(scene.balls.begin(), scene.balls.end());
        World world(scene);
        world.advance(0.5);
        for (std::size_t i = 0; i < truth.size(); ++i)
        {
          const std::size_t ball = reversed ? truth.size() - 1 - i : i;
          worst = std::max(worst, std::abs(positionOf(world, ball).x() - truth[i].x));
          worst = std::max(worst, std::abs(velocityOf(world, ball).x() - truth[i].v));
        }
      }
  return worst;
}

std::size_t galperinHits(Method method, double dt, double mass_ratio)
{
  SceneBuilder builder(method, dt);
  builder.box("wall", {1, 1, 1}, at({-0.5, 0, 0}))
      .ball({0.5, 0, 0}, {0, 0, 0}, 1e-3)
      .ball({1, 0, 0}, {-1, 0, 0}, 1e-3 * mass_ratio);
  World world = builder.world();
  return run(world, 0.02, 500).size();
}

double collapseError(Method method, double dt)
{
  double worst = 0.0;
  for (const double other : {-1.0, -0.6})
  {
    World world = SceneBuilder(method, dt)
                      .restitution(0.05)
                      .ball({-0.1, 0, 0}, {1, 0, 0})
                      .ball({0, 0, 0})
                      .ball({0.1, 0, 0}, {other, 0, 0})
                      .world();
    for (int i = 0; i < 20; ++i)
      if (!world.advance(0.1).ok()) return std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i)
      worst = std::max(worst, std::abs(velocityOf(world, i).x() - (1.0 + other) / 3.0));
  }
  return worst;
}
}  // namespace ping_pong::stability
