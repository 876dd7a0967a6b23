// How far a ball is from a shape of a body, wherever the body is at the time.
#pragma once

#include "state/world_state.h"

namespace ping_pong
{
/// @param shape  one of body.shapes(): those of a still body are in the world frame already
inline Gap gapOver(const BodyRecord& body, const Shape& shape, const BallState& ball, double radius, double t)
{
  return body.moving ? gapTo(shape, body.at(t), ball.p_WB, ball.v_WB, radius)
                     : gapTo(shape, ball.p_WB, ball.v_WB, radius);
}
}  // namespace ping_pong
