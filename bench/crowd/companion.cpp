#include "companion.h"

#include <chrono>

namespace ping_pong::bench
{
Companion::Companion(std::shared_ptr<const Scene> scene) : world_(std::move(scene))
{
  world_.keepContacts(false);
  thread_ = std::thread([this] { live(); });
}

Companion::~Companion()
{
  stopping_ = true;
  thread_.join();
}

void Companion::begin(double duration)
{
  duration_ = duration;
  ++asked_;
}

double Companion::end()
{
  while (done_ != asked_)
  {
  }
  return took_;
}

void Companion::live()
{
  using Clock = std::chrono::steady_clock;
  while (!stopping_)
  {
    if (asked_ == done_) continue;
    const Clock::time_point start = Clock::now();
    world_.advance(duration_);
    took_ = std::chrono::duration<double>(Clock::now() - start).count();
    ++done_;
  }
}
}  // namespace ping_pong::bench
