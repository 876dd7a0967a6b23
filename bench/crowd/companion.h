// Another world that moves on at the same time: what two processors of this machine gain when they share nothing.
#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "ping_pong_sim/world.h"

namespace ping_pong::bench
{
/// A world with a thread of its own, which waits for ticks without sleeping.
class Companion
{
public:
  explicit Companion(std::shared_ptr<const Scene> scene);
  ~Companion();
  Companion(const Companion&) = delete;
  Companion& operator=(const Companion&) = delete;

  /// It moves on by so much, from now on; end() has been called since the last time [s].
  void begin(double duration);
  /// When that is done: the wall time that it took [s].
  double end();

private:
  void live();

  World world_;
  double duration_ = 0.0, took_ = 0.0;
  std::atomic<std::size_t> asked_{0}, done_{0};
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};
}  // namespace ping_pong::bench
