// Bullet 3.24, rigid bodies in maximal coordinates, double precision. Settings and reasons: README.md.
#include <btBulletDynamicsCommon.h>

#include "peers.h"
#include "stepped_engine.h"

namespace ping_pong::bench
{
namespace
{
constexpr double kAlwaysGrips = 1e6;  // Bullet computes with mu: infinity times no load is not a number

btVector3 toBullet(const Vector3d& v)
{
  return {v.x(), v.y(), v.z()};
}
Vector3d fromBullet(const btVector3& v)
{
  return {v.x(), v.y(), v.z()};
}
btTransform toBullet(const Pose& pose)
{
  return btTransform(btQuaternion(pose.q.x(), pose.q.y(), pose.q.z(), pose.q.w()), toBullet(pose.p));
}

class BulletEngine : public SteppedEngine
{
public:
  BulletEngine(const Scene& scene, bool best, double step);
  ~BulletEngine() override;
  void drive(std::size_t body, const Twist& twist) override;

private:
  BallState stateNow(std::size_t ball) const override;
  // A ball, or one shape of a body: Bullet's contact laws belong to objects, ours to shapes.
  struct Object
  {
    const BulletEngine* engine = nullptr;
    std::size_t ball = kNone;
    std::size_t body = kNone;
    const Shape* shape = nullptr;
    std::unique_ptr<btCollisionShape> geometry;
    std::unique_ptr<btRigidBody> rigid;
  };

  void stepOnce() override;
  void addBall(std::size_t index, bool best);
  void addShape(std::size_t body, const Shape& shape);
  void add(std::unique_ptr<Object> object, double mass, const btVector3& inertia, const Pose& pose);
  void makeBest();
  const Surface& law(const Object& a, const Object& b) const;
  static btScalar restitution(const btCollisionObject* a, const btCollisionObject* b);
  static btScalar friction(const btCollisionObject* a, const btCollisionObject* b);

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<Object>> objects_;  // balls first
};

BulletEngine::BulletEngine(const Scene& scene, bool best, double step) : SteppedEngine(scene, step)
{
  gCalculateCombinedRestitutionCallback = restitution;
  gCalculateCombinedFrictionCallback = friction;
  world_.setGravity(toBullet(engineGravity()));
  for (std::size_t i = 0; i < scene_.balls.size(); ++i) addBall(i, best);
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b)
    for (const Shape& shape : scene_.bodies[b].shapes) addShape(b, shape);
  if (best) makeBest();
}

BulletEngine::~BulletEngine()
{
  for (const auto& object : objects_) world_.removeRigidBody(object->rigid.get());
}

void BulletEngine::addBall(std::size_t index, bool best)
{
  const SceneBall& ball = scene_.balls[index];
  auto object = std::make_unique<Object>();
  object->ball = index;
  object->geometry = std::make_unique<btSphereShape>(ball.params.radius);
  const double inertia = inertiaOf(ball.params);
  add(std::move(object), ball.params.mass, btVector3(inertia, inertia, inertia), {ball.state.p_WB, ball.state.q_WB});
  btRigidBody& rigid = *objects_.back()->rigid;
  rigid.setLinearVelocity(toBullet(ball.state.v_WB));
  rigid.setAngularVelocity(toBullet(ball.state.w_WB));
  if (best) rigid.setFlags(0);  // no gyroscopic torque: a sphere has none
}

void BulletEngine::addShape(std::size_t body, const Shape& shape)
{
  auto object = std::make_unique<Object>();
  object->body = body;
  object->shape = &shape;
  if (shape.kind == ShapeKind::HalfSpace)
    object->geometry = std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), 0);
  else
    object->geometry = std::make_unique<btBoxShape>(toBullet(shape.half_size));
  add(std::move(object), 0.0, btVector3(0, 0, 0), shapePose(body, shape, 0.0));
  if (scene_.bodies[body].kind != BodyKind::Kinematic) return;
  btRigidBody& rigid = *objects_.back()->rigid;
  rigid.setCollisionFlags(rigid.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  rigid.setActivationState(DISABLE_DEACTIVATION);
}

