#include "game/toss.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ping_pong::game
{
namespace
{
constexpr double kRounding = 1e-6;  // a toss of just 16 cm is one [m], and [m/s] for a strike at the very top

std::string number(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}
}  // namespace

void Toss::begin(End end, double radius)
{
  *this = Toss();
  end_ = end;
  radius_ = radius;
}

std::optional<ServiceFault> Toss::leave(const Court& court, const Rules& rules, const BallSample& sample)
{
  thrown_ = true;
  palm_ = highest_ = sample.p_TB.z();
  last_ = sample;
  if (rules.toss)
  {
    const double tilt = std::atan2(sample.v_TB.head<2>().norm(), sample.v_TB.z());
    if (tilt > rules.toss_tilt)
      return ServiceFault{"2.6.2", number("threw the ball %.0f deg off the vertical", tilt * 180.0 / M_PI)};
    if (sample.spin > rules.toss_spin)
      return ServiceFault{"2.6.2", number("threw the ball with a spin of %.0f rad/s", sample.spin)};
  }
  return place(court, rules, sample);
}

std::optional<ServiceFault> Toss::see(const Court& court, const Rules& rules, const BallSample& sample)
{
  if (thrown_) rise(sample);
  return place(court, rules, sample);
}

std::optional<ServiceFault> Toss::strike(const Court& court, const Rules& rules, const BallSample& sample)
{
  if (auto fault = see(court, rules, sample)) return fault;
  if (!rules.toss) return std::nullopt;
  if (!thrown_) return ServiceFault{"2.6.2", "struck the ball out of the hand"};
  const double rose = highest_ - palm_;
  if (sample.v_TB.z() > kRounding) return ServiceFault{"2.6.3", "struck the ball as it rose"};
  if (rose < rules.toss_height - kRounding)
    return ServiceFault{"2.6.2", number("threw the ball up %.1f cm", 100.0 * rose) +
                                     number(", %.0f are asked", 100.0 * rules.toss_height)};
  return std::nullopt;
}

std::optional<ServiceFault> Toss::place(const Court& court, const Rules& rules, const BallSample& sample) const
{
  if (!rules.service_place) return std::nullopt;
  if (sample.p_TB.z() - radius_ < -kRounding)
    return ServiceFault{"2.6.4", "had the ball below the level of the playing surface"};
  if (!court.behindEndLine(end_, sample.p_TB, radius_))
    return ServiceFault{"2.6.4", "had the ball in front of the end line"};
  return std::nullopt;
}

// Between two samples the top of the flight is that of a parabola through both velocities: exact in vacuum.
void Toss::rise(const BallSample& sample)
{
  highest_ = std::max(highest_, sample.p_TB.z());
  const double before = last_.v_TB.z();
  const double after = sample.v_TB.z();
  if (before > 0.0 && after < 0.0)
  {
    const double to_top = (sample.time - last_.time) * before / (before - after);
    highest_ = std::max(highest_, last_.p_TB.z() + 0.5 * before * to_top);
  }
  last_ = sample;
}
}  // namespace ping_pong::game
