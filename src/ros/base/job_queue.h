// Work that other threads (services, new subscribers) hand to the thread that owns the world.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>

namespace ping_pong_sim
{
/// The world has one owner, the simulation loop. Nobody else touches it, so nothing has to be locked while it moves,
/// and a service cannot be starved by a loop that runs flat out: jobs are done between ticks.
class JobQueue
{
public:
  using Clock = std::chrono::steady_clock;
  using Job = std::function<void()>;

  /// Any thread but the owner's: has the job done and waits for that. False if the queue was closed instead.
  bool run(const Job& job);

  /// Owner: does what has come. True if there was anything.
  bool serve();
  /// Owner: does what comes until the deadline; returns early, true, after having done something.
  bool serveUntil(Clock::time_point deadline);
  /// Owner: no more jobs; those that wait are given up.
  void close();

private:
  struct Entry
  {
    const Job* job;
    bool* done;
  };
  bool serveLocked(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable arrived_;
  std::condition_variable finished_;
  std::deque<Entry> entries_;
  bool closed_ = false;
};
}  // namespace ping_pong_sim
