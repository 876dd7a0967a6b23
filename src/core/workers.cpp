#include "workers.h"

#include <algorithm>

namespace ping_pong
{
namespace
{
// Loops follow each other within microseconds, less than it takes to wake a sleeping thread: one looks so often before
// it sleeps.
constexpr int kLooks = 200;

template <class Condition>
bool comesSoon(const Condition& condition)
{
  for (int look = 0; look < kLooks; ++look)
  {
    if (condition()) return true;
    std::this_thread::yield();  // whoever has something to do goes first
  }
  return condition();
}
}  // namespace

void Workers::start(std::size_t count)
{
  if (count == this->count()) return;
  stop();
  stopping_ = false;
  shares_ = std::vector<Share>(count);
  for (std::size_t worker = 1; worker < count; ++worker) threads_.emplace_back([this, worker] { live(worker); });
}

void Workers::stop()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
    ++jobs_;
  }
  begun_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

// A thread that comes too late to a job leaves it alone: nobody waits for it.
void Workers::live(std::size_t worker)
{
  for (std::size_t seen = 0;;)
  {
    comesSoon([&] { return jobs_ != seen; });
    std::unique_lock<std::mutex> lock(mutex_);
    begun_.wait(lock, [&] { return jobs_ != seen; });
    seen = jobs_;
    if (stopping_) return;
    if (!open_) continue;
    ++busy_;
    const Job job = job_;
    lock.unlock();
    workOn(job, worker);
    lock.lock();
    if (--busy_ == 0) ended_.notify_one();
  }
}

void Workers::share(const Job& job)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    job_ = job;
    for (std::size_t k = 0; k < shares_.size(); ++k)
    {
      shares_[k].next = k * job.size / shares_.size();
      shares_[k].end = (k + 1) * job.size / shares_.size();
    }
    open_ = true;
    ++jobs_;
  }
  begun_.notify_all();
  workOn(job, 0);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    open_ = false;
  }
  if (comesSoon([this] { return busy_ == 0; })) return;
  std::unique_lock<std::mutex> lock(mutex_);
  ended_.wait(lock, [this] { return busy_ == 0; });
}

void Workers::workOn(const Job& job, std::size_t worker)
{
  for (std::size_t k = 0; k < shares_.size(); ++k)
  {
    Share& share = shares_[(worker + k) % shares_.size()];
    for (std::size_t begin = share.next.fetch_add(job.grain); begin < share.end; begin = share.next.fetch_add(job.grain))
      job.call(job.action, begin, std::min(begin + job.grain, share.end), worker);
  }
}
}  // namespace ping_pong
