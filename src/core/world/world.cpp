// Queries, and changes from outside.
#include <algorithm>
#include <cmath>

#include "evolve/flight.h"
#include "state/free_space.h"
#include "world/world_impl.h"

namespace ping_pong
{
namespace
{
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
}  // namespace

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
