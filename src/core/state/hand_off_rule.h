// Balls that meet others without end in contacts that lose speed.
#pragma once

#include "state/world_state.h"

namespace ping_pong
{
inline constexpr int kHandOffContacts = 150;  // contacts of a ball with others,
inline constexpr double kHandOffTime = 0.2;   // within this time, hand it to the contact solver [s]

/// After a contact of a ball with another one at time t that loses speed: whether they follow each other too fast.
inline bool countFrequent(BallRecord& ball, double t)
{
  if (t - static_cast<double>(ball.frequent_since) > kHandOffTime)
  {
    ball.frequent_since = static_cast<float>(t);
    ball.frequent_contacts = 0;
  }
  if (ball.frequent_contacts <= kHandOffContacts) ++ball.frequent_contacts;
  return ball.frequent_contacts > kHandOffContacts;
}
}  // namespace ping_pong
