// Counts what was refused, and warns about it.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace ping_pong_sim
{
/// Used by all threads.
class Rejections
{
public:
  /// @param what    topic or service that was refused
  /// @param reason  why
  void add(const std::string& what, const std::string& reason);

  std::uint64_t count() const;
  std::string last() const;

private:
  bool mayWarn();

  mutable std::mutex mutex_;
  std::uint64_t count_ = 0;
  std::string last_;
  bool warned_ = false;
  std::chrono::steady_clock::time_point warned_at_;
};
}  // namespace ping_pong_sim
