// Ends calls that a stopped simulator would keep for ever: it is there, so the connection is, but nobody answers.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace ping_pong_sim
{
/// For the calls of one thread, one at a time.
class CallDeadline
{
public:
  CallDeadline();
  ~CallDeadline();
  CallDeadline(const CallDeadline&) = delete;
  CallDeadline& operator=(const CallDeadline&) = delete;

  /// Returns what the call does.
  /// @param seconds  after which `abort` is called, in another thread; it shall make the call return
  bool run(double seconds, const std::function<bool()>& call, std::function<void()> abort);

private:
  using Clock = std::chrono::steady_clock;
  void watch();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> abort_;  ///< empty: no call goes on
  Clock::time_point due_;
  bool ending_ = false;
  std::thread thread_;
};
}  // namespace ping_pong_sim
