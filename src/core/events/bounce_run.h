// The commonest event of all at a third of its price: a ball that does not spin bounces on a still plane, without slip or
// without friction, under constant acceleration, with nothing else in its way. Only one component of its velocity changes, and the
// next bounce is a closed form away. The operations are those of the general way, in the same order: the bits are the same.
#pragma once

#include "events/event_loop.h"

namespace ping_pong
{
/// Handles ball i's next event if it is such a bounce, and those that follow while the ball is alone in the window. False, with
/// nothing changed, if it is not. With others in the window the caller predicts contacts with them anew.
bool runBounces(WorldState& world, const Window& window, std::size_t i);
}  // namespace ping_pong
