// Runs of hard-sphere gases in a cube, and averages with their statistical error.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "detect/broad_phase.h"
#include "ping_pong_sim/room.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
struct GasKind
{
  int balls = 500;
  double fill = 0.02;      ///< volume of the balls / volume of the cube
  double deviation = 1.0;  ///< of each component of the velocities at the start [m/s]; 0: all equally fast, 3^(1/2) m/s
  double heavy = 1.0;      ///< mass of every second ball / mass of the others
  std::uint64_t seed = 1;
};

inline double edgeOf(const GasKind& kind)
{
  return 2.0 * kR * std::cbrt(kind.balls * kPi / 6.0 / kind.fill);
}

/// Balls at random places of a cubic lattice with room to spare, so that any filling up to 0.3 can start.
inline Scene gasScene(const GasKind& kind, double restitution = 1.0)
{
  SceneBuilder builder;
  builder.restitution("ball", "ball", restitution).restitution("ball", "wall", 1.0);
  const double edge = edgeOf(kind);
  builder.body("room", BodyKind::Static, roomShapes(Vector3d::Constant(edge), 0), Pose());
  const int side = static_cast<int>((edge - 2.0 * kR) / (2.02 * kR)) + 1;
  std::vector<int> places(static_cast<std::size_t>(side * side * side));
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = static_cast<int>(i);
  Random random(kind.seed, 0);
  const double step = (edge - 2.02 * kR) / (side - 1);
  for (int i = 0; i < kind.balls; ++i)
  {
    const std::size_t left = places.size() - static_cast<std::size_t>(i);
    std::swap(places[static_cast<std::size_t>(i)], places[static_cast<std::size_t>(i) + random.next() % left]);
    const int place = places[static_cast<std::size_t>(i)];
    const Vector3d p = step * Vector3d(place % side, place / side % side, place / side / side);
    const Vector3d v = kind.deviation > 0.0
                           ? Vector3d(kind.deviation * Vector3d(random.normal(), random.normal(), random.normal()))
                           : Vector3d(std::sqrt(3.0) * random.direction());
    const Vector3d low(-0.5 * edge + 1.01 * kR, -0.5 * edge + 1.01 * kR, 1.01 * kR);
    builder.ball(low + p, v, i % 2 == 1 ? kind.heavy * kBallMass : kBallMass);
  }
  return builder.build();
}

/// Variance of a velocity component of equal balls, from the energy: 2 K / (3 N m) [m^2/s^2].
inline double temperatureOf(const World& world)
{
  return 2.0 * world.totals().kinetic / (3.0 * static_cast<double>(world.ballCount()) * kBallMass);
}

/// The deepest that any two balls, or a ball and a wall, overlap [m].
inline double deepestOverlap(const World& world, double edge)
{
  double deepest = -1.0;
  std::vector<CoarseBox> boxes;
  for (std::size_t i = 0; i < world.ballCount(); ++i)
  {
    const Vector3d p = positionOf(world, i);
    boxes.emplace_back(Box{p.array() - kR, p.array() + kR});
    deepest = std::max(
        {deepest, kR + std::abs(p.x()) - 0.5 * edge, kR + std::abs(p.y()) - 0.5 * edge, kR - p.z(), kR + p.z() - edge});
  }
  Workers alone;
  BroadPhase broad_phase;
  broad_phase.build(
      boxes.size(), [&](std::size_t i) { return boxes[i]; }, alone);
  broad_phase.eachPair(
      [&](std::uint32_t a, std::uint32_t b)
      { deepest = std::max(deepest, 2.0 * kR - (positionOf(world, a) - positionOf(world, b)).norm()); });
  return deepest;
}

/// Mean of equal parts of a run, and its standard error from how the parts differ.
class Average
{
public:
  void add(double part) { parts_.push_back(part); }
  double mean() const
  {
    double sum = 0.0;
    for (const double part : parts_) sum += part;
    return sum / static_cast<double>(parts_.size());
  }
  double error() const
  {
    double squares = 0.0;
    for (const double part : parts_) squares += (part - mean()) * (part - mean());
    const double n = static_cast<double>(parts_.size());
    return std::sqrt(squares / (n * (n - 1.0)));
  }

private:
  std::vector<double> parts_;
};
}  // namespace ping_pong
