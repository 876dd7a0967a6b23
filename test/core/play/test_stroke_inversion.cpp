// The contact law inverted: bounce() with the racket found gives the ball that was asked for.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/random.h"
#include "play/stroke_inversion.h"
#include "testing/scene_builder.h"

namespace ping_pong::play
{
namespace
{
const BallParams kBall;

Surface rubber(double friction = std::numeric_limits<double>::infinity())
{
  Surface law;
  law.restitution = 0.917;
  law.restitution_slope = 0.0217;
  law.friction = friction;
  law.tangential_restitution = 0.7;
  return law;
}

BallState comingBall(Random& random)
{
  BallState ball;
  ball.v_WB = {random.uniform(-20.0, -1.0), random.uniform(-3.0, 3.0), random.uniform(-6.0, 6.0)};
  ball.w_WB = random.uniform(0.0, 600.0) * random.direction();
  return ball;
}

Vector3d wantedVelocity(Random& random)
{
  return {random.uniform(3.0, 20.0), random.uniform(-4.0, 4.0), random.uniform(-5.0, 6.0)};
}

struct Residual
{
  double v = 0.0, w = 0.0;
};

Residual residualOf(const Surface& law, const BallState& before, const RacketImpact& impact, const Vector3d& v_out)
{
  BallState after = before;
  bounce(law, kBall, after, impact.v_WP, impact.n_W);
  return {(after.v_WB - v_out).norm(), (after.w_WB - impact.w_out).norm()};
}

TEST(StrokeInversion, BounceGivesWhatWasAskedFor)
{
  Random random(1, 0);
  Residual worst;
  std::size_t spin_reached = 0;
  constexpr int kCases = 20000;
  for (int i = 0; i < kCases; ++i)
  {
    const BallState before = comingBall(random);
    const Vector3d v_out = wantedVelocity(random), w_wanted = random.uniform(0.0, 450.0) * random.direction();
    const auto impact = invertStroke(rubber(), kBall, before, v_out, w_wanted);
    ASSERT_TRUE(impact) << i;
    const Residual residual = residualOf(rubber(), before, *impact, v_out);
    worst.v = std::max(worst.v, residual.v);
    worst.w = std::max(worst.w, residual.w);
    const Vector3d along = (v_out - before.v_WB).normalized();
    const Vector3d missing = w_wanted - impact->w_out;
    spin_reached += (missing - along.dot(missing) * along).norm() < 1e-6;
    EXPECT_EQ(impact->w_out, reachableSpin(rubber(), kBall, before, v_out, w_wanted));
  }
  measured("velocity off by at most [m/s]", worst.v);
  measured("spin off by at most [rad/s]", worst.w);
  measured("spin across the impulse reached in a part of", static_cast<double>(spin_reached) / kCases);
  EXPECT_LT(worst.v, 1e-9);
  EXPECT_LT(worst.w, 1e-9);
  EXPECT_GT(spin_reached, kCases / 2u);
}

TEST(StrokeInversion, AlsoAtTheLimitOfFriction)
{
  Random random(2, 0);
  for (int i = 0; i < 5000; ++i)
  {
    const Surface law = rubber(random.uniform(0.1, 1.5));
    const BallState before = comingBall(random);
    const Vector3d v_out = wantedVelocity(random);
    const auto impact = invertStroke(law, kBall, before, v_out, 2000.0 * random.direction());
    ASSERT_TRUE(impact) << i;
    const Residual residual = residualOf(law, before, *impact, v_out);
    EXPECT_LT(residual.v, 1e-9);
    EXPECT_LT(residual.w, 1e-9);
    const Vector3d J = v_out - before.v_WB;
    const double lean = std::acos(std::min(1.0, impact->n_W.dot(J) / J.norm()));
    EXPECT_LE(std::tan(lean), law.friction * (1.0 + 1e-6));
  }
}

TEST(StrokeInversion, SpinAlongTheImpulseIsOutOfReach)
{
  BallState before;
  before.v_WB = {-5, 0, 0};
  before.w_WB = {30, -100, 0};
  const Vector3d w = reachableSpin(rubber(), kBall, before, {7, 0, 0}, {200, 80, 0});
  EXPECT_NEAR(w.x(), 30.0, 1e-12);
  EXPECT_NEAR(w.y(), 80.0, 1e-12);
}

TEST(StrokeInversion, SmoothFacesLeaveTheSpin)
{
  Random random(3, 0);
  for (int i = 0; i < 1000; ++i)
  {
    const BallState before = comingBall(random);
    const Vector3d v_out = wantedVelocity(random);
    const auto impact = invertStroke(rubber(0.0), kBall, before, v_out, {0, 400, 0});
    ASSERT_TRUE(impact);
    EXPECT_EQ(impact->w_out, before.w_WB);
    EXPECT_LT(residualOf(rubber(0.0), before, *impact, v_out).v, 1e-9);
  }
}

TEST(StrokeInversion, FasterThanAllRestitution)
{
  Surface soft = rubber();
  soft.restitution_slope = 0.1;  // none is left from 9.2 m/s on
  BallState before;
  before.v_WB = {-10, 0, 0};
  const Vector3d v_out(8, 0, 0);
  const auto impact = invertStroke(soft, kBall, before, v_out, Vector3d::Zero());
  ASSERT_TRUE(impact);
  EXPECT_LT(residualOf(soft, before, *impact, v_out).v, 1e-9);
  EXPECT_NEAR(impact->v_WP.x(), 8.0, 1e-9);  // it takes the ball along
}

TEST(StrokeInversion, RefusesWhatNoSurfaceDoes)
{
  BallState before;
  before.v_WB = {-5, 0, 0};
  EXPECT_FALSE(invertStroke(rubber(), kBall, before, before.v_WB, {0, 100, 0}));
  EXPECT_FALSE(surfaceVelocityFor(rubber(), kBall, before, {-1e-2, 0, 0}, Vector3d::UnitX()));       // pulls
  EXPECT_FALSE(surfaceVelocityFor(rubber(0.5), kBall, before, {1e-2, 1e-2, 0}, Vector3d::UnitX()));  // slides
  Surface stops = rubber();
  stops.tangential_restitution = -1.0;  // friction without effect
  EXPECT_FALSE(surfaceVelocityFor(stops, kBall, before, {1e-2, 1e-3, 0}, Vector3d::UnitX()));
}
}  // namespace
}  // namespace ping_pong::play
