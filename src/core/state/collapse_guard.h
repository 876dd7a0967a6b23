// Contacts that follow each other ever faster: what the exact method does then is decided by these counts.
#pragma once

#include "state/world_state.h"

namespace ping_pong
{
// Contacts of a ball that follow each other faster than this are a streak. After a long streak balls stop losing speed to
// each other (the TC rule of Luding and McNamara 1998), which makes the number of events finite where balls collapse.
inline constexpr double kStreakTime = 1e-5;       // [s]
inline constexpr double kStreakForgotten = 1e-3;  // a streak ends when nothing happens for so long [s]
inline constexpr int kLongStreak = 64;
inline constexpr double kDeadSpeed =
    1e-4;  // leaving a body more slowly in a long streak, a ball no longer bounces [m/s]
// Contacts that follow each other faster than this are a crush: a moving paddle leaves hardly any room.
inline constexpr double kCrushTime = 1e-7;  // [s]
inline constexpr int kHopelessCrush = 10000;
// Balls that press on each other and no longer bounce part with this speed: hops of v^2/2g = 1.3e-6 m, 1 ms long.
inline constexpr double kHopSpeed = 5e-3;    // [m/s]
inline constexpr double kTouchSpeed = 1e-9;  // slower is no impact [m/s]

inline void countStreak(BallRecord& ball, double t)
{
  const double pause = t - ball.last_contact;
  if (pause < kStreakTime && ball.streak <= kLongStreak) ++ball.streak;  // more than long is all that one asks for
  if (pause > kStreakForgotten) ball.streak = 0;
  if (pause >= kCrushTime)
    ball.crush = 0;
  else if (ball.crush <= kHopelessCrush)
    ++ball.crush;
  ball.last_contact = t;
}

// Hops of a pile are not worth a report.
inline bool worthAReport(const BallRecord& ball, double closing)
{
  return closing > (ball.streak > kLongStreak ? 2.0 * kHopSpeed : kTouchSpeed);
}
}  // namespace ping_pong
