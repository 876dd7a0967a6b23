// Threads that share the work of a loop. Which of them does what differs from run to run: whoever wants the same bits
// every time lets each piece of work write what is its own, and sums up what the workers have noted in an order that
// does not depend on them.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace ping_pong
{
class Workers
{
public:
  Workers() = default;
  ~Workers() { stop(); }
  /// As many of its own.
  Workers(const Workers& other) { start(other.count()); }
  Workers& operator=(const Workers& other)
  {
    start(other.count());
    return *this;
  }

  /// So many from now on, the caller of each() among them. One alone needs no thread.
  void start(std::size_t count);
  std::size_t count() const { return threads_.size() + 1; }

  /// Calls action(begin, end, worker) for pieces of [0, size) that cover it once, and returns when all are done. Pieces
  /// have at most `grain` indices where there is more than one worker; else there is one piece. `worker` is below
  /// count(); two calls with the same one never overlap, and the caller is 0. An action neither throws nor calls
  /// each(). Each worker begins with a share of its own, the same for the same size: what a loop has left in the cache of
  /// a core is there for the next one. Whoever is done helps others.
  template <class Action>
  void each(std::size_t size, std::size_t grain, const Action& action)
  {
    each(size, nullptr, grain, action);
  }

  /// The same where worker k begins with indices from ends[k - 1], or 0, to before ends[k]: there are count() ends.
  template <class Action>
  void eachOfShares(const std::vector<std::size_t>& ends, std::size_t grain, const Action& action)
  {
    each(ends.back(), ends.data(), grain, action);
  }

private:
  template <class Action>
  void each(std::size_t size, const std::size_t* ends, std::size_t grain, const Action& action)
  {
    if (size == 0) return;
    if (threads_.empty() || size <= grain)
      action(std::size_t{0}, size, std::size_t{0});
    else
      share({[](const void* a, std::size_t begin, std::size_t end, std::size_t worker)
             { (*static_cast<const Action*>(a))(begin, end, worker); },
             &action, size, ends, grain});
  }

  struct Job
  {
    void (*call)(const void* action, std::size_t begin, std::size_t end, std::size_t worker);
    const void* action;
    std::size_t size;
    const std::size_t* ends;  ///< of shares; null: equal ones
    std::size_t grain;

    std::size_t end(std::size_t worker, std::size_t workers) const
    {
      return ends ? ends[worker] : (worker + 1) * size / workers;
    }
  };

  enum class State : std::uint32_t
  {
    Idle,
    Offered,  ///< by the caller, who takes it back in the end
    Taken,    ///< by the thread, until it is done
    Stop
  };

  /// Of a worker. A line of the cache takes over to it what it needs to begin, and back that it is done.
  struct alignas(64) WorkerSlot
  {
    std::atomic<State> state{State::Idle};
    std::atomic<std::size_t> next{0};  ///< first index of its share that nobody has taken
    Job job{};
  };

  void stop();
  void live(std::size_t worker);
  static bool take(WorkerSlot& slot);
  void share(const Job& job);
  void workOn(const Job& job, std::size_t worker);
  bool allDone() const;

  std::vector<std::thread> threads_;
  std::vector<WorkerSlot> slots_;
  std::mutex mutex_;
  std::condition_variable begun_, ended_;
  std::atomic<std::size_t> sleeping_{0};    // threads that have to be woken
  std::atomic<bool> caller_sleeps_{false};  // and has to be woken
};
}  // namespace ping_pong
