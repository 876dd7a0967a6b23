// Values that are there or not, in memory that threads share.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "evolve/flight.h"
#include "testing/allocations.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
struct Value
{
  double number = 1.0;
  double room[20] = {};
};

TEST(Pooled, IsNotThereBeforeItIsMade)
{
  Pooled<Value> value;
  EXPECT_FALSE(value);
  EXPECT_EQ(value.make().number, 1.0);
  EXPECT_TRUE(value);
  value->number = 2.0;
  EXPECT_EQ(value.make().number, 2.0) << "there already";
  value.reset();
  EXPECT_FALSE(value);
}

TEST(Pooled, CopiesAreDeep)
{
  Pooled<Value> a;
  a.make().number = 2.0;
  Pooled<Value> b = a;
  b->number = 3.0;
  EXPECT_EQ(a->number, 2.0);
  a = b;
  EXPECT_EQ(a->number, 3.0);
  EXPECT_NE(&*a, &*b);
  a = Pooled<Value>();
  EXPECT_FALSE(a);
  b = a;
  EXPECT_FALSE(b);
}

TEST(Pooled, AssignmentReusesWhatIsThere)
{
  Pooled<Value> a, b;
  const Value* place = &a.make();
  b.make().number = 5.0;
  a = b;
  EXPECT_EQ(&*a, place);
  EXPECT_EQ(a->number, 5.0);
  const Pooled<Value>& itself = a;
  a = itself;
  EXPECT_EQ(a->number, 5.0);
}

TEST(Pooled, MovesLeaveNothingBehind)
{
  Pooled<Value> a;
  const Value* place = &a.make();
  Pooled<Value> b = std::move(a);
  EXPECT_EQ(&*b, place);
  Pooled<Value> c;
  c.make();
  c = std::move(b);
  EXPECT_EQ(&*c, place);
  EXPECT_FALSE(b);
}

TEST(Pooled, BytesAreCounted)  // for the tests that follow
{
  const long before = allocated;
  const std::vector<Value> values(100);
  EXPECT_EQ(allocated - before, static_cast<long>(values.size() * sizeof(Value)));
}

// As many as one thread has, in rounds, all made there and given back here.
TEST(Pooled, WhatOneThreadTakesAndAnotherGivesBackDoesNotGrow)
{
  constexpr std::size_t kValues = 1000;
  std::vector<Pooled<Value>> values(kValues);
  const auto round = [&]
  {
    std::thread(
        [&]
        {
          for (Pooled<Value>& value : values) value.make();
        })
        .join();
    for (Pooled<Value>& value : values) value.reset();
  };
  round();
  const long before = allocated;
  for (int i = 0; i < 50; ++i) round();
  EXPECT_LT(allocated - before, static_cast<long>(kValues * sizeof(Value)))
      << "50 threads, " << kValues << " values each";
}

TEST(Pooled, ThreadsThatLiveOnExchangeWhatTheyGiveBack)
{
  constexpr std::size_t kValues = 1000;
  std::vector<Pooled<Value>> values(kValues);
  std::atomic<int> turn{0};
  std::atomic<long> after_first{0};
  std::thread other(
      [&]
      {
        for (int i = 0; i < 50; ++i)
        {
          while (turn != 2 * i) std::this_thread::yield();
          for (Pooled<Value>& value : values) value.make();
          turn = 2 * i + 1;
        }
      });
  for (int i = 0; i < 50; ++i)
  {
    while (turn != 2 * i + 1) std::this_thread::yield();
    for (Pooled<Value>& value : values) value.reset();
    if (i == 0) after_first = allocated.load();
    turn = 2 * i + 2;
  }
  other.join();
  EXPECT_LT(allocated - after_first, static_cast<long>(100 * sizeof(Value)));
}

TEST(Pooled, ReservedMemoryIsThere)
{
  constexpr std::size_t kValues = 5000;
  std::vector<Pooled<Value>> values(kValues);
  Pooled<Value>::reserve(kValues, 1);
  const long before = allocated;
  for (Pooled<Value>& value : values) value.make();
  EXPECT_EQ(allocated - before, 0);
}

const Vector3d kDown{0, 0, -kG};

BallState thrown()
{
  BallState state;
  state.p_WB = {0, 0, 1};
  state.v_WB = {1, 2, 3};
  state.w_WB = {10, 20, 30};
  return state;
}

Forces air()
{
  Forces forces;
  forces.gravity = kDown;
  forces.drag = forces.magnus = true;
  forces.spin_decay = 0.1;
  return forces;
}

void fly(const Forces& forces, Segment& path)
{
  fly(thrown(), 0.0, FlightModel(forces, BallParams()), 1e-6, path);
}

TEST(Segment, FlightInVacuumOwnsNothing)
{
  Segment path;
  fly(air(), path);
  EXPECT_TRUE(path.higher);
  Forces vacuum;
  vacuum.gravity = kDown;
  fly(vacuum, path);
  EXPECT_FALSE(path.higher);
  EXPECT_EQ(path.degree, 2);
  EXPECT_EQ(path.aLow(), kDown);
  EXPECT_EQ(path.aHigh(), kDown);
  EXPECT_FALSE(flyParabola(thrown(), 0.0, kDown).higher);
}

TEST(Segment, ACopyIsAPathOfItsOwn)
{
  Segment path;
  fly(air(), path);
  const Segment copy = path;
  const BallState before = path.state(0.5 * path.end);
  fly(Forces(), path);
  const BallState after = copy.state(0.5 * copy.end);
  EXPECT_EQ(after.p_WB, before.p_WB);
  EXPECT_EQ(after.v_WB, before.v_WB);
  EXPECT_EQ(after.w_WB, before.w_WB);
  EXPECT_EQ(after.q_WB.coeffs(), before.q_WB.coeffs());
  path = copy;
  EXPECT_EQ(path.acceleration(0.1), copy.acceleration(0.1));
}
}  // namespace
}  // namespace ping_pong
