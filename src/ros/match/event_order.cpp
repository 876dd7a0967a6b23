#include "event_order.h"

namespace ping_pong_sim
{
void EventOrder::release(double now, const std::function<void(const ping_pong::Contact&)>& contact,
                         const std::function<void(const TickEnd&)>& tick)
{
  while (!contacts_.empty() || !ticks_.empty())
  {
    const bool both = !contacts_.empty() && !ticks_.empty();
    // A contact at the very end of a tick belongs to it.
    const bool contact_first = ticks_.empty() || (both && contacts_.front().event.time <= ticks_.front().event.time);
    if (!both && !(contact_first ? waited(contacts_, now) : waited(ticks_, now))) return;
    if (contact_first)
    {
      contact(contacts_.front().event);
      contacts_.pop_front();
    }
    else
    {
      tick(ticks_.front().event);
      ticks_.pop_front();
    }
  }
}

void EventOrder::clear()
{
  contacts_.clear();
  ticks_.clear();
}
}  // namespace ping_pong_sim
