// The hash of a world's state: equal for equal bits, another one for any other bit.
#include <gtest/gtest.h>

#include <chrono>
#include <set>

#include "ping_pong_sim/scene_loader.h"
#include "ping_pong_sim/state_hash.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
SceneBuilder twoBalls()
{
  SceneBuilder builder;
  builder.ball({0.1, 0.2, 0.3}, {1, 2, 3}).ball({1, 0, 0}, {0, -1, 0});
  return builder;
}

BallState oddState()
{
  BallState state;
  state.p_WB = {0.1, 0.2, 0.3};
  state.q_WB = Quaterniond(0.5, 0.5, 0.5, 0.5);
  state.v_WB = {1, 2, 3};
  state.w_WB = {4, 5, 6};
  return state;
}

std::uint64_t hashWith(const BallState& state)
{
  Scene scene = twoBalls().build();
  scene.balls[0].state = state;
  return stateHash(World(scene));
}

TEST(StateHash, IsTheSameForTheSameState)
{
  EXPECT_EQ(stateHash(twoBalls().world()), stateHash(twoBalls().world()));
  EXPECT_EQ(hashWith(oddState()), hashWith(oddState()));
}

TEST(StateHash, FeelsTheLastBitOfEveryNumberOfABall)
{
  std::set<std::uint64_t> seen = {hashWith(oddState())};
  std::size_t changes = 0;
  for (Vector3d BallState::*part : {&BallState::p_WB, &BallState::v_WB, &BallState::w_WB})
    for (int axis = 0; axis < 3; ++axis)
    {
      BallState state = oddState();
      (state.*part)[axis] = std::nextafter((state.*part)[axis], 10.0);
      seen.insert(hashWith(state));
      ++changes;
    }
  // A turn by 1e-15 leaves a quaternion of length 1.
  for (int axis = 0; axis < 3; ++axis)
  {
    BallState state = oddState();
    state.q_WB.coeffs()[axis] += 4e-16;
    seen.insert(hashWith(state));
    ++changes;
  }
  EXPECT_EQ(seen.size(), 1 + changes);
}

TEST(StateHash, FeelsTimeIdsAndNumberOfBalls)
{
  World still = SceneBuilder().ball({0, 0, 0}).world();
  const std::uint64_t before = stateHash(still);
  still.advance(0.5);  // nothing but the time changes
  EXPECT_NE(stateHash(still), before);

  World both = twoBalls().world(), only_second = twoBalls().world();
  only_second.deleteBall(0);
  EXPECT_NE(stateHash(both), stateHash(only_second));
  Scene lone = twoBalls().build();
  lone.balls.erase(lone.balls.begin());
  EXPECT_NE(stateHash(World(lone)), stateHash(only_second));  // the same ball by another number
}

TEST(StateHash, OfThousandsOfBallsTakesFewMicroseconds)
{
  SceneBuilder builder;
  constexpr int kSide = 10;
  for (int i = 0; i < kSide * kSide * kSide; ++i)
    builder.ball({0.1 * (i % kSide), 0.1 * (i / kSide % kSide), 0.1 * (i / kSide / kSide)}, {0.1, 0.2, 0.3});
  World world = builder.world();
  using Clock = std::chrono::steady_clock;
  double best = 1.0;
  std::set<std::uint64_t> seen;
  for (int repeat = 0; repeat < 20; ++repeat)
  {
    const Clock::time_point begin = Clock::now();
    seen.insert(stateHash(world));
    best = std::min(best, std::chrono::duration<double>(Clock::now() - begin).count());
  }
  EXPECT_EQ(seen.size(), 1u);
  measured("hash, per ball [us]", 1e6 * best / (kSide * kSide * kSide));
  EXPECT_LT(best, 1e-3);  // 1 us per ball: ten times a usual machine's
}
}  // namespace
}  // namespace ping_pong
