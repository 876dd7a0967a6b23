#include "call_deadline.h"

namespace ping_pong_sim
{
CallDeadline::CallDeadline() : thread_([this] { watch(); }) {}

CallDeadline::~CallDeadline()
{
  {
    std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

bool CallDeadline::run(double seconds, const std::function<bool()>& call, std::function<void()> abort)
{
  {
    std::lock_guard<std::mutex> lock(mutex_);
    abort_ = std::move(abort);
    due_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }
  changed_.notify_all();
  const bool done = call();
  std::lock_guard<std::mutex> lock(mutex_);
  abort_ = nullptr;
  return done;
}

void CallDeadline::watch()
{
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ending_)
  {
    if (!abort_)
      changed_.wait(lock);
    else if (Clock::now() < due_)
      changed_.wait_until(lock, due_);
    else
    {
      abort_();
      abort_ = nullptr;
    }
  }
}
}  // namespace ping_pong_sim