void BulletEngine::add(std::unique_ptr<Object> object, double mass, const btVector3& inertia, const Pose& pose)
{
  object->engine = this;
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, object->geometry.get(), inertia);
  info.m_startWorldTransform = toBullet(pose);
  object->rigid = std::make_unique<btRigidBody>(info);
  object->rigid->setUserPointer(object.get());
  world_.addRigidBody(object->rigid.get());
  objects_.push_back(std::move(object));
}

void BulletEngine::makeBest()
{
  btContactSolverInfo& info = world_.getSolverInfo();
  info.m_restitutionVelocityThreshold = 0.0;
  info.m_erp = info.m_erp2 = 0.0;
  info.m_numIterations = 100;
  info.m_solverMode &= ~SOLVER_USE_WARMSTARTING;
  for (const auto& object : objects_)
  {
    object->rigid->setContactProcessingThreshold(0.0);
    object->rigid->setActivationState(DISABLE_DEACTIVATION);
  }
}

const Surface& BulletEngine::law(const Object& a, const Object& b) const
{
  if (a.shape) return shapeLaw(scene_, b.ball, *a.shape);
  return b.shape ? shapeLaw(scene_, a.ball, *b.shape) : ballLaw(scene_, a.ball, b.ball);
}

btScalar BulletEngine::restitution(const btCollisionObject* a, const btCollisionObject* b)
{
  const Object& first = *static_cast<const Object*>(a->getUserPointer());
  return first.engine->law(first, *static_cast<const Object*>(b->getUserPointer())).restitution;
}

btScalar BulletEngine::friction(const btCollisionObject* a, const btCollisionObject* b)
{
  const Object& first = *static_cast<const Object*>(a->getUserPointer());
  const double mu = first.engine->law(first, *static_cast<const Object*>(b->getUserPointer())).friction;
  return std::min(mu, kAlwaysGrips);
}

// Bullet takes the velocity of a kinematic body from where it was a step ago.
void BulletEngine::drive(std::size_t body, const Twist& twist)
{
  SteppedEngine::drive(body, twist);
  for (const auto& object : objects_)
    if (object->body == body)
      object->rigid->setInterpolationWorldTransform(toBullet(shapePose(body, *object->shape, time() - step_)));
}

void BulletEngine::stepOnce()
{
  for (std::size_t i = 0; !onlyGravity() && i < scene_.balls.size(); ++i)
  {
    const BallState state = stateNow(i);
    objects_[i]->rigid->applyCentralForce(toBullet(flightForce(i, state)));
    objects_[i]->rigid->applyTorque(toBullet(flightTorque(i, state)));
  }
  for (std::size_t i = scene_.balls.size(); i < objects_.size(); ++i)
    if (scene_.bodies[objects_[i]->body].kind == BodyKind::Kinematic)
      objects_[i]->rigid->setWorldTransform(toBullet(shapePose(objects_[i]->body, *objects_[i]->shape, time())));
  world_.stepSimulation(step_, 0);  // 0: one step of exactly this length
}

BallState BulletEngine::stateNow(std::size_t ball) const
{
  const btRigidBody& rigid = *objects_[ball]->rigid;
  const btQuaternion q = rigid.getOrientation();
  BallState state;
  state.p_WB = fromBullet(rigid.getCenterOfMassPosition());
  state.q_WB = Quaterniond(q.w(), q.x(), q.y(), q.z());
  state.v_WB = fromBullet(rigid.getLinearVelocity());
  state.w_WB = fromBullet(rigid.getAngularVelocity());
  return state;
}

std::string refuse(const Scene& scene, const std::string&)
{
  return refuseForAll(scene);
}
}  // namespace

EngineKind bulletKind()
{
  return {"bullet", {"default", "best"}, refuse, makeEngine<BulletEngine>};
}
}  // namespace ping_pong::bench
