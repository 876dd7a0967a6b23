#include "events/predict.h"

#include <algorithm>

#include "geometry/feature.h"
#include "resting/plan_path.h"

namespace ping_pong
{
namespace
{
Event toEvent(const Detection& found, Event::Kind kind, std::size_t other, std::size_t shape, unsigned version)
{
  Event event;
  event.kind = found.undecided ? Event::Kind::Horizon : kind;
  event.time = found.time;
  event.other = static_cast<std::uint32_t>(other);
  event.shape = static_cast<std::uint16_t>(shape);
  event.version = version;
  return event;
}

bool liesStill(const BallRecord& ball)
{
  return ball.path.degree == 0;
}

// Planes that the ball lies on: a shape that is below one of them, flush with it at most, is not hit as long as the path holds.
class Planes
{
public:
  Planes(const WorldState& world, const BallRecord& ball, double t)
  {
    for (std::size_t i = 0; i < ball.supports.count(); ++i) add(world, ball, ball.supports[i], t);
  }
  /// @param shape  in the frame of the body if that moves, else in W
  bool cover(std::size_t body, bool moving, const Shape& shape) const
  {
    for (std::size_t i = 0; i < count_; ++i)
      if ((moving ? list_[i].body == body : !list_[i].moving) && supportDistance(shape, list_[i].n) <= list_[i].height)
        return true;
    return false;
  }

private:
  struct Plane
  {
    std::size_t body;
    bool moving;
    Vector3d n;     // in the frame of the body if that moves, else in W
    double height;  // above its origin, along n [m]
  };

  void add(const WorldState& world, const BallRecord& ball, const Supports::Surface& support, double t)
  {
    const BodyRecord& body = world.bodies[support.body];
    const Shape& shape = body.shapes()[support.shape];
    const Vector3d p = body.seenFrom(ball.path.position(t - ball.path.start), t);
    const Feature feature = featureAt(shape, p);
    if (!flat(shape, feature)) return;
    const Proximity near = proximity(shape, feature, p);
    list_[count_++] = {support.body, body.moving, near.normal,
                       near.normal.dot(p) - near.distance + flushTolerance(p, ball.params().radius)};
  }

  std::array<Plane, Supports::kMax> list_;
  std::size_t count_ = 0;
};

// `search(shape, from, until)` finds the first contact with a shape of this body.
template <typename Search>
void searchShape(const BallRecord& ball, const BodyRecord& body, std::size_t b, std::size_t s, const Planes& planes,
                 double t, double until, const Search& search, Event& next)
{
  if (ball.supports.has(b, s) || planes.cover(b, body.moving, body.shapes()[s])) return;
  const Detection found = search(t, std::min(until, next.time));
  if (found.time < next.time) next = toEvent(found, Event::Kind::HitBody, b, s, body.version);
}

void searchStillBody(const BallRecord& ball, const BodyRecord& body, std::size_t b, const Planes& planes, double t,
                     const Box& way, Event& next)
{
  for (std::size_t s = 0; s < body.placed.size(); ++s)
  {
    if (!way.overlaps(body.boxes[s])) continue;
    const auto search = [&](double from, double until)
    { return firstContact(ball.path, ball.params().radius, body.placed[s], from, until); };
    searchShape(ball, body, b, s, planes, t, kNever, search, next);
  }
}

void searchMovingBody(const BallRecord& ball, const BodyRecord& body, std::size_t b, const Planes& planes, double t,
                      double until, Event& next)
{
  for (std::size_t s = 0; s < body.body.shapes.size(); ++s)
  {
    const auto search = [&](double from, double before)
    { return firstContact(ball.path, ball.params().radius, body.body.shapes[s], body.motion, from, before); };
    searchShape(ball, body, b, s, planes, t, until, search, next);
  }
}

Event endOfPath(const BallRecord& ball, double t)
{
  Event end;
  if (ball.path.end < kNever)
  {
    end.kind = Event::Kind::LeaveFace;
    end.time = ball.path.end;
  }
  if (!liesStill(ball) && t + kHorizon < end.time)
  {
    end.kind = Event::Kind::Horizon;
    end.time = t + kHorizon;
  }
  return end;
}
}  // namespace

void predictStill(WorldState& world, std::size_t i, double t)
{
  BallRecord& ball = world.balls[i];
  ball.next = Event();
  if (ball.away()) return;
  ball.next = endOfPath(ball, t);
  if (liesStill(ball)) return;
  Box way = boxOf(ball, t, ball.next.time);
  way.low.array() -= kSlack;
  way.high.array() += kSlack;
  const Planes planes(world, ball, t);
  for (std::size_t b = 0; b < world.bodies.size(); ++b)
    if (!world.bodies[b].moving) searchStillBody(ball, world.bodies[b], b, planes, t, way, ball.next);
}

void predictBall(WorldState& world, std::size_t i, std::size_t k, double resume, double window_end, Records& records)
{
  BallRecord& mine = world.balls[i];
  BallRecord& other = world.balls[k];
  if (other.away() || mine.away() || (liesStill(mine) && liesStill(other))) return;
  ++records.pair_searches;
  const double until = std::min(mine.meetsBall(), window_end);
  const double from = std::max({mine.path.start, other.path.start, resume});
  const BallRecord &first = world.balls[std::min(i, k)], &second = world.balls[std::max(i, k)];
  const Detection found =
      firstContact(first.path, first.params().radius, second.path, second.params().radius, from, until);
  if (!(found.time < mine.meetsBall())) return;
  mine.transient.make().ball = toEvent(found, Event::Kind::HitBall, k, 0, other.version);
  if (found.time < other.meetsBall())
    other.transient.make().ball = toEvent(found, Event::Kind::HitBall, i, 0, mine.version);
}

void predictMoving(WorldState& world, std::size_t i, double t, double window_end)
{
  BallRecord& ball = world.balls[i];
  Event next;
  const Planes planes(world, ball, t);
  for (std::size_t b = 0; b < world.bodies.size(); ++b)
    if (world.bodies[b].moving && !ball.away()) searchMovingBody(ball, world.bodies[b], b, planes, t, window_end, next);
  if (next.time < kNever)
    ball.transient.make().moving = next;
  else if (ball.meetsBall() < kNever)
    ball.transient->moving = next;
  else
    ball.transient.reset();
}

bool stillTrue(const WorldState& world, const Event& event)
{
  if (event.kind == Event::Kind::HitBall) return world.balls[event.other].version == event.version;
  if (event.kind == Event::Kind::HitBody) return world.bodies[event.other].version == event.version;
  return true;
}
}  // namespace ping_pong
