#include "ping_pong_sim/world.h"

#include <algorithm>
#include <cmath>

#include "base/law_counter.h"
#include "base/prefault.h"
#include "evolve/flight.h"
#include "geometry/tolerances.h"
#include "methods/method.h"
#include "methods/release_squeezed.h"
#include "paddle/paddle_drive.h"
#include "ping_pong_sim/choose_method.h"
#include "state/free_space.h"
#include "state/squeeze.h"
#include "state/world_state.h"

namespace ping_pong
{
namespace
{
// Paddles that move are given a new motion at least so often, however long the tick.
constexpr double kLongestMotion = 5e-3;  // [s]

// Room for so many records from the start, more than a ball caught between paddle and table makes. If more happens in
// one tick makes the records grow, once: they keep what they have.
constexpr std::size_t kContactsInATick = 256;
constexpr std::size_t kContactsOfABall = 8;
constexpr std::size_t kBallsWithContacts = 1000;  // of more balls only so many have a record of their own kept free
constexpr std::size_t kBallsConstrained =
    1000;                               // of more balls fewer roll over edges and round or turning surfaces at once
constexpr std::size_t kManyBalls = 32;  // from here on a grid tells which balls may overlap

std::string refuseState(const BallState& state)
{
  if (!state.p_WB.allFinite()) return "position: not finite; expected three finite numbers [m]";
  if (!state.v_WB.allFinite()) return "velocity: not finite; expected three finite numbers [m/s]";
  if (!state.w_WB.allFinite()) return "spin: not finite; expected three finite numbers [rad/s]";
  if (!(std::abs(state.q_WB.norm() - 1.0) < 1e-6)) return "orientation: expected a quaternion of length 1";
  return {};
}

std::string refusePose(const Pose& pose)
{
  if (!pose.p.allFinite()) return "position: not finite; expected three finite numbers [m]";
  if (!(std::abs(pose.q.norm() - 1.0) < 1e-6)) return "orientation: expected a quaternion of length 1";
  return {};
}

BallState normalized(BallState state)
{
  state.q_WB.normalize();
  return state;
}

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

// Whether two balls overlap by more than half of what hasRoom() lets pass.
bool spheresOverlap(const BallRecord& a, const BallRecord& b, double time)
{
  const double reach = a.params().radius + b.params().radius - 0.5 * kOverlapTolerance;
  return (a.path.position(time - a.path.start) - b.path.position(time - b.path.start)).squaredNorm() < reach * reach;
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

struct World::Impl : WorldWithWindows
{
  using WorldWithWindows::WorldWithWindows;

  const MethodFunctions* functions = nullptr;  // of the method
  BallId next_id = 0;
  double time_rest = 0.0;           // what rounding took from time: N ticks of h end at N h
  std::vector<Obstacle> obstacles;  // of the window; this and the next are kept, so that no step allocates
  std::vector<ShapePair> near_obstacles;

  std::size_t space_for = 0;  // balls that there is memory for

  void choose(Method its_method);
  void start();
  void become(const Impl& model);
  void beginTick();
  BallRecord& add(const BallParams& params, const BallState& state);
  void remove(std::size_t index);
  double later(double duration);
  double movePaddles(double end);
  void makeSpace();
  void takeSpace();
  void ballChanged(std::size_t index);
  void detachFrom(std::size_t body);
  void collectStatus();
  void resolveOverlaps();
  std::vector<char> ballsThatOverlap();
};

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

void World::Impl::beginTick()
{
  contacts.clear();
  provenances.clear();
  status = StepStatus();
  for (BodyRecord& body : bodies) body.blocked = false;
}

BallRecord& World::Impl::add(const BallParams& params, const BallState& state)
{
  BallRecord& ball = balls.emplace_back(next_id++, types.of(params, scene.forces));
  ball.path = flyParabola(state, time, Vector3d::Zero());
  return ball;
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

void World::Impl::remove(std::size_t index)
{
  const BallType* type = balls[index].type;
  balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(index));
  const auto has_it = [type](const BallRecord& ball) { return ball.type == type; };
  if (std::none_of(balls.begin(), balls.end(), has_it)) types.forget(*type);
}

// Neumaier's compensated sum.
double World::Impl::later(double duration)
{
  const double with_rest = duration + time_rest;
  const double end = time + with_rest;
  time_rest = with_rest - (end - time);
  return end;
}

bool atWork(const BodyRecord& body)
{
  return body.body.kind == BodyKind::Kinematic && (body.moving || body.command.mode != PaddleCommand::Mode::Hold);
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

// After a body has jumped: balls that it covers are put on its surface, and push on others in turn. A ball that finds no room
// is squeezed, where it is. (In the contact solver balls may overlap a little, and push each other out.)
void World::Impl::resolveOverlaps()
{
  const std::vector<char> overlapping = ballsThatOverlap();
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const bool in_solver = balls[i].ofSolver();
    BallState state = balls[i].stateAt(time);
    const double radius = balls[i].params().radius;
    const bool free = in_solver        ? !overlapsABody(*this, state.p_WB, radius)
                      : overlapping[i] ? hasRoom(*this, state.p_WB, radius, i)
                                       : hasRoomAmongBodies(*this, state.p_WB, radius);
    if (free) continue;
    const BallState covered = state;
    const bool room = pushOut(*this, state.p_WB, radius, i);  // clear of all others: none is covered that was not
    if (room)
      balls[i].path = flyParabola(state, time, Vector3d::Zero());
    else if (!in_solver)
      squeeze(*this, balls[i], covered, time);
  }
}

// Balls that surely overlap no other one are left out; of few balls none is.
std::vector<char> World::Impl::ballsThatOverlap()
{
  std::vector<char> overlapping(balls.size(), balls.size() < kManyBalls);
  if (balls.size() < kManyBalls) return overlapping;
  BroadPhase& grid = islands.broad_phase;  // of the next window: its memory is there
  grid.build(
      balls.size(), [&](std::size_t i) { return boxOf(balls[i], time, time); }, workers);
  grid.eachPair(
      [&](std::uint32_t a, std::uint32_t b)
      {
        if (spheresOverlap(balls[a], balls[b], time)) overlapping[a] = overlapping[b] = true;
      });
  return overlapping;
}

// Balls on this body search anew for what carries them.
void World::Impl::detachFrom(std::size_t body)
{
  for (BallRecord& ball : balls)
  {
    bool lay_there = false;
    for (std::size_t i = 0; i < ball.supports.count(); ++i) lay_there |= ball.supports[i].body == body;
    if (lay_there) ball.supports = Supports();
  }
}

// Of those that cannot have any nobody is asked: thousands of records are a long way through memory.
void World::Impl::collectStatus()
{
  if (!any_squeezed && !flies_in_steps) return;
  for (const BallRecord& ball : balls)
  {
    status.squeezed += ball.squeezed();
    status.not_finite |= ball.overflows;
  }
}

World::World(std::shared_ptr<const Scene> scene) : impl_(std::make_unique<Impl>(std::move(scene)))
{
  impl_->start();
}
World::World(Scene scene) : World(std::make_shared<const Scene>(std::move(scene))) {}

World::World(const World& other) : impl_(std::make_unique<Impl>(other.impl_->loaded))
{
  impl_->become(*other.impl_);
}

World& World::operator=(const World& other)
{
  if (this == &other) return *this;
  if (impl_ == nullptr || impl_->loaded != other.impl_->loaded) return *this = World(other);
  impl_->become(*other.impl_);
  return *this;
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

StepStatus World::advance(double duration)
{
  Impl& world = *impl_;
  world.beginTick();
  if (!(duration > 0.0) || !std::isfinite(duration)) return world.status;
  const double end = world.later(duration);
  while (world.time < end)
  {
    const double next = world.movePaddles(end);
    world.functions->advance(world, next);
    world.time = next;
    releaseSqueezed(world);
  }
  world.status.piled = world.solver.ball.size();
  world.collectStatus();
  return world.status;
}

double World::time() const
{
  return impl_->time;
}
const Scene& World::scene() const
{
  return impl_->scene;
}
Method World::method() const
{
  return impl_->method;
}
const std::vector<Contact>& World::contacts() const
{
  return impl_->contacts;
}
void World::keepContacts(bool keep)
{
  impl_->keep_contacts = keep;
}

std::size_t World::ballCount() const
{
  return impl_->balls.size();
}
BallId World::ballId(std::size_t index) const
{
  return impl_->balls[index].id;
}

std::size_t World::findBall(BallId id) const
{
  const std::vector<BallRecord>& balls = impl_->balls;  // in the order of ids
  const auto found = std::lower_bound(balls.begin(), balls.end(), id,
                                      [](const BallRecord& ball, BallId wanted) { return ball.id < wanted; });
  return found != balls.end() && found->id == id ? static_cast<std::size_t>(found - balls.begin()) : kNone;
}

const BallParams& World::ballParams(std::size_t index) const
{
  return impl_->balls[index].params();
}
BallState World::ballState(std::size_t index) const
{
  return impl_->balls[index].stateAt(impl_->time);
}

bool World::resting(std::size_t index) const
{
  const BallRecord& ball = impl_->balls[index];
  if (ball.asleep()) return true;
  return !ball.supports.none() && ball.path.degree == 0 && ball.supports.since() <= impl_->time;
}

double World::restingSince(std::size_t index) const
{
  const BallRecord& ball = impl_->balls[index];
  return ball.supports.none() && !ball.asleep() ? std::nan("") : ball.supports.since();
}

std::size_t World::bodyCount() const
{
  return impl_->bodies.size();
}

std::size_t World::findBody(const std::string& name) const
{
  for (std::size_t i = 0; i < impl_->bodies.size(); ++i)
    if (impl_->bodies[i].body.name == name) return i;
  return kNone;
}

const Body& World::body(std::size_t index) const
{
  return impl_->bodies[index].body;
}

Pose World::bodyPose(std::size_t index) const
{
  const BodyMotion& motion = impl_->bodies[index].motion;
  return motion.poseAt(impl_->time - motion.start);
}

Twist World::bodyTwist(std::size_t index) const
{
  const BodyMotion& motion = impl_->bodies[index].motion;
  return motion.twistAt(impl_->time - motion.start);
}

const PaddleCommand& World::bodyCommand(std::size_t index) const
{
  return impl_->bodies[index].command;
}

Totals World::totals() const
{
  Totals sum;
  for (const BallRecord& ball : impl_->balls)
  {
    const BallState state = ball.stateAt(impl_->time);
    const double m = ball.params().mass;
    const double r = ball.params().radius;
    sum.kinetic += 0.5 * m * state.v_WB.squaredNorm();
    sum.rotational += 0.5 * (ball.params().inertia * m * r * r) * state.w_WB.squaredNorm();
    sum.potential -= m * impl_->scene.forces.gravity.dot(state.p_WB);
    sum.momentum += m * state.v_WB;
  }
  return sum;
}

Refusal World::command(std::size_t body, const PaddleCommand& command)
{
  if (body >= bodyCount()) return {"body: unknown index"};
  BodyRecord& record = impl_->bodies[body];
  if (record.body.kind != BodyKind::Kinematic) return {record.body.name + ": static; expected a kinematic body"};
  if (!command.a_W.allFinite() || !command.alpha_W.allFinite()) return {"acceleration: expected finite numbers"};
  if (!command.twist.v.allFinite() || !command.twist.w.allFinite()) return {"twist: expected finite numbers"};
  if (command.mode == PaddleCommand::Mode::Pose)
  {
    const std::string reason = refusePose(command.pose);
    if (!reason.empty()) return {reason};
  }
  record.command = command;
  return {};
}

Refusal World::spawnBall(const BallParams& params, const BallState& state, BallId* id)
{
  if (!(params.radius > 0.0) || !std::isfinite(params.radius)) return {"radius: expected a finite number > 0 [m]"};
  if (!(params.mass > 0.0) || !std::isfinite(params.mass)) return {"mass: expected a finite number > 0 [kg]"};
  if (params.material >= impl_->scene.materials.size()) return {"material: unknown index"};
  std::string reason = refuseState(state);
  if (!reason.empty()) return {reason};
  reason = describeOverlap(*impl_, state.p_WB, params.radius);
  if (!reason.empty()) return {"position: inside " + reason + "; expected a free place"};
  const BallRecord& ball = impl_->add(params, normalized(state));
  if (id) *id = ball.id;
  impl_->ballChanged(impl_->balls.size() - 1);
  return {};
}

Refusal World::deleteBall(BallId id)
{
  const std::size_t index = findBall(id);
  if (index == kNone) return {"ball: no ball_" + std::to_string(id)};
  if (!impl_->solver.ball.empty()) removeFromSolver(impl_->solver, static_cast<std::uint32_t>(index));
  ++impl_->edits;
  impl_->remove(index);
  return {};
}

Refusal World::setBallState(BallId id, const BallState& state)
{
  const std::size_t index = findBall(id);
  if (index == kNone) return {"ball: no ball_" + std::to_string(id)};
  std::string reason = refuseState(state);
  if (!reason.empty()) return {reason};
  BallRecord& ball = impl_->balls[index];
  reason = describeOverlap(*impl_, state.p_WB, ball.params().radius, index);
  if (!reason.empty()) return {"position: inside " + reason + "; expected a free place"};
  ball.supports = Supports();
  ball.path = flyParabola(normalized(state), impl_->time, Vector3d::Zero());
  impl_->ballChanged(index);
  return {};
}

Refusal World::setBodyPose(std::size_t body, const Pose& pose)
{
  if (body >= bodyCount()) return {"body: unknown index"};
  const std::string reason = refusePose(pose);
  if (!reason.empty()) return {reason};
  BodyRecord& record = impl_->bodies[body];
  record.command = PaddleCommand();
  placeBody(record, {pose.p, pose.q.normalized()});
  impl_->detachFrom(body);
  impl_->resolveOverlaps();
  impl_->functions->start(*impl_);
  return {};
}

void World::reset()
{
  impl_->start();
}
}  // namespace ping_pong
