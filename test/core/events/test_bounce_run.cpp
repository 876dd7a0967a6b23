// The short way through a bounce leaves the same bits as the general one, which a paddle that moves somewhere far away enforces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
struct Course
{
  std::vector<Contact> contacts;
  BallState end;
};

Course courseOf(Scene scene, bool short_way, double duration)
{
  if (!short_way)
  {
    SceneBuilder far;
    scene.bodies.push_back(far.paddle("far", boxShape({0.1, 0.1, 0.1}), at({0, 1e3, 1e3})).build().bodies.back());
  }
  World world(scene);
  if (!short_way) world.command(world.bodyCount() - 1, velocityCommand({0, 0, 1e-3}, {0, 0, 0}));
  Course course;
  for (int tick = 0; tick < 20; ++tick)
  {
    world.advance(duration / 20.0);
    course.contacts.insert(course.contacts.end(), world.contacts().begin(), world.contacts().end());
  }
  course.end = world.ballState(0);
  return course;
}

bool sameBits(const Vector3d& a, const Vector3d& b)
{
  return std::memcmp(a.data(), b.data(), sizeof(double) * 3) == 0;
}

void expectSameBits(const Scene& scene, double duration, std::size_t least_contacts)
{
  const Course quick = courseOf(scene, true, duration), general = courseOf(scene, false, duration);
  EXPECT_GE(quick.contacts.size(), least_contacts);
  ASSERT_EQ(quick.contacts.size(), general.contacts.size());
  for (std::size_t i = 0; i < quick.contacts.size(); ++i)
  {
    const Contact &a = quick.contacts[i], &b = general.contacts[i];
    ASSERT_EQ(a.time, b.time) << i;
    ASSERT_TRUE(sameBits(a.p_WC, b.p_WC) && sameBits(a.v_before, b.v_before) && sameBits(a.v_after, b.v_after)) << i;
    ASSERT_TRUE(sameBits(a.impulse, b.impulse) && sameBits(a.n_W, b.n_W) && sameBits(a.w_after, b.w_after)) << i;
  }
  EXPECT_TRUE(sameBits(quick.end.p_WB, general.end.p_WB));
  EXPECT_TRUE(sameBits(quick.end.v_WB, general.end.v_WB));
}

TEST(BounceRun, ElasticBouncesForAMinute)
{
  expectSameBits(SceneBuilder().gravity(kG).floor().restitution(1.0).ball({0, 0, 0.3}, {0.5, -0.1, 0.2}).build(), 60.0,
                 100);
}

TEST(BounceRun, BouncesThatEndAtRest)
{
  expectSameBits(SceneBuilder().gravity(kG).floor().restitution(0.7).ball({0, 0, 1.0}, {0.3, 0, 0}).build(), 6.0, 20);
}

TEST(BounceRun, AnObliqueField)
{
  Scene scene = SceneBuilder().gravity(kG).floor().restitution(0.9).ball({0, 0, 0.7}, {0.1, 0.2, 0.3}).build();
  scene.forces.gravity = {0.7, -0.3, -9.7};
  scene.surfaces.set(scene.balls[0].params.material, scene.bodies[0].shapes[0].material,
                     []
                     {
                       Surface law;
                       law.restitution = 0.95;
                       law.restitution_slope = 0.01;
                       return law;
                     }());
  expectSameBits(scene, 20.0, 30);
}

TEST(BounceRun, DownASlopeThatIsAllThereIs)
{
  Shape half_space;
  half_space.kind = ShapeKind::HalfSpace;
  SceneBuilder builder;
  builder.gravity(kG).restitution(0.9).body("slope", BodyKind::Static, {half_space}, at({0, 0, 0}, 0.2, {1, 2, 0}));
  expectSameBits(builder.ball({0, 0, 0.5}).build(), 4.0, 6);
}

TEST(BounceRun, FlightsLongerThanTheHorizonAndABoxOnTheWay)
{
  expectSameBits(SceneBuilder().gravity(kG).floor().restitution(1.0).ball({0, 0, 40.0}, {0.5, 0, 0}).build(), 60.0, 5);
  expectSameBits(SceneBuilder()
                     .gravity(kG)
                     .floor()
                     .restitution(1.0)
                     .box("box", {0.2, 1, 0.2}, at({2, 0, 0.3}))
                     .ball({0, 0, 0.5}, {0.5, 0, 0})
                     .build(),
                 20.0, 20);
}

// Many bounces of a window leave only the box that they were in, in which others have to find the ball.
TEST(BounceRun, ABallThatFliesIntoManyBouncesOfAWindowHits)
{
  const Scene scene =
      SceneBuilder().gravity(kG).floor().restitution(1.0).ball({0, 0, 0.06}).ball({-3, 0, 0.055}, {3, 0, 4.9}).build();
  World long_windows(scene), short_windows(scene);
  const StepStatus status = long_windows.advance(1.4);
  EXPECT_GT(status.contacts, 1u);
  const std::vector<Contact>& contacts = long_windows.contacts();
  EXPECT_TRUE(std::any_of(contacts.begin(), contacts.end(), [](const Contact& contact) { return contact.with_ball; }));
  for (int tick = 0; tick < 1400; ++tick) short_windows.advance(1e-3);
  for (const std::size_t ball : {0, 1})
    EXPECT_LT((long_windows.ballState(ball).p_WB - short_windows.ballState(ball).p_WB).norm(), 1e-12) << ball;
}
}  // namespace
}  // namespace ping_pong
