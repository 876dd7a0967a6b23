#include "job_queue.h"

namespace ping_pong_sim
{
bool JobQueue::run(const Job& job)
{
  bool done = false;
  std::unique_lock<std::mutex> lock(mutex_);
  if (closed_) return false;
  entries_.push_back({&job, &done});
  arrived_.notify_one();
  // An entry that close() drops is never done; one that was taken out always gets done.
  finished_.wait(lock, [&] { return done || closed_; });
  return done;
}

bool JobQueue::serve()
{
  std::unique_lock<std::mutex> lock(mutex_);
  return serveLocked(lock);
}

bool JobQueue::serveUntil(Clock::time_point deadline)
{
  std::unique_lock<std::mutex> lock(mutex_);
  arrived_.wait_until(lock, deadline, [this] { return !entries_.empty(); });
  return serveLocked(lock);
}

void JobQueue::close()
{
  std::lock_guard<std::mutex> lock(mutex_);
  closed_ = true;
  entries_.clear();
  finished_.notify_all();
}

bool JobQueue::serveLocked(std::unique_lock<std::mutex>& lock)
{
  bool any = false;
  while (!entries_.empty())
  {
    const Entry entry = entries_.front();
    entries_.pop_front();
    lock.unlock();
    (*entry.job)();
    lock.lock();
    *entry.done = true;
    any = true;
    finished_.notify_all();
  }
  return any;
}
}  // namespace ping_pong_sim
