#include "overlap_check.h"

#include <algorithm>

#include "testing/hit_reference.h"

namespace ping_pong::bench
{
namespace
{
Pose poseAt(const Start& start, std::size_t body, double time)
{
  Pose pose = start.scene.bodies[body].pose;
  for (const Drive& drive : start.drives)
  {
    if (drive.body != body) continue;
    pose.p += time * drive.twist.v;
    const double angle = time * drive.twist.w.norm();
    if (angle != 0.0) pose.q = Eigen::AngleAxisd(angle, drive.twist.w.normalized()) * pose.q;
  }
  return pose;
}

// Boxes and half-spaces, centred in their bodies: all that the chart has.
double distance(const Shape& shape, const Pose& pose, const Vector3d& p)
{
  const Vector3d local = pose.q.conjugate() * (p - pose.p);
  return shape.kind == ShapeKind::HalfSpace ? local.z() : distanceToBox(local, shape.half_size);
}

template <class Function>
void forEachGap(const Start& start, const std::vector<BallState>& balls, double time, const Function& function)
{
  for (std::size_t b = 0; b < start.scene.bodies.size(); ++b)
  {
    const Pose pose = poseAt(start, b, time);
    for (std::size_t i = 0; i < balls.size(); ++i)
    {
      const double radius = start.scene.balls[i].params.radius;
      function(distance(start.scene.bodies[b].shapes[0], pose, balls[i].p_WB) - radius, radius);
    }
  }
}
}  // namespace

std::vector<BallState> statesOf(const Engine& engine, std::size_t balls)
{
  std::vector<BallState> states(balls);
  for (std::size_t i = 0; i < balls; ++i) states[i] = engine.ballState(i);
  return states;
}

Overlap overlapOf(const Start& start, const std::vector<BallState>& balls, double time)
{
  Overlap overlap;
  const auto note = [&](double depth)
  {
    if (depth <= 0.0) return;
    overlap.deepest = std::max(overlap.deepest, depth);
    overlap.sum_of_squares += depth * depth;
  };
  forEachGap(start, balls, time, [&](double gap, double) { note(-gap); });
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t k = i + 1; k < balls.size(); ++k)
    {
      const double reach = start.scene.balls[i].params.radius + start.scene.balls[k].params.radius;
      const Vector3d d = balls[i].p_WB - balls[k].p_WB;
      const double square = d.squaredNorm();
      if (square < reach * reach) note(reach - std::sqrt(square));
    }
  return overlap;
}

double worstDepthInBody(const Start& start, const std::vector<BallState>& balls, double time)
{
  double worst = 0.0;
  forEachGap(start, balls, time, [&](double gap, double radius) { worst = std::max(worst, -gap / radius); });
  return worst;
}
}  // namespace ping_pong::bench
