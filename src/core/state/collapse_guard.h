// Contacts that follow each other ever faster: what the exact method does then is decided by these counts.
#pragma once

#include "state/world_state.h"

namespace ping_pong
{
// Contacts of a ball that follow each other faster than this are counted. After many of them balls stop losing speed to
// each other (the TC rule of Luding and McNamara 1998), which makes the number of events finite where balls collapse.
inline constexpr double kQuickTime = 1e-5;       // [s]
inline constexpr double kQuickForgotten = 1e-3;  // the count ends when nothing happens for so long [s]
inline constexpr int kManyQuick = 64;            // e = 0.5 leaves 5e-20 of a speed: only a collapse has as many
inline constexpr double kNoReboundSpeed =
    1e-4;  // leaving a body more slowly after many of them, a ball no longer bounces [m/s]
// Contacts that follow each other faster than this are all but simultaneous: a moving paddle leaves hardly any room.
inline constexpr double kInstantTime = 1e-7;     // [s]
inline constexpr int kHopelessInstants = 10000;  // in a millisecond at most: long before the limit of events
// Balls that press on each other and no longer bounce part with this speed: flights of v^2/2g = 1.3e-6 m, 1 ms long.
inline constexpr double kResidualSeparation = 5e-3;  // [m/s]
inline constexpr double kTouchSpeed = 1e-9;          // slower is no impact [m/s]

inline void countCollapse(BallRecord& ball, double t)
{
  const double pause = t - ball.last_contact;
  if (pause < kQuickTime && ball.quick_contacts <= kManyQuick)
    ++ball.quick_contacts;  // more than many is all that is asked for
  if (pause > kQuickForgotten) ball.quick_contacts = 0;
  if (pause >= kInstantTime)
    ball.instant_contacts = 0;
  else if (ball.instant_contacts <= kHopelessInstants)
    ++ball.instant_contacts;
  ball.last_contact = t;
}

// Contacts at the residual separation are not worth a report.
inline bool worthAReport(const BallRecord& ball, double closing)
{
  return closing > (ball.quick_contacts > kManyQuick ? 2.0 * kResidualSeparation : kTouchSpeed);
}
}  // namespace ping_pong
