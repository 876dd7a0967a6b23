#include "perception.h"

namespace ping_pong::play
{
namespace
{
constexpr std::size_t kRemembered = 512;    // samples
constexpr double kBetweenSamples = 0.9e-3;  // 512 of them last longer than any reaction time [s]

Vector3d normals(Random& random, double deviation)
{
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return deviation * Vector3d(x, y, z);
}
}  // namespace

Perception::Perception(const LevelTraits& level, std::uint64_t seed) : level_(level), random_(seed, 1)
{
  ring_.resize(kRemembered);
  readSpinAnew();
}

void Perception::see(double time, const BallState& state)
{
  if (count_ > 0 && time < ring_[(first_ + count_ - 1) % kRemembered].time + kBetweenSamples) return;
  if (count_ == kRemembered)
    first_ = (first_ + 1) % kRemembered;
  else
    ++count_;
  ring_[(first_ + count_ - 1) % kRemembered] = {time, state};
}

bool Perception::look(double now, PathSample& seen)
{
  const double latest = now - (feels_ ? 0.0 : level_.reaction) + 1e-9;
  const PathSample* newest = nullptr;
  while (count_ > 0 && ring_[first_].time <= latest)
  {
    newest = &ring_[first_];
    first_ = (first_ + 1) % kRemembered;
    --count_;
  }
  const double every = feels_ ? 0.0 : level_.look_every;
  if (newest == nullptr || newest->time < looked_ + every) return false;
  seen = *newest;
  looked_ = seen.time;
  if (exact()) return true;
  seen.state.p_WB += normals(random_, level_.see_place);
  seen.state.v_WB += normals(random_, level_.see_velocity);
  seen.state.w_WB *= 1.0 + misreading_;
  return true;
}

void Perception::readSpinAnew()
{
  misreading_ = level_.spin_reading > 0.0 ? level_.spin_reading * random_.normal() : 0.0;
}

void Perception::forget()
{
  first_ = count_ = 0;
  looked_ = -1e9;
}
}  // namespace ping_pong::play
