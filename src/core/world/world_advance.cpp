// A tick: docs/architecture.md.
#include <algorithm>
#include <cmath>

#include "base/law_counter.h"
#include "evolve/flight.h"
#include "methods/release_squeezed.h"
#include "world/world_impl.h"

namespace ping_pong
{
namespace
{
// Paddles that move are given a new motion at least so often, however long the tick. Each one has constant accelerations: longer,
// and a paddle would follow its command later; shorter, and contacts with it would be predicted more often.
constexpr double kLongestMotion = 5e-3;  // [s]

bool atWork(const BodyRecord& body)
{
  return body.body.kind == BodyKind::Kinematic && (body.moving || body.command.mode != PaddleCommand::Mode::Hold);
}
}  // namespace

void World::Impl::beginTick()
{
  contacts.clear();
  provenances.clear();
  status = StepStatus();
  for (BodyRecord& body : bodies) body.blocked = false;
}

// Neumaier's compensated sum.
double World::Impl::later(double duration)
{
  const double with_rest = duration + time_rest;
  const double end = time + with_rest;
  time_rest = with_rest - (end - time);
  return end;
}

// Gives every paddle one smooth motion that follows its command and stops at static bodies; returns until when all hold.
double World::Impl::movePaddles(double end)
{
  bool work = false;
  for (BodyRecord& body : bodies)
  {
    body.moved = body.moving;
    work |= atWork(body);
  }
  if (!work) return end;
  obstacles.clear();
  for (const BodyRecord& body : bodies)
    if (body.body.kind == BodyKind::Static) obstacles.push_back({&body.body.shapes, body.motion.pose});
  const double pieces = std::max(1.0, std::ceil((end - time) / kLongestMotion - 1e-9));
  double h = (end - time) / pieces;
  for (BodyRecord& body : bodies)
  {
    if (!atWork(body)) continue;
    count(Law::PaddleMotion);
    const BodyMotion wanted = followCommand(body.command, body.body.limits, body.motion, time, h);
    const BlockedMotion allowed = stopAtObstacles(body.body.shapes, wanted, h, obstacles, near_obstacles);
    body.motion = allowed.motion;
    h = std::min(h, allowed.duration);
    if (allowed.blocked && !body.blocked) ++status.blocked_paddles;  // of a paddle, not of each piece of its tick
    body.blocked |= allowed.blocked;
  }
  for (BodyRecord& body : bodies)
  {
    if (!atWork(body)) continue;
    if (body.command.mode == PaddleCommand::Mode::Pose)
    {
      body.command.pose.p += h * body.command.twist.v;
      body.command.pose.q = turned(body.command.pose.q, body.command.twist.w, h);
    }
    const bool moving = !body.motion.still();
    if (moving && !body.moving) ++body.version;
    if (!moving && body.moving) placeBody(body, body.motion.pose);
    body.moving = moving;
  }
  return h < end - time ? time + h : end;
}

// Of those that cannot have any nobody is asked: thousands of records are a long way through memory.
StepStatus World::Impl::endTick()
{
  status.piled = solver.ball.size();
  if (!any_squeezed && !flies_in_steps) return status;
  for (const BallRecord& ball : balls)
  {
    status.squeezed += ball.squeezed();
    status.not_finite |= ball.overflows;
  }
  return status;
}

StepStatus World::advance(double duration)
{
  Impl& world = *impl_;
  world.beginTick();
  if (!(duration > 0.0) || !std::isfinite(duration)) return world.status;
  for (const double end = world.later(duration); world.time < end;)
  {
    const double smooth_until = world.movePaddles(end);  // one smooth motion each
    world.functions->advance(world, smooth_until);       // the method evolves, detects, resolves
    world.time = smooth_until;
    releaseSqueezed(world);
  }
  return world.endTick();
}
}  // namespace ping_pong
