// What a tick tells of itself.
#pragma once

#include <cstddef>

namespace ping_pong
{
/// What a call of advance() did. A step never throws and never logs.
struct StepStatus
{
  std::size_t contacts = 0;         ///< impacts handled
  std::size_t events = 0;           ///< events handled: impacts, coming to rest, sliding over an edge
  std::size_t squeezed = 0;         ///< balls now caught between bodies with no room left
  std::size_t blocked_paddles = 0;  ///< paddles that a static body stopped, each counted once a tick
  std::size_t piled = 0;            ///< balls that are stepped together now, see docs/crowds.md
  bool event_limit = false;         ///< more events than Limits allow: the remaining time was flown without contacts
  bool not_finite = false;  ///< a step of fixed length ended at inf or NaN; that ball keeps its last finite state
  bool ok() const { return squeezed == 0 && !event_limit && !not_finite; }
};
}  // namespace ping_pong
