#include "base/thread_pool.h"

#include <algorithm>

namespace ping_pong
{
namespace
{
// Loops follow each other within microseconds, less than it takes to wake a sleeping thread: one looks so often before it
// sleeps. Most looks are as quick as they can be; in between, others that have something to do on this processor go first.
constexpr int kLooks = 50;
constexpr int kQuickLooks = 256;

void pause()
{
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

template <class Condition>
bool comesSoon(const Condition& condition)
{
  for (int look = 0; look < kLooks; ++look)
  {
    for (int quick = 0; quick < kQuickLooks; ++quick)
    {
      if (condition()) return true;
      pause();
    }
    std::this_thread::yield();
  }
  return condition();
}
}  // namespace

void Workers::start(std::size_t count)
{
  if (count == this->count()) return;
  stop();
  slots_ = std::vector<WorkerSlot>(count);
  for (std::size_t worker = 1; worker < count; ++worker) threads_.emplace_back([this, worker] { live(worker); });
}

void Workers::stop()
{
  for (WorkerSlot& slot : slots_) slot.state = State::Stop;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
  }
  begun_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

// A look by an exchange leaves the line with this processor, so that a job comes over with all that is in it.
bool Workers::take(WorkerSlot& slot)
{
  State offered = State::Offered;
  return slot.state.compare_exchange_strong(offered, State::Taken);
}

void Workers::live(std::size_t worker)
{
  WorkerSlot& slot = slots_[worker];
  while (slot.state != State::Stop)
  {
    if (!comesSoon([&slot] { return take(slot); }))
    {
      std::unique_lock<std::mutex> lock(mutex_);
      ++sleeping_;
      begun_.wait(lock, [&slot] { return slot.state != State::Idle; });
      --sleeping_;
      continue;
    }
    const Job job = slot.job;  // others take from its line
    workOn(job, worker);
    slot.state = State::Idle;
    if (!caller_sleeps_) continue;
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_.notify_one();
  }
}

bool Workers::allDone() const
{
  return std::all_of(slots_.begin() + 1, slots_.end(),
                     [](const WorkerSlot& slot) { return slot.state == State::Idle; });
}

// A worker that has not come to the job when there is nothing left to do is not waited for.
void Workers::share(const Job& job)
{
  for (std::size_t k = 0; k < slots_.size(); ++k)
  {
    slots_[k].job = job;
    slots_[k].next = k == 0 ? 0 : job.end(k - 1, slots_.size());
  }
  for (std::size_t k = 1; k < slots_.size(); ++k) slots_[k].state = State::Offered;
  if (sleeping_ > 0)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);  // whoever is about to sleep has looked, or sleeps by now
    }
    begun_.notify_all();
  }
  workOn(job, 0);
  for (std::size_t k = 1; k < slots_.size(); ++k)
  {
    State offered = State::Offered;
    slots_[k].state.compare_exchange_strong(offered, State::Idle);
  }
  const auto done = [this] { return allDone(); };
  if (comesSoon(done)) return;
  std::unique_lock<std::mutex> lock(mutex_);
  caller_sleeps_ = true;
  ended_.wait(lock, done);
  caller_sleeps_ = false;
}

void Workers::workOn(const Job& job, std::size_t worker)
{
  for (std::size_t k = 0; k < slots_.size(); ++k)
  {
    const std::size_t owner = (worker + k) % slots_.size(), end = job.end(owner, slots_.size());
    std::atomic<std::size_t>& next = slots_[owner].next;
    for (std::size_t begin = next.fetch_add(job.grain); begin < end; begin = next.fetch_add(job.grain))
      job.call(job.action, begin, std::min(begin + job.grain, end), worker);
  }
}
}  // namespace ping_pong
