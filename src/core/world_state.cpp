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
  const Matrix3d R_WB = pose.q.toRotationMatrix();
  body.placed = body.body.shapes;
  for (Shape& shape : body.placed)
  {
    shape.p_BS = R_WB * shape.p_BS + pose.p;
    shape.R_BS = R_WB * shape.R_BS;
  }
}
}  // namespace ping_pong
