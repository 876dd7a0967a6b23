// Once it has run for a while, moving the world on takes no memory from the heap.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "scene_builder.h"

namespace
{
std::atomic<long> allocations{0};
}  // namespace

void* operator new(std::size_t size)
{
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace ping_pong
{
namespace
{
Scene bouncingBalls(Method method)
{
  SceneBuilder builder(method, 1e-3);
  builder.gravity(kG).floor().box("table", {1, 1, 0.1}, at({0, 0, 0.5}));
  builder.paddle("paddle", boxShape({0.02, 0.2, 0.2}), at({-0.4, 0, 1}));
  for (int i = 0; i < 6; ++i) builder.ball({0.1 * i - 0.2, 0.01 * i, 0.7 + 0.01 * i}, {0, 0, 0.1 * i});
  return builder.build();
}

// While balls bounce and a paddle swings; the first seconds show how much room the records need.
long allocationsOfASecond(Method method)
{
  World world(bouncingBalls(method));
  const auto second = [&]
  {
    for (int i = 0; i < 100; ++i)
    {
      world.command(2, velocityCommand({i % 20 < 10 ? 0.5 : -0.5, 0, 0}, {0, 1.0, 0}));
      world.advance(0.01);
    }
  };
  for (int i = 0; i < 5; ++i) second();
  const long before = allocations;
  second();
  return allocations - before;
}

TEST(Allocations, TheCounterCounts)
{
  const long before = allocations;
  const std::vector<int> something(100);
  EXPECT_EQ(allocations - before, 1) << something.size();
}

TEST(Allocations, NoneInASecondOfBounces)
{
  // Records grow with the busiest tick and the largest group of balls so far: that may happen once or twice more in 100 ticks.
  for (const Method method : kMethods) EXPECT_LE(allocationsOfASecond(method), 2) << name(method);
}
}  // namespace
}  // namespace ping_pong
