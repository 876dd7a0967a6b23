#include "held_keys.h"

#include <algorithm>

namespace ping_pong
{
void HeldKeys::press(Key key, double now)
{
  expire(now);
  const bool repeated = until_.count(key) > 0;
  until_[key] = std::max(until_[key], now + (repeated ? limits_.repeat : limits_.first));
  if (!repeated || !limits_.together) return;
  for (auto& held : until_) held.second = std::max(held.second, now + limits_.repeat);
}

void HeldKeys::expire(double now)
{
  for (auto held = until_.begin(); held != until_.end();)
  {
    held = held->second <= now ? until_.erase(held) : std::next(held);
  }
}

Wish HeldKeys::wish() const
{
  Wish wish;
  for (const auto& held : until_)
  {
    const KeyEntry* entry = findKey(held.first);
    if (entry == nullptr) continue;
    if (entry->action == Action::Move) wish.move[entry->axis] += entry->sign;
    if (entry->action == Action::Turn) wish.turn[entry->axis] += entry->sign;
  }
  return wish;
}
}  // namespace ping_pong
