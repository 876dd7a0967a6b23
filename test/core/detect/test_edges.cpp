// Normals on faces, edges, corners, rims and curved sides of bodies at any pose.
#include <gtest/gtest.h>

#include <random>

#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
constexpr double kE = 0.8;
const Vector3d kHalf(0.3, 0.2, 0.1);  // of the box
constexpr double kTube = 0.15;        // radius of the cylinder, half length 0.1, and of the sphere

// A ball flies along `way` and touches the shape when its centre is at `touch`, with normal n; all in the shape's
// frame.
struct Hit
{
  const char* what;
  Shape shape;
  Vector3d touch, n, way;
};

std::vector<Hit> hits()
{
  const Shape box = boxShape(2.0 * kHalf);
  const Shape cylinder = cylinderShape(kTube, 0.2);
  const Vector3d down(0.1, -0.2, -1.0);
  const double d = 0.012;                        // outside the edge
  const double up = std::sqrt(kR * kR - d * d);  // 16 mm above it
  const double both = std::sqrt(kR * kR - 2.0 * 0.01 * 0.01);
  const double reach = kTube + kR;
  std::vector<Hit> list;
  list.push_back({"face", box, {0.05, 0.1, kHalf.z() + kR}, {0, 0, 1}, down});
  list.push_back({"edge", box, {kHalf.x() + d, 0.1, kHalf.z() + up}, Vector3d(d, 0, up) / kR, down});
  list.push_back(
      {"edge from outside", box, {-0.1, -kHalf.y() - up, -kHalf.z() - d}, Vector3d(0, -up, -d) / kR, {0.1, 1, 0.3}});
  list.push_back({"corner", box, kHalf + Vector3d(0.01, 0.01, both), Vector3d(0.01, 0.01, both) / kR, down});
  list.push_back({"cap", cylinder, {0.05, -0.08, 0.1 + kR}, {0, 0, 1}, down});
  list.push_back(
      {"rim", cylinder, {0.6 * (kTube + d), 0.8 * (kTube + d), 0.1 + up}, Vector3d(0.6 * d, 0.8 * d, up) / kR, down});
  list.push_back({"side", cylinder, {0.6 * reach, 0.8 * reach, 0.03}, {0.6, 0.8, 0}, {-1, -0.5, 0.2}});
  list.push_back({"sphere", sphereShape(kTube), {0.48 * reach, 0.6 * reach, 0.64 * reach}, {0.48, 0.6, 0.64}, down});
  return list;
}

Pose anyPose(std::mt19937& engine)
{
  const auto in = [&] { return static_cast<double>(engine()) / 2147483648.0 - 1.0; };
  const Vector3d p(in(), in(), in());
  return at(p, kPi * in(), Vector3d(in(), in(), in() + 2.0));
}

World thrownAt(const Hit& hit, const Pose& pose, Method method, double speed)
{
  const Vector3d way = hit.way.normalized();
  const Vector3d start = hit.touch - 0.3 * way;
  return SceneBuilder(method, 1e-3)
      .restitution(kE)
      .body("body", BodyKind::Static, {hit.shape}, pose)
      .ball(pose.p + pose.q * start, pose.q * (speed * way))
      .world();
}

TEST(Edges, EveryFeatureAtAnyPoseHasItsNormal)
{
  std::mt19937 engine(11);
  double normal = 0.0;
  double time = 0.0;
  double velocity = 0.0;
  for (int i = 0; i < 200; ++i)
    for (const Hit& hit : hits())
    {
      const Pose pose = anyPose(engine);
      World world = thrownAt(hit, pose, Method::Exact, 3.0);
      const std::vector<Contact> contacts = run(world, 0.05, 4);
      ASSERT_EQ(contacts.size(), 1u) << hit.what;
      const Vector3d way = hit.way.normalized();
      normal = std::max(normal, (contacts[0].n_W - pose.q * hit.n).norm());
      time = std::max(time, std::abs(contacts[0].time - 0.1));
      const Vector3d after = 3.0 * (way - (1.0 + kE) * hit.n.dot(way) * hit.n);
      velocity = std::max(velocity, (velocityOf(world) - pose.q * after).norm());
    }
  measured("200 poses, 8 features: worst normal", normal);
  measured("worst time [s]", time);
  measured("worst velocity [m/s]", velocity);
  // Positions are rounded to 2e-16 m; a normal is a difference of positions over 20 mm.
  EXPECT_LE(normal, 1e-13);
  EXPECT_LE(time, 1e-14);
  EXPECT_LE(velocity, 1e-12);
}

TEST(Edges, SampledContactsTurnTheNormalOfAnEdge)
{
  const Hit edge = hits()[1];
  double worst = 0.0;
  for (int i = 0; i < 20; ++i)
  {
    World world = thrownAt(edge, at({0, 0, 0}), Method::EulerSemiImplicit, 8.0 + 0.1 * i);
    const std::vector<Contact> contacts = run(world, 1e-3, 60);
    ASSERT_GE(contacts.size(), 1u);
    worst = std::max(worst, std::acos(std::min(1.0, contacts[0].n_W.dot(edge.n))));
  }
  measured("semi-implicit, 9 m/s, 1 ms, edge: normal turned by [deg]", worst * 180.0 / kPi);
  EXPECT_GT(worst, 0.1);
}

TEST(Edges, ADropTwelveMillimetresOutsideTheEdgeIsThrownSideways)
{
  const double d = 0.012;
  const double up = std::sqrt(kR * kR - d * d);
  World world =
      SceneBuilder().gravity(kG).box("table", {1, 1, 0.1}, at({-0.5, 0, -0.05})).ball({d, 0, up + 0.3}).world();
  const std::vector<Contact> contacts = run(world, 0.01, 26);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].time, std::sqrt(0.6 / kG), 1e-15);
  EXPECT_LE((contacts[0].n_W - Vector3d(d, 0, up) / kR).norm(), 1e-14);
  const double v = std::sqrt(0.6 * kG);
  // The turn of a velocity by twice the angle of the normal: (sin 2a, cos 2a) with sin a = 0.6.
  EXPECT_LE((contacts[0].v_after - v * Vector3d(0.96, 0, 0.28)).norm(), 1e-13);
  EXPECT_LE((contacts[0].p_WC - Vector3d(0, 0, 0)).norm(), 1e-15);
}

TEST(Edges, AFaceReachesExactlyToItsEdge)
{
  for (const double x : {-1e-9, 0.0, 1e-9})
  {
    World world = SceneBuilder().box("table", {1, 1, 0.1}, at({-0.5, 0, -0.05})).ball({x, 0, 0.1}, {0, 0, -1}).world();
    run(world, 0.1, 2);
    // A nanometre outside tilts the normal by 1e-9 / 20 mm.
    EXPECT_NEAR(velocityOf(world).x(), x > 0.0 ? 2.0 * x / kR : 0.0, 1e-14);
    EXPECT_NEAR(velocityOf(world).z(), 1.0, 1e-14);
  }
}
}  // namespace
}  // namespace ping_pong
