// How a world comes to be: from a scene, or as a copy of another one; and the memory that it takes then.
#include <algorithm>

#include "base/prefault.h"
#include "evolve/flight.h"
#include "ping_pong_sim/choose_method.h"
#include "world/world_impl.h"

namespace ping_pong
{
namespace
{
// Room for so many records from the start, more than a ball caught between paddle and table makes. More in one
// tick make the records grow, once: they keep what they have.
constexpr std::size_t kContactsInATick = 256;
constexpr std::size_t kContactsOfABall = 8;
constexpr std::size_t kBallsWithContacts = 1000;  // of more balls only so many have a record of their own kept free
constexpr std::size_t kBallsConstrained =
    1000;  // of more balls fewer roll over edges and round or turning surfaces at once

// A drive is not faster than its limits, at the start either.
Vector3d startWithin(double limit, const Vector3d& x)
{
  if (!x.allFinite()) return Vector3d::Zero();
  const double length = x.norm();
  return length > limit ? Vector3d(limit / length * x) : x;
}

// A paddle that starts in motion has this motion for its command, so that the paddle keeps it. Scenes built in code may ask for
// what the loader refuses: a static body stands still all the same, and a paddle starts within its limits.
void setInMotion(BodyRecord& record)
{
  const Body& body = record.body;
  if (body.kind != BodyKind::Kinematic) return;
  record.motion.twist = {startWithin(body.limits.speed, body.twist.v),
                         startWithin(body.limits.angular_speed, body.twist.w)};
  record.moving = !record.motion.still();
  if (!record.moving) return;
  record.command.mode = PaddleCommand::Mode::Velocity;
  record.command.twist = record.motion.twist;
}

// Every shape of the largest paddle near every shape of all furniture.
std::size_t mostNearPairs(const std::vector<BodyRecord>& bodies)
{
  std::size_t paddle = 0, furniture = 0;
  for (const BodyRecord& body : bodies)
    if (body.body.kind == BodyKind::Static)
      furniture += body.body.shapes.size();
    else
      paddle = std::max(paddle, body.body.shapes.size());
  return paddle * furniture;
}
}  // namespace

void World::Impl::choose(Method its_method)
{
  method = its_method;
  functions = &functionsOf(method);
  flies_in_steps = functions->flies_in_steps;
}

void World::Impl::start()
{
  choose(chooseMethod(scene).method);
  time = time_rest = 0.0;
  next_id = 0;
  contacts.clear();
  provenances.clear();
  status = StepStatus();
  balls.clear();
  types.clear();
  balls.reserve(scene.balls.size());
  clearSolver(solver);
  bodies.clear();
  for (const Body& body : scene.bodies)
  {
    BodyRecord record;
    record.body = body;
    placeBody(record, body.pose);
    setInMotion(record);
    bodies.push_back(record);
  }
  for (const SceneBall& ball : scene.balls) add(ball.params, normalized(ball.state));
  makeSpace();
  if (functions->needs_room) resolveOverlaps();  // the loader refuses overlaps; scenes built in code may have them
  functions->start(*this);
  islands.length.estimate(*this);
}

// Memory for the ticks to come is there before what is copied comes to lie in it: lists that are assigned keep theirs.
void World::Impl::become(const Impl& model)
{
  if (space_for < model.space_for)
  {
    choose(model.method);
    workers = model.workers;
    space_for = model.space_for;
    takeSpace();
  }
  *this = model;
  ownTypes(*this);
  for (IslandWork& work : islands.work) work.saved.clear();  // of a window that is over
  obstacles.clear();
  near_obstacles.clear();
  makeSpace();
}

BallRecord& World::Impl::add(const BallParams& params, const BallState& state)
{
  BallRecord& ball = balls.emplace_back(next_id++, types.of(params, scene.forces));
  ball.path = flyParabola(state, time, Vector3d::Zero());
  return ball;
}

void World::Impl::remove(std::size_t index)
{
  const BallType* type = balls[index].type;
  balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(index));
  const auto has_it = [type](const BallRecord& ball) { return ball.type == type; };
  if (std::none_of(balls.begin(), balls.end(), has_it)) types.forget(*type);
}

// Memory for all that a tick needs: it is not taken while the world moves on. Balls that come one by one find it taken
// for as many again.
void World::Impl::makeSpace()
{
  obstacles.reserve(bodies.size());
  near_obstacles.reserve(mostNearPairs(bodies));
  if (balls.size() <= space_for && space_for > 0) return;
  if (balls.size() > 1) workers.start(scene.threads);
  space_for = space_for == 0 ? balls.size() : std::max(balls.size(), 2 * space_for);
  takeSpace();
}

void World::Impl::takeSpace()
{
  takeMemory(contacts, kContactsInATick + kContactsOfABall * std::min(space_for, kBallsWithContacts));
  takeMemory(provenances, contacts.capacity());
  Pooled<HigherCoefficients>::reserve(2 * space_for,
                                      workers.count());  // of balls, and of balls at the start of a window
  Pooled<SpinCoefficients>::reserve(2 * std::min(space_for, kBallsConstrained), workers.count());
  Pooled<TransientPredictions>::reserve(2 * space_for, workers.count());
  Supports::reserve(2 * space_for, workers.count());
  functions->reserve(*this, space_for);
}

void World::Impl::ballChanged(std::size_t index)
{
  makeSpace();
  functions->ballChanged(*this, index);
}
}  // namespace ping_pong
