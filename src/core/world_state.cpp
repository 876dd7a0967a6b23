#include "world_state.h"

namespace ping_pong
{
const BodyMotion BodyRecord::kWorldFrame;

void placeBody(BodyRecord& body, Pose pose)
{
  body.motion = BodyMotion();
  body.motion.pose = pose;
  body.moving = false;
  ++body.version;
  body.placed.clear();
  for (const Shape& shape : body.body.shapes) body.placed.push_back(placed(shape, pose));
}
}  // namespace ping_pong
