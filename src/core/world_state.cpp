#include "world_state.h"

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

// Between its ends, or to where it turns round.
Box boxOfParabola(const Segment& path, double radius, double from, double to)
{
  const double s = std::max(from - path.start, 0.0), e = std::max(to - path.start, s);
  Vector3d lows, highs;
  for (int i = 0; i < 3; ++i)
  {
    const double c0 = path.c[0][i], c1 = path.c[1][i], c2 = path.c[2][i];
    const double p = c0 + s * (c1 + s * c2), q = c0 + e * (c1 + e * c2);
    double low = std::min(p, q), high = std::max(p, q);
    const double v = c1 + 2.0 * s * c2;
    if (v * (c1 + 2.0 * e * c2) < 0.0)
    {
      const double turn = p - 0.25 * v * v / c2;
      low = std::min(low, turn);
      high = std::max(high, turn);
    }
    lows[i] = low - radius;
    highs[i] = high + radius;
  }
  return {lows, highs};
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
  if (path.degree == 2) return boxOfParabola(path, ball.params.radius, from, to);
  const double s = std::max(from - path.start, 0.0);
  const double T = std::max(to - path.start - s, 0.0);
  const Vector3d p = path.position(s), v = path.velocity(s);
  Box box;
  for (int i = 0; i < 3; ++i)
  {
    box.low[i] = p[i] + leastOn(v[i], path.a_low[i], T) - ball.params.radius;
    box.high[i] = p[i] - leastOn(-v[i], -path.a_high[i], T) + ball.params.radius;
  }
  return box;
}

void IslandRecords::reserve(std::size_t balls, std::size_t workers)
{
  broad_phase.reserve(balls);
  swept.reserve(balls);
  for (std::vector<std::uint32_t>* list : {&saved_at, &root, &next, &last_piece}) list->reserve(balls);
  const std::size_t meetings = 2048 + 8 * balls;  // 64 balls may all be near each other
  for (std::vector<std::uint32_t>* list : {&islands, &found, &near}) list->reserve(meetings);
  order.reserve(256 + 8 * balls);
  work.resize(workers);
  for (std::uint32_t worker = 0; worker < workers; ++worker)
  {
    IslandWork& its = work[worker];
    its.worker = worker;
    its.saved.reserve(balls);
    its.members.reserve(balls);
    its.crowded.reserve(balls);
    its.met.reserve(meetings);
    its.pieces.reserve(2048 + 4 * balls);
    its.contacts.reserve(256 + 8 * balls);
    its.origins.reserve(256 + 8 * balls);
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
