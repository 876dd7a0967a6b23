// A solver cut into fewer slabs than before: nothing is left of what the slabs that are gone had found.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "testing/solver_run.h"

namespace ping_pong
{
namespace
{
// --- impacts ---

constexpr double kApart = 0.1;            // pairs of balls, in a lattice [m]
constexpr double kClosing = 0.1;          // speed at which the balls of a pair approach each other [m/s]
constexpr int kColumns = 20, kRows = 15;  // 600 balls: threads share them
constexpr int kSteps = 10;

// The balls of a pair meet in the middle of one of the steps; neighbours do so in different ones.
double meetingTime(int pair)
{
  return kStep * (0.5 + 7 * pair % kSteps);
}

// Pair i has balls 2 i and 2 i + 1, equal and elastic. Nothing else ever meets.
Scene pairsThatMeet()
{
  SceneBuilder builder(Method::Impulse, kStep);
  builder.gravity(0.0);
  for (int i = 0; i < kColumns * kRows; ++i)
  {
    const Vector3d middle(kApart * (i % kColumns), 0, kApart * (i / kColumns));
    const Vector3d half(0, kR + 0.5 * kClosing * meetingTime(i), 0), v(0, 0.5 * kClosing, 0);
    builder.ball(middle - half, v).ball(middle + half, -v);
  }
  return builder.build();
}

// Everything is sped up half-way: ways in a step get longer than the lattice is wide, and few slabs are wide enough for them.
std::vector<BallState> speedUpBetweenImpacts(std::size_t threads)
{
  SolverRun run(pairsThatMeet(), threads);
  const Vector3d faster(0, 0, 300);
  for (int i = 0; i < kSteps / 2; ++i) run.step();
  const std::size_t slabs = run.slabs();
  run.speedUp(faster);
  for (int i = kSteps / 2; i < kSteps; ++i) run.step();
  EXPECT_LT(run.slabs(), slabs);
  std::printf("[ measured ] slabs before and after: %zu, %zu\n", slabs, run.slabs());

  std::set<BallId> met;
  for (const Contact& contact : run.world.contacts)
  {
    const int pair = static_cast<int>(contact.ball / 2);
    EXPECT_EQ(contact.other_ball / 2, contact.ball / 2) << "neither ball of another pair";
    EXPECT_NEAR(contact.time, meetingTime(pair), 1e-9) << "pair " << pair;  // of rounding at 300 m/s
    EXPECT_TRUE(met.insert(contact.ball / 2).second) << "pair " << pair << " has met before";
  }
  EXPECT_EQ(met.size(), static_cast<std::size_t>(kColumns * kRows));
  std::vector<BallState> states;
  for (std::size_t i = 0; i < run.world.balls.size(); ++i)
  {
    states.push_back(run.state(i));
    const Vector3d parting(0, (i % 2 == 0 ? -0.5 : 0.5) * kClosing, 0);
    EXPECT_LE((states.back().v_WB - faster - parting).norm(), 1e-9) << "ball " << i;
  }
  return states;
}

TEST(Slabs, NoImpactIsHandledThatASlabHadFoundWhichIsGone)
{
  const std::vector<BallState> alone = speedUpBetweenImpacts(1), shared = speedUpBetweenImpacts(2);
  ASSERT_EQ(shared.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i)
  {
    EXPECT_EQ(shared[i].p_WB, alone[i].p_WB) << "ball " << i;
    EXPECT_EQ(shared[i].v_WB, alone[i].v_WB) << "ball " << i;
  }
}

// --- balls to wake up ---

constexpr std::uint32_t kLying = 128;   // in several slabs
constexpr std::uint32_t kGone = 70;     // the first of them, later; those that are left are too few for two slabs
constexpr std::uint32_t kCarrier = 40;  // one of them, not in the first slab

// Balls in a row on the floor, too far from each other to touch.
Scene ballsInARow()
{
  SceneBuilder builder(Method::Impulse, kStep);
  builder.gravity(kG).floor();
  for (std::uint32_t i = 0; i < kLying; ++i) builder.ball({kApart * i, 0, kR});
  return builder.build();
}

std::size_t asleep(const SolverRun& run)
{
  return static_cast<std::size_t>(std::count_if(run.world.balls.begin(), run.world.balls.end(),
                                                [](const BallRecord& ball) { return ball.asleep(); }));
}

// The slab that is about to wake somebody up, or none: as many as there are.
std::size_t wakingSlab(const SolverRun& run)
{
  const auto begin = run.world.solver.slabs.begin(), end = begin + static_cast<std::ptrdiff_t>(run.slabs());
  return static_cast<std::size_t>(
      std::find_if(begin, end, [](const SolverSlab& slab) { return !slab.waking.empty(); }) - begin);
}

// A ball is laid on one of them, which wakes up and is gone the next moment, with many others and its slab. Where it was in the
// lists of the solver there is now a ball that nobody has touched.
TEST(Slabs, WhoLiesAloneIsNotWokenUpByASlabThatIsGone)
{
  SolverRun run(ballsInARow(), 1);
  for (int i = 0; i < 500 && asleep(run) < kLying; ++i) run.step();
  ASSERT_EQ(asleep(run), kLying);
  run.step();
  EXPECT_FALSE(run.world.solver.anyAwake()) << "fewer slabs than there could be";
  SceneBall load = run.world.scene.balls[kCarrier];
  load.state.p_WB.z() += 2.0 * kR + 1e-5;
  run.add(load);
  for (int i = 0; i < 10 && asleep(run) == kLying; ++i) run.step();
  ASSERT_EQ(asleep(run), kLying - 1);
  const std::size_t waking = wakingSlab(run);
  ASSERT_LT(waking, run.slabs());

  for (std::uint32_t i = kGone; i-- > 0;) run.remove(i);
  const std::size_t left = run.world.balls.size();
  for (int i = 0; i < 30; ++i)
  {
    run.step();
    ASSERT_LE(run.slabs(), waking);
    EXPECT_EQ(asleep(run), left - 1) << "all but the one that falls, step " << i;
  }
}
}  // namespace
}  // namespace ping_pong
