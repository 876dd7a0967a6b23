#include "world_state.h"

#include <algorithm>

#include "take_memory.h"

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

void IslandRecords::reserve(std::size_t balls, std::size_t workers)
{
  broad_phase.reserve(balls, workers);
  glances.reserve(balls);
  const std::size_t meetings = 2048 + 8 * balls;  // 64 balls may all be near each other
  for (std::vector<std::uint32_t>* list : {&found, &near}) takeMemory(*list, meetings);
  takeMemory(near_boxes, balls);
  ends.reserve(workers);
  takeMemory(order, 256 + 8 * balls);
  work.resize(workers);
  for (std::uint32_t worker = 0; worker < workers; ++worker)
  {
    IslandWork& its = work[worker];
    its.worker = worker;
    its.saved.reserve(balls);
    takeMemory(its.busy, balls);
    for (std::vector<std::uint32_t>* list : {&its.due, &its.turn}) takeMemory(*list, balls);
    takeMemory(its.added, meetings);
    its.announced.resize(workers);
    for (std::vector<BroadPhase::Addition>& announced : its.announced) takeMemory(announced, meetings / workers);
    takeMemory(its.near.entries, 32768);
    takeMemory(its.near.ends, 16);
    takeMemory(its.thrown, balls);
    takeMemory(its.members, balls);
    takeMemory(its.crowded, balls);
    takeMemory(its.met, meetings);
    takeMemory(its.apart, 256);
    takeMemory(its.roots, meetings);
    takeMemory(its.meetings, meetings);
    takeMemory(its.due_meetings, meetings);
    takeMemory(its.pieces, 2048 + 4 * balls);
    if (worker == 0) continue;  // it writes to the world's lists
    takeMemory(its.contacts, 256 + 8 * balls);
    takeMemory(its.origins, 256 + 8 * balls);
  }
}

void ownWhatPoints(WorldState& world)
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
  for (IslandWork& work : world.islands.work) work.saved.clear();  // of a window that is over
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
