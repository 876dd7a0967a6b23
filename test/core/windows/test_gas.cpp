// Where single paths are chaos: many elastic balls are a gas, and kinetic theory knows its averages. Every comparison tells the
// statistical error of the run beside the bound, which is four such errors and what the theory itself leaves out.
#include <gtest/gtest.h>

#include <algorithm>

#include "gas_run.h"
#include "gas_theory.h"

namespace ping_pong
{
namespace
{
/// Measured and expected with the error in between.
void expectNear(const char* what, const Average& measured_average, double expected, double theory)
{
  const double mean = measured_average.mean(), error = measured_average.error();
  std::printf("[ measured ] %s: %.5g, theory %.5g: %+.2f %%, one statistical error is %.2f %%\n", what, mean, expected,
              100.0 * (mean / expected - 1.0), 100.0 * error / expected);
  EXPECT_LT(error, 0.01 * expected) << what << ": the run is too short to say anything";
  EXPECT_NEAR(mean, expected, 4.0 * error + theory * expected) << what;
}

struct Flow
{
  double wall_impulse = 0.0;  ///< sum of sizes, per mass of a ball [m/s]
  double hits = 0.0;          ///< between balls
};

Flow flowIn(World& world, double duration)
{
  Flow flow;
  const int ticks = static_cast<int>(std::lround(duration / 0.01));
  for (int i = 0; i < ticks; ++i)
  {
    world.advance(0.01);
    for (const Contact& contact : world.contacts())
      if (contact.with_ball)
        flow.hits += 1.0;
      else
        flow.wall_impulse += std::abs(contact.impulse.dot(contact.n_W)) / kBallMass;
  }
  return flow;
}

TEST(Gas, PressureOnTheWallsAndRateOfHitsFollowCarnahanStarlingAndEnskog)
{
  for (const double fill : {0.01, 0.05, 0.1})
  {
    GasKind kind;
    kind.fill = fill;
    const double edge = edgeOf(kind);
    World world(gasScene(kind));
    const double t = temperatureOf(world);
    const GasTheory theory(kind.balls, 2.0 * kR, edge);
    const double time_per_hit = 0.5 * kind.balls / theory.hitRate(t);  // of one ball
    flowIn(world, 10.0 * time_per_hit);
    const double part = std::max(0.01, 0.01 * std::round(1e4 / (20.0 * theory.hitRate(t)) / 0.01 * 4.0));
    Average force, rate;
    for (int i = 0; i < 20; ++i)
    {
      const Flow flow = flowIn(world, part);
      force.add(flow.wall_impulse / (6.0 * part));
      rate.add(flow.hits / part);
    }
    std::printf("[ measured ] fill %.3g (middle %.4g), Z = %.4f, walls change the force on a face by %.1f %%\n", fill,
                theory.fill, theory.compressibility(),
                100.0 * (theory.force(t) / (theory.density * t * theory.compressibility() * edge * edge) - 1.0));
    // Of the theory: Carnahan-Starling is within 0.1 % here; scaled-particle theory leaves out the edges of the cube, of order
    // eta (d / L)^2, 0.1 % at the most; and N balls of fixed energy differ from many by 1 / N, 0.2 %, of Z - 1.
    expectNear("force on a face / mass [m/s^2]", force, theory.force(t), 0.002);
    expectNear("hits between balls per second", rate, theory.hitRate(t), 0.01);
  }
}

/// Largest distance between the distribution of these speeds and Maxwell's.
double distanceFromMaxwell(std::vector<double> speeds, double t)
{
  std::sort(speeds.begin(), speeds.end());
  double distance = 0.0;
  const double n = static_cast<double>(speeds.size());
  for (std::size_t i = 0; i < speeds.size(); ++i)
  {
    const double x = speeds[i] / std::sqrt(2.0 * t);
    const double below = std::erf(x) - 2.0 / std::sqrt(kPi) * x * std::exp(-x * x);
    const double rank = static_cast<double>(i);
    distance = std::max({distance, below - rank / n, (rank + 1.0) / n - below});
  }
  return distance;
}

TEST(Gas, SpeedsRelaxToMaxwell)
{
  GasKind kind;
  kind.balls = 1000;
  kind.fill = 0.05;
  kind.deviation = 0.0;  // all equally fast
  World world(gasScene(kind));
  const double t = temperatureOf(world);
  const double time_per_hit = 0.5 * kind.balls / GasTheory(kind.balls, 2.0 * kR, edgeOf(kind)).hitRate(t);
  std::vector<double> speeds;
  const auto look = [&]
  {
    for (std::size_t i = 0; i < world.ballCount(); ++i) speeds.push_back(velocityOf(world, i).norm());
  };
  look();
  const double at_start = distanceFromMaxwell(speeds, t) * std::sqrt(1000.0);
  flowIn(world, 8.0 * time_per_hit);
  speeds.clear();
  for (int i = 0; i < 10; ++i)
  {
    flowIn(world, 4.0 * time_per_hit);
    look();
  }
  const double at_end = distanceFromMaxwell(speeds, t) * std::sqrt(10000.0);
  measured("Kolmogorov's distance x n^(1/2), all equally fast", at_start);
  measured("after 8 hits a ball and more, 10 000 speeds; 1.95 is passed by chance once in 1000", at_end);
  EXPECT_GT(at_start, 15.0);
  EXPECT_LT(at_end, 1.95);
}

TEST(Gas, LightAndHeavyBallsShareTheEnergyEvenly)
{
  GasKind kind;
  kind.fill = 0.05;
  kind.heavy = 8.0;  // at the start as fast as the others: eight times their energy
  World world(gasScene(kind));
  const auto energies = [&]
  {
    Vector3d sums = Vector3d::Zero();
    for (std::size_t i = 0; i < world.ballCount(); ++i)
      sums[i % 2] += 0.5 * world.ballParams(i).mass * velocityOf(world, i).squaredNorm();
    return sums;
  };
  const double at_start = energies()[1] / energies()[0];
  flowIn(world, 3.0);
  Average share;
  for (int i = 0; i < 30; ++i)
  {
    flowIn(world, 0.2);
    share.add(energies()[1] / (energies()[0] + energies()[1]));
  }
  measured("energy of the heavy ones / the light ones at the start", at_start);
  EXPECT_GT(at_start, 6.0);
  expectNear("part of the energy that the heavy half has", share, 0.5, 0.0);
}

TEST(Gas, InelasticBallsCoolByHaffsLaw)
{
  GasKind kind;
  kind.balls = 1000;
  kind.fill = 0.05;
  World elastic(gasScene(kind));
  flowIn(elastic, 1.0);  // places and speeds of equilibrium
  constexpr double kE = 0.9;
  Scene scene = gasScene(kind, kE);
  for (std::size_t i = 0; i < scene.balls.size(); ++i) scene.balls[i].state = elastic.ballState(i);
  World world(scene);
  const double t0 = temperatureOf(world);
  const double rate = GasTheory(kind.balls, 2.0 * kR, edgeOf(kind)).hitRate(t0);
  const double tau = 3.0 * kind.balls / ((1.0 - kE * kE) * rate);  // T = T0 / (1 + t / tau)^2
  double hits = 0.0, worst_in_time = 0.0, worst_in_hits = 0.0;
  for (int i = 1; i <= 40; ++i)
  {
    hits += flowIn(world, 0.01 * std::round(100.0 * tau / 40.0)).hits;
    const double left = temperatureOf(world) / t0;
    const double haff = std::pow(1.0 + world.time() / tau, -2.0);
    worst_in_time = std::max(worst_in_time, std::abs(left / haff - 1.0));
    const double by_hits = std::exp(-2.0 / 3.0 * (1.0 - kE * kE) * hits / kind.balls);  // T (1 - e^2) is lost in a hit
    worst_in_hits = std::max(worst_in_hits, std::abs(left / by_hits - 1.0));
  }
  // A hit takes T (1 - e^2) with a standard deviation as large (the square of the normal speed is exponential).
  const double error = (1.0 - kE * kE) * 2.0 / 3.0 * std::sqrt(hits) / kind.balls;
  measured("part of the energy left at the end", temperatureOf(world) / t0);
  measured("one statistical error", error);
  measured("worst relative difference from Haff's law in time", worst_in_time);
  measured("worst relative difference from the law in hits", worst_in_hits);
  EXPECT_LT(temperatureOf(world) / t0, 0.3);
  // Theory: speeds of a cooling gas are not quite Maxwell's; a2 = -0.02 at e = 0.9 makes 0.4 % of the rate (van Noije, Ernst).
  EXPECT_LT(worst_in_hits, 4.0 * error + 0.01);
  EXPECT_LT(worst_in_time, 4.0 * error + 0.03);
}

TEST(Gas, KeepsEnergyAndMomentumAndNobodyOverlapsOrLeaves)
{
  for (const double fill : {0.01, 0.1, 0.25})
  {
    GasKind kind;
    kind.balls = 600;
    kind.fill = fill;
    kind.heavy = 3.0;
    World world(gasScene(kind));
    const Totals before = world.totals();
    Vector3d from_walls = Vector3d::Zero();
    double all_impulses = 0.0, deepest = -1.0;
    std::size_t hits = 0;
    for (int i = 0; i < 200; ++i)
    {
      EXPECT_TRUE(world.advance(0.01).ok());
      for (const Contact& contact : world.contacts())
      {
        hits += contact.with_ball;
        if (contact.with_ball) continue;
        from_walls += contact.impulse;
        all_impulses += contact.impulse.norm();
      }
      deepest = std::max(deepest, deepestOverlap(world, edgeOf(kind)));
    }
    const Totals after = world.totals();
    const double momentum = (after.momentum - before.momentum - from_walls).norm() / all_impulses;
    std::printf("[ measured ] fill %.2f, %zu hits: energy %+.1e, momentum %.1e, deepest overlap %.1e m\n", fill, hits,
                after.kinetic / before.kinetic - 1.0, momentum, deepest);
    EXPECT_NEAR(after.kinetic / before.kinetic, 1.0, 1e-12);
    EXPECT_LT(momentum, 1e-12);
    EXPECT_LT(deepest, 1e-12);
    EXPECT_GT(deepest, -0.01);  // they do touch, or nearly: the look is not at nothing
  }
}
}  // namespace
}  // namespace ping_pong
