// A million random balls against blades of 1 to 15 mm, boxes and cylinders, still, moving, turning, accelerating: none
// missed, none invented. The check is hit_reference.h.
#include <gtest/gtest.h>

#include <random>

#include "detect/first_contact.h"
#include "evolve/flight.h"
#include "testing/hit_reference.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
class Dice
{
public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double in(double from, double to) { return from + (to - from) * static_cast<double>(engine_()) / 4294967296.0; }
  bool oneIn(int n) { return engine_() % static_cast<unsigned>(n) == 0; }
  Vector3d direction()
  {
    for (;;)
    {
      const Vector3d x(in(-1, 1), in(-1, 1), in(-1, 1));
      if (x.squaredNorm() < 1.0 && x.squaredNorm() > 1e-4) return x.normalized();
    }
  }

private:
  std::mt19937 engine_;  // its numbers are the same everywhere, those of <random>'s distributions are not
};

Shape blade(Dice& dice)
{
  const double thickness = dice.in(0.001, 0.015);
  if (dice.oneIn(2)) return cylinderShape(dice.in(0.05, 0.1), thickness);
  return boxShape({dice.in(0.05, 0.2), dice.in(0.05, 0.2), thickness});
}

BodyMotion motionOf(Dice& dice)
{
  BodyMotion motion;
  motion.pose = at(dice.in(0, 2) * dice.direction(), dice.in(0, kPi), dice.direction());
  if (dice.oneIn(4)) return motion;
  motion.twist.v = dice.in(0, 100) * dice.direction();
  if (dice.oneIn(2)) motion.a_WB = dice.in(0, 500) * dice.direction();
  if (dice.oneIn(3)) return motion;
  motion.twist.w = dice.in(0, 60) * dice.direction();
  if (dice.oneIn(2)) motion.alpha_WB = dice.in(0, 5000) * dice.direction();
  return motion;
}

// Aimed: at some instant of the window the ball is somewhere about the blade.
Encounter encounter(Dice& dice)
{
  Encounter e;
  e.shape = blade(dice);
  e.motion = motionOf(dice);
  e.duration = dice.in(0.5e-3, 10e-3);
  e.v = dice.in(0, 100) * dice.direction();
  e.a = Vector3d(0, 0, -kG);
  const double s = dice.in(0.0, e.duration);
  const Vector3d aim = 1.3 * e.shape.half_size.cwiseProduct(Vector3d(dice.in(-1, 1), dice.in(-1, 1), dice.in(-1, 1)));
  const Vector3d body = e.motion.pose.p + s * e.motion.twist.v + 0.5 * s * s * e.motion.a_WB;
  e.p = body + e.rotation(s) * aim - s * e.v - 0.5 * s * s * e.a;
  return e;
}

double searched(const Encounter& e)
{
  BallState state;
  state.p_WB = e.p;
  state.v_WB = e.v;
  const Segment path = flyParabola(state, 0.0, e.a);
  Detection found = firstContact(path, e.radius, e.shape, e.motion, 0.0, e.duration);
  while (found.undecided) found = firstContact(path, e.radius, e.shape, e.motion, found.time, e.duration);
  return found.time;
}

struct Tally
{
  int hits = 0, clear = 0, missed = 0, invented = 0, late = 0, inside = 0;
  double gap = 0.0;  // worst at the reported time [m]
};

// The reference stops a nanometre before the surface; from there to the reported time the ball must not be inside.
void compare(const Encounter& e, double found, Tally& tally)
{
  constexpr double kNear = 1e-9;       // [m]
  constexpr double kRounding = 1e-14;  // of positions of a few metres, two ways of turning them [m]
  const double near = firstTouch(e, kNear);
  if (found == kNever)
  {
    if (near < kNever && firstTouch(e, -1e-11) < kNever) ++tally.missed;
    ++tally.clear;
    return;
  }
  ++tally.hits;
  const double gap = e.gap(found);
  tally.gap = std::max(tally.gap, std::abs(gap));
  if (gap > 1e-12) ++tally.invented;
  if (found < near - 1e-9) ++tally.inside;
  if (near < found)
    for (int i = 1; i < 8; ++i)
      if (e.gap(near + i * (found - near) / 8.0) < -kRounding) return void(++tally.late);
}

#ifdef __OPTIMIZE__
constexpr int kHits = 1000000;
#else
constexpr int kHits = 20000;  // builds that count lines are twenty times as slow
#endif

TEST(MillionHits, NoneMissedNoneInvented)
{
  Dice dice(20);
  Tally tally;
  for (int trials = 0; trials < 2 * kHits && tally.hits < kHits; ++trials)
  {
    Encounter e = encounter(dice);
    if (e.gap(0.0) <= 1e-6) continue;
    compare(e, searched(e), tally);
  }
  measured("hits", tally.hits);
  measured("passed by", tally.clear);
  measured("worst gap at the reported time [m]", tally.gap);
  EXPECT_EQ(tally.hits, kHits);
  EXPECT_EQ(tally.missed, 0);
  EXPECT_EQ(tally.invented, 0);
  EXPECT_EQ(tally.late, 0) << "the ball was inside before the reported time";
  EXPECT_EQ(tally.inside, 0) << "reported before the reference came near";
  EXPECT_LE(tally.gap, 1e-12);  // one rounding of time at 200 m/s and of positions of 2 m
}

// The same end to end, in a world whose paddle flies and turns: from the end of the first tick, in which the drive
// reaches its speed, to the first hit.
TEST(MillionHits, AWorldFindsThemToo)
{
  constexpr double kTick = 4e-3;
  Dice dice(21);
  Tally tally;
  for (int trial = 0; trial < 5000; ++trial)
  {
    Encounter e;
    e.shape = blade(dice);
    const Twist twist{dice.in(0, 50) * dice.direction(), dice.in(0, 60) * dice.direction()};
    const Vector3d side = dice.direction();
    const double speed = dice.in(1, 100);
    World world = SceneBuilder()
                      .gravity(kG)
                      .restitution(dice.in(0, 1))
                      .paddle("paddle", e.shape, at({0, 0, 0}))
                      .ball(0.5 * side, twist.v - speed * side)
                      .world();
    world.command(0, velocityCommand(twist.v, twist.w));
    if (world.advance(kTick).contacts > 0) continue;
    e.p = positionOf(world);
    e.v = velocityOf(world);
    e.a = Vector3d(0, 0, -kG);
    e.motion.pose = world.bodyPose(0);
    e.motion.twist = twist;
    e.duration = 25.0 * kTick;
    const std::vector<Contact> hits = run(world, kTick, 25);
    compare(e, hits.empty() ? kNever : hits.front().time - kTick, tally);
  }
  measured("hits in 5000 worlds", tally.hits);
  measured("worst gap at the reported time [m]", tally.gap);
  EXPECT_GT(tally.hits, 3000);  // the rest was hit in the first tick, or the blade turned or flew away
  EXPECT_EQ(tally.missed + tally.invented + tally.late + tally.inside, 0);
  EXPECT_LE(tally.gap, 1e-12);  // 25 ticks of rounding of a path of 10 m
}
}  // namespace
}  // namespace ping_pong
