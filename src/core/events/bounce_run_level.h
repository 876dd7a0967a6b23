// Many bounces in a row on level ground: what bounce_run.h does, in one dimension.
#pragma once

#include "events/event_loop.h"

namespace ping_pong
{
/// Level ground: z of its plane, the law of contact with it, and the acceleration of the ball along z [m, -, m/s^2].
struct LevelGround
{
  double z;
  const Surface& law;
  double a;
};

/// Lets ball i bounce until the window ends, or something else than an ordinary bounce comes next. The ball flies a parabola
/// above level ground, is pulled along z only, does not slip on it and has nothing else in its way. The bits are those of runBounces().
/// @return number of bounces, `most` at most
std::size_t bounceOnLevel(WorldState& world, const Window& window, std::size_t i, const LevelGround& ground,
                          std::size_t most);
}  // namespace ping_pong
