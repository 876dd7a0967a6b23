#include "state/free_space.h"

#include <cstdio>

namespace ping_pong
{
namespace
{
constexpr double kPressed = 1e-4;  // overlap that a pile may leave [m]
constexpr int kMaxPushes = 50;

struct Overlap
{
  double gap = kNever;  // smallest gap, negative in overlap [m]
  Vector3d n_W = Vector3d::UnitZ();
  const BodyRecord* body = nullptr;  // with this, or else with a ball
  BallId ball = 0;
};

void lookAtBodies(const WorldState& world, const Vector3d& p_WB, double radius, Overlap& deepest, bool moving = true)
{
  for (const BodyRecord& body : world.bodies)
  {
    if (body.moving && !moving) continue;
    const BodyFrame frame = body.at(world.time);
    for (const Shape& shape : body.shapes())
    {
      const Gap gap = gapTo(shape, frame, p_WB, Vector3d::Zero(), radius);
      if (gap.gap < deepest.gap) deepest = {gap.gap, gap.n_W, &body, 0};
    }
  }
}

void lookAtBalls(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except, Overlap& deepest)
{
  for (std::size_t i = 0; i < world.balls.size(); ++i)
  {
    const BallRecord& other = world.balls[i];
    if (i == except || other.squeezed()) continue;
    const Vector3d d = p_WB - other.stateAt(world.time).p_WB;
    const double distance = d.norm();
    const double gap = distance - radius - other.params().radius;
    if (gap >= deepest.gap) continue;
    const Vector3d n = distance > 0.0 ? Vector3d(d / distance) : Vector3d(Vector3d::UnitZ());
    deepest = {gap, n, nullptr, other.id};
  }
}

Overlap deepestOverlap(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except)
{
  Overlap deepest;
  lookAtBodies(world, p_WB, radius, deepest);
  lookAtBalls(world, p_WB, radius, except, deepest);
  return deepest;
}
}  // namespace

bool pushOut(const WorldState& world, Vector3d& p_WB, double radius, std::size_t except)
{
  for (int i = 0; i < kMaxPushes; ++i)
  {
    const Overlap deepest = deepestOverlap(world, p_WB, radius, except);
    if (deepest.gap >= -kTouching) return true;
    p_WB -= deepest.gap * deepest.n_W;
  }
  return false;
}

void pushOutOfStill(const WorldState& world, Vector3d& p_WB, double radius)
{
  for (int i = 0; i < kMaxPushes; ++i)
  {
    Overlap deepest;
    lookAtBodies(world, p_WB, radius, deepest, false);
    if (deepest.gap >= -kTouching) return;
    p_WB -= deepest.gap * deepest.n_W;
  }
}

bool hasRoomInPile(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except)
{
  return deepestOverlap(world, p_WB, radius, except).gap >= -kPressed;
}

bool hasRoom(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except)
{
  return deepestOverlap(world, p_WB, radius, except).gap >= -kTouching;
}

bool hasRoomAmongBodies(const WorldState& world, const Vector3d& p_WB, double radius)
{
  Overlap deepest;
  lookAtBodies(world, p_WB, radius, deepest);
  return deepest.gap >= -kTouching;
}

bool overlapsABody(const WorldState& world, const Vector3d& p_WB, double radius)
{
  Overlap deepest;
  lookAtBodies(world, p_WB, radius, deepest);
  return deepest.gap < -kPressed;
}

std::string describeOverlap(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except)
{
  const Overlap deepest = deepestOverlap(world, p_WB, radius, except);
  if (deepest.gap >= -kTouching) return {};
  char depth[64];
  std::snprintf(depth, sizeof depth, " (%.3g mm deep)", -1e3 * deepest.gap);
  return (deepest.body != nullptr ? deepest.body->body.name : "ball_" + std::to_string(deepest.ball)) + depth;
}
}  // namespace ping_pong
