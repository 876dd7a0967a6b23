#include "state/world_state.h"

#include <algorithm>

namespace ping_pong
{
const BodyMotion BodyRecord::kWorldFrame;

namespace
{
// Least value of v s + a s^2 / 2 for s in [0, T].
double leastOn(double v, double a, double T)
{
  if (a > 0.0 && v < 0.0 && -v < a * T) return -0.5 * v * v / a;
  return std::min(0.0, (v + 0.5 * a * T) * T);
}

Box boxAround(const Shape& placed)
{
  Box box;
  for (int i = 0; i < 3; ++i)
  {
    box.high[i] = supportDistance(placed, Vector3d::Unit(i));
    box.low[i] = -supportDistance(placed, -Vector3d::Unit(i));
  }
  return box;
}
}  // namespace

Box boxOf(const BallRecord& ball, double from, double to)
{
  const Segment& path = ball.path;
  if (path.degree == 2) return boxOf(ParabolaView(path), ball.params().radius, from, to);
  const double s = std::max(from - path.start, 0.0);
  const double T = std::max(to - path.start - s, 0.0);
  const Vector3d p = path.position(s), v = path.velocity(s), a_low = path.aLow(), a_high = path.aHigh();
  Box box;
  for (int i = 0; i < 3; ++i)
  {
    box.low[i] = p[i] + leastOn(v[i], a_low[i], T) - ball.params().radius;
    box.high[i] = p[i] - leastOn(-v[i], -a_high[i], T) + ball.params().radius;
  }
  return box;
}

void ownTypes(WorldState& world)
{
  const BallType* theirs = nullptr;
  const BallType* own = nullptr;
  for (BallRecord& ball : world.balls)
  {
    if (ball.type != theirs)
    {
      theirs = ball.type;
      own = &world.types.of(theirs->first, world.scene.forces);
    }
    ball.type = own;
  }
}

void placeBody(BodyRecord& body, Pose pose)
{
  body.motion = BodyMotion();
  body.motion.pose = pose;
  body.moving = false;
  ++body.version;
  body.placed.clear();
  body.boxes.clear();
  for (const Shape& shape : body.body.shapes)
  {
    body.placed.push_back(placed(shape, pose));
    body.boxes.push_back(boxAround(body.placed.back()));
  }
}
}  // namespace ping_pong
