// Newton's cradle, collapse and Galperin's count: many contacts in no time.
#include <gtest/gtest.h>

#include <algorithm>

#include "stability/situations.h"

namespace ping_pong
{
namespace
{
using namespace stability;
using Line = std::vector<double>;

Line speeds(const World& world)
{
  Line v;
  for (std::size_t i = 0; i < world.ballCount(); ++i) v.push_back(velocityOf(world, i).x());
  return v;
}

// The truth for balls on a line: surfaces as points (diameters taken out), next hit by comparing all pairs, in long
// double.
struct PointsOnALine
{
  std::vector<long double> x, v, m;
  int hits = 0;

  void run(long double e, long double end)
  {
    for (long double t = 0.0L;;)
    {
      long double step = end - t;
      std::size_t pair = x.size();
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
        if (v[i] - v[i + 1] > 1e-15L && (x[i + 1] - x[i]) / (v[i] - v[i + 1]) < step)
        {
          step = std::max((x[i + 1] - x[i]) / (v[i] - v[i + 1]), 0.0L);
          pair = i;
        }
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += step * v[i];
      t += step;
      if (pair == x.size()) return;
      const long double reduced = m[pair] * m[pair + 1] / (m[pair] + m[pair + 1]);
      const long double impulse = reduced * (1.0L + e) * (v[pair] - v[pair + 1]);
      v[pair] -= impulse / m[pair];
      v[pair + 1] += impulse / m[pair + 1];
      ++hits;
    }
  }
};

TEST(Cradle, AsManyBallsLeaveAsCame)
{
  for (const double gap : {0.0, 1e-12, 1e-9, 1e-6, 1e-3})
    for (const int incoming : {1, 2, 3})
    {
      World world = cradle(5, incoming, gap).world();
      run(world, 0.01, 50);
      for (int i = 0; i < 5; ++i)
        // e = 1 and equal masses: speeds are exchanged, up to a rounding per hit.
        EXPECT_NEAR(speeds(world)[static_cast<std::size_t>(i)], i >= 5 - incoming ? 1.0 : 0.0, 1e-14)
            << "gap " << gap << ", incoming " << incoming << ", ball " << i;
      EXPECT_NEAR(world.totals().kinetic, 0.5 * kBallMass * incoming, 1e-16);
    }
}

TEST(Cradle, AnOverlapOfRoundingDoesNotCoupleTheBalls)  // row 16: 1.5e-7 m of drift halve the energy elsewhere
{
  World world = cradle(5, 1, -1.5e-7).world();
  run(world, 0.01, 50);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(speeds(world)[static_cast<std::size_t>(i)], i == 4 ? 1.0 : 0.0, 1e-14);
}

TEST(Cradle, LossyCradleFollowsTheChainOfHits)
{
  for (const double gap : {1e-6, 1e-4})
    for (const double e : {0.5, 0.8, 0.95})
    {
      World world = cradle(5, 1, gap, e).world();
      const std::size_t hits = run(world, 0.01, 300).size();
      PointsOnALine truth;
      for (int i = 0; i < 5; ++i)
      {
        truth.x.push_back(gap * i - (i == 0 ? 0.1 : 0.0));
        truth.v.push_back(i == 0 ? 1.0 : 0.0);
        truth.m.push_back(1.0);
      }
      truth.run(e, 3.0);
      EXPECT_EQ(hits, static_cast<std::size_t>(truth.hits));
      for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(speeds(world)[i], static_cast<double>(truth.v[i]), 1e-14) << "e " << e << ", ball " << i;
      EXPECT_NEAR(speeds(world)[4], std::pow(0.5 * (1.0 + e), 4), 1e-14);  // the first wave
      EXPECT_NEAR(world.totals().momentum.x(), kBallMass, 1e-17);
    }
}

TEST(Cradle, ThreeBallsThatCollapseEndInFiniteWorkTogether)
{
  for (const double e : {0.0, 0.05, 0.07})  // below 7 - 4 sqrt(3) = 0.0718 three balls meet infinitely often
    for (const double other : {-1.0, -0.6})
    {
      World world = SceneBuilder()
                        .restitution(e)
                        .ball({-0.1, 0, 0}, {1, 0, 0})
                        .ball({0, 0, 0})
                        .ball({0.1, 0, 0}, {other, 0, 0})
                        .world();
      StepStatus status;
      std::size_t events = 0;
      for (int i = 0; i < 20; ++i)
      {
        status = world.advance(0.1);
        EXPECT_TRUE(status.ok());
        events += status.events;
      }
      EXPECT_LT(events, 2000u) << e;
      const double common = (1.0 + other) / 3.0;
      // What is left when the pile-up is declared elastic: e^(n/2) of 1 m/s after n hits in a row.
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(speeds(world)[i], common, 1e-6) << "e " << e << ", ball " << i;
      EXPECT_NEAR(world.totals().momentum.x(), kBallMass * (1.0 + other), 1e-17);
      for (std::size_t i = 0; i < 2; ++i)
        EXPECT_GE(positionOf(world, i + 1).x() - positionOf(world, i).x(), 2.0 * kR - 1e-12);
    }
}

TEST(Galperin, EqualBallsMeetThreeTimes)  // the first digit of pi; more digits: test_stability.cpp
{
  EXPECT_EQ(galperinHits(Method::Exact, 1e-3, 1.0), 3u);
}
}  // namespace
}  // namespace ping_pong
