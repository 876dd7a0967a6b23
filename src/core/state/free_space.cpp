#include "state/free_space.h"

#include <cstdio>

#include "geometry/tolerances.h"

namespace ping_pong
{
namespace
{
constexpr double kPressed = 1e-4;  // overlap that the contact solver may leave [m]
constexpr int kMaxPushes = 50;     // between shapes that leave no room they would have no end

// What is nearest to a sphere.
struct Nearest
{
  double gap = kNever;  // smallest gap, negative in overlap [m]
  Vector3d n_W = Vector3d::UnitZ();
  const BodyRecord* body = nullptr;  // with this, or else with a ball
  BallId ball = 0;
};

void searchBodies(const WorldState& world, const Vector3d& p_WB, double radius, Nearest& nearest, bool moving = true)
{
  for (const BodyRecord& body : world.bodies)
  {
    if (body.moving && !moving) continue;
    const BodyFrame frame = body.at(world.time);
    for (const Shape& shape : body.shapes())
    {
      const Gap gap = gapTo(shape, frame, p_WB, Vector3d::Zero(), radius);
      if (gap.gap < nearest.gap) nearest = {gap.gap, gap.n_W, &body, 0};
    }
  }
}

void searchBalls(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except, Nearest& nearest)
{
  for (std::size_t i = 0; i < world.balls.size(); ++i)
  {
    const BallRecord& other = world.balls[i];
    if (i == except || other.squeezed()) continue;
    const Vector3d d = p_WB - other.stateAt(world.time).p_WB;
    const double distance = d.norm();
    const double gap = distance - radius - other.params().radius;
    if (gap >= nearest.gap) continue;
    const Vector3d n = distance > 0.0 ? Vector3d(d / distance) : Vector3d(Vector3d::UnitZ());
    nearest = {gap, n, nullptr, other.id};
  }
}

Nearest nearestTo(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except)
{
  Nearest nearest;
  searchBodies(world, p_WB, radius, nearest);
  searchBalls(world, p_WB, radius, except, nearest);
  return nearest;
}
}  // namespace

bool pushOut(const WorldState& world, Vector3d& p_WB, double radius, std::size_t except)
{
  for (int i = 0; i < kMaxPushes; ++i)
  {
    const Nearest nearest = nearestTo(world, p_WB, radius, except);
    if (nearest.gap >= -kOverlapTolerance) return true;
    p_WB -= nearest.gap * nearest.n_W;
  }
  return false;
}

void pushOutOfStill(const WorldState& world, Vector3d& p_WB, double radius)
{
  for (int i = 0; i < kMaxPushes; ++i)
  {
    Nearest nearest;
    searchBodies(world, p_WB, radius, nearest, false);
    if (nearest.gap >= -kOverlapTolerance) return;
    p_WB -= nearest.gap * nearest.n_W;
  }
}

bool hasRoomInSolver(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except)
{
  return nearestTo(world, p_WB, radius, except).gap >= -kPressed;
}

bool hasRoom(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except)
{
  return nearestTo(world, p_WB, radius, except).gap >= -kOverlapTolerance;
}

bool hasRoomAmongBodies(const WorldState& world, const Vector3d& p_WB, double radius)
{
  Nearest nearest;
  searchBodies(world, p_WB, radius, nearest);
  return nearest.gap >= -kOverlapTolerance;
}

bool overlapsABody(const WorldState& world, const Vector3d& p_WB, double radius)
{
  Nearest nearest;
  searchBodies(world, p_WB, radius, nearest);
  return nearest.gap < -kPressed;
}

std::string describeOverlap(const WorldState& world, const Vector3d& p_WB, double radius, std::size_t except)
{
  const Nearest nearest = nearestTo(world, p_WB, radius, except);
  if (nearest.gap >= -kOverlapTolerance) return {};
  char depth[64];
  std::snprintf(depth, sizeof depth, " (%.3g mm deep)", -1e3 * nearest.gap);
  return (nearest.body != nullptr ? nearest.body->body.name : "ball_" + std::to_string(nearest.ball)) + depth;
}
}  // namespace ping_pong
