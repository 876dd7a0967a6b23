// A loop shared by threads: all of it, once, and over when it says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include "base/thread_pool.h"

namespace ping_pong
{
namespace
{
TEST(Workers, DoEveryIndexOnceInPiecesNoLargerThanTheGrain)
{
  for (const std::size_t count : {1, 2, 3, 8})
  {
    Workers workers;
    workers.start(count);
    EXPECT_EQ(workers.count(), count);
    for (const std::size_t size : {0, 1, 6, 7, 8, 1000})
    {
      std::vector<int> done(size, 0);
      std::atomic<std::size_t> largest{0}, highest_worker{0};
      workers.each(size, 7,
                   [&](std::size_t begin, std::size_t end, std::size_t worker)
                   {
                     for (std::size_t i = begin; i < end; ++i) ++done[i];
                     for (std::size_t most = largest;
                          end - begin > most && !largest.compare_exchange_weak(most, end - begin);)
                       continue;
                     for (std::size_t most = highest_worker;
                          worker > most && !highest_worker.compare_exchange_weak(most, worker);)
                       continue;
                   });
      EXPECT_EQ(done, std::vector<int>(size, 1)) << count;
      EXPECT_LT(highest_worker, count);
      EXPECT_LE(largest, count > 1 ? 7u : size);
    }
  }
}

TEST(Workers, TheCallerIsOneOfThemAndAloneOnTheOnlyPiece)
{
  Workers workers;
  workers.start(3);
  std::size_t pieces = 0;
  std::thread::id who;
  workers.each(10, 10,
               [&](std::size_t begin, std::size_t end, std::size_t worker)
               {
                 ++pieces;
                 who = std::this_thread::get_id();
                 EXPECT_EQ(end - begin, 10u);
                 EXPECT_EQ(worker, 0u);
               });
  EXPECT_EQ(pieces, 1u);
  EXPECT_EQ(who, std::this_thread::get_id());
}

TEST(Workers, AreAllThereWhenThePiecesWaitForEachOther)
{
  Workers workers;
  workers.start(3);
  std::atomic<int> here{0};
  std::vector<std::size_t> seen(3);
  workers.each(3, 1,
               [&](std::size_t begin, std::size_t, std::size_t worker)
               {
                 seen[begin] = worker;
                 ++here;
                 while (here < 3) std::this_thread::yield();  // no piece ends before three have begun
               });
  EXPECT_EQ(std::set<std::size_t>(seen.begin(), seen.end()), (std::set<std::size_t>{0, 1, 2}));
}

TEST(Workers, OneCallAfterAnotherLosesNothing)
{
  for (const std::size_t count : {2, 8})
  {
    Workers workers;
    workers.start(count);
    std::vector<long> sum(count, 0);  // each worker its own
    constexpr long kCalls = 20000;
    for (long call = 0; call < kCalls; ++call)
    {
      std::vector<int> before(16, 0);
      workers.each(16, 2,
                   [&](std::size_t begin, std::size_t end, std::size_t worker)
                   {
                     for (std::size_t i = begin; i < end; ++i) before[i] = 1;
                     sum[worker] += static_cast<long>(end - begin);
                   });
      ASSERT_EQ(std::count(before.begin(), before.end(), 1), 16) << call;
    }
    EXPECT_EQ(std::accumulate(sum.begin(), sum.end(), 0L), 16 * kCalls);
  }
}

// A pause of that length sends threads to sleep that have nothing to do, and a piece of it the caller that waits for it.
TEST(Workers, WakeEachOther)
{
  constexpr std::chrono::milliseconds kLong(5);
  Workers workers;
  workers.start(3);
  for (int call = 0; call < 10; ++call)
  {
    std::atomic<int> here{0}, done{0};
    std::this_thread::sleep_for(kLong);
    workers.each(3, 1,
                 [&](std::size_t, std::size_t, std::size_t worker)
                 {
                   ++here;
                   while (here < 3) std::this_thread::yield();
                   if (worker != 0) std::this_thread::sleep_for(kLong);
                   ++done;
                 });
    ASSERT_EQ(done, 3) << call;
  }
}

TEST(Workers, CanBeAnotherNumberLater)
{
  Workers workers;
  for (const std::size_t count : {1, 4, 2, 2, 1, 3})
  {
    workers.start(count);
    EXPECT_EQ(workers.count(), count);
    std::atomic<std::size_t> done{0};
    workers.each(100, 1, [&](std::size_t begin, std::size_t end, std::size_t) { done += end - begin; });
    EXPECT_EQ(done, 100u);
  }
}
}  // namespace
}  // namespace ping_pong
