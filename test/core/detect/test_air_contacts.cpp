// Contacts of a ball that flies through air with shapes that stand still, against a search in tiny steps.
#include <gtest/gtest.h>

#include <random>

#include "detect/first_contact.h"
#include "evolve/flight.h"
#include "ping_pong_sim/forces.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
constexpr int kSamples = 800;  // of a path: a ball at 10 m/s moves on by 12 mm or less in between

struct Draw
{
  std::mt19937 random{5};
  double from(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  Vector3d vector(double size) { return {from(-size, size), from(-size, size), from(-size, size)}; }
};

Forces air()
{
  Forces forces;
  forces.gravity = {0, 0, -kG};
  forces.drag = forces.magnus = true;
  return forces;
}

Segment flight(Draw& draw, const Vector3d& p, const Vector3d& v)
{
  static const Forces forces = air();
  BallState start;
  start.p_WB = p;
  start.v_WB = v;
  start.w_WB = draw.vector(300.0);
  Segment path;
  fly(start, 0.0, FlightModel(forces, BallParams()), 1e-4, path);
  return path;
}

Shape drawnShape(Draw& draw, int n)
{
  const Vector3d size(draw.from(0.01, 1.0), draw.from(0.01, 1.0), draw.from(0.01, 0.3));
  const Shape shape = n % 3 == 0   ? boxShape(size)
                      : n % 3 == 1 ? cylinderShape(0.5 * size.x(), size.z())
                                   : sphereShape(0.5 * size.x());
  const Vector3d axis = draw.vector(1.0);
  // Every other box lies level, as tables do.
  return placed(shape, at(draw.vector(0.6), n % 2 == 0 ? 0.0 : draw.from(0.0, 3.0), axis));
}

double gapAt(const Segment& path, const Shape& shape, double t)
{
  return proximity(shape, path.position(t)).distance - kR;
}

// The first time at which the gap closes, or kNever; and the least gap before.
double searched(const Segment& path, const Shape& shape, double& least)
{
  least = kNever;
  const double h = path.end / kSamples;
  for (int i = 0; i <= kSamples; ++i)
  {
    const double gap = gapAt(path, shape, i * h);
    least = std::min(least, gap);
    if (gap > 0.0) continue;
    double before = (i - 1) * h, after = i * h;
    for (int k = 0; k < 60; ++k)
    {
      const double middle = 0.5 * (before + after);
      (gapAt(path, shape, middle) > 0.0 ? before : after) = middle;
    }
    return after;
  }
  return kNever;
}

TEST(AirContacts, AreWhereTheGapFirstCloses)
{
  Draw draw;
  int hits = 0, misses = 0;
  double worst = 0.0;
  for (int n = 0; n < 1000; ++n)
  {
    const Vector3d p = draw.vector(0.8);
    const Shape shape = drawnShape(draw, n);
    const Vector3d aim = (shape.p_BS - p).normalized() + draw.vector(0.3);
    const Segment path = flight(draw, p, draw.from(1.0, 8.0) * aim);
    if (gapAt(path, shape, 0.0) < 1e-9) continue;
    double least;
    const double truth = searched(path, shape, least);
    const Detection found = firstContact(path, kR, shape, 0.0, path.end);
    ASSERT_FALSE(found.undecided) << n;
    if (!found.found())
    {
      ++misses;
      ASSERT_EQ(truth, kNever) << n;  // a search in steps finds no hit that there is not
      continue;
    }
    ++hits;
    // Between two samples the ball may dip in and out again by (12 mm)^2 / (8 r), 1 mm: then only the gap can be looked at.
    ASSERT_LE(std::abs(gapAt(path, shape, found.time)), 4e-15) << n;  // rounding of positions of up to 5 m
    if (truth == kNever)
      ASSERT_LE(least, 1e-3) << n;
    else
      ASSERT_LE(found.time, truth + 1e-9) << n;
    worst = std::max(worst, std::abs(gapAt(path, shape, found.time)));
  }
  std::printf("[ measured ] %d hits, %d misses, largest gap at the reported time %.1e m\n", hits, misses, worst);
  EXPECT_GE(hits, 300);
  EXPECT_GE(misses, 300);
}

// The path of a ball that has just bounced begins in contact, and comes back to the same face.
TEST(AirContacts, ABallThatRisesFromAFaceComesBackToIt)
{
  Draw draw;
  const Shape table = placed(boxShape({100.0, 100.0, 0.02}), at({0, 0, -0.01}));
  for (int n = 0; n < 300; ++n)
  {
    const Segment path = flight(draw, {0, 0, kR}, draw.vector(7.0));
    if (path.c[1].z() <= 0.01) continue;
    const Detection found = firstContact(path, kR, table, 0.0, path.end);
    double after = 1e-3 * path.c[1].z() / kG;  // off the face by then
    ASSERT_GT(gapAt(path, table, after), 0.0);
    const double h = path.end / kSamples;
    while (after < path.end && gapAt(path, table, after) > 0.0) after += h;
    if (after >= path.end) continue;
    ASSERT_TRUE(found.found()) << n;
    EXPECT_LE(found.time, after) << n;
    EXPECT_GE(found.time, after - h) << n;
    EXPECT_LE(std::abs(gapAt(path, table, found.time)), 4e-15) << n;
  }
}
}  // namespace
}  // namespace ping_pong
