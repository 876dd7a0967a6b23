// Open Dynamics Engine 0.16.2, double precision. Settings and reasons: README.md.
#include <ode/ode.h>

#include "peers.h"
#include "stepped_engine.h"

namespace ping_pong::bench
{
namespace
{
constexpr std::size_t kFew = 10;  // objects, up to which trying all pairs is cheapest
constexpr int kMaxContacts = 4;   // of one pair; a ball touches in one point

Vector3d fromOde(const dReal* v)
{
  return {v[0], v[1], v[2]};
}

void initOde()
{
  static const bool once = (dInitODE2(0), true);
  (void)once;
}

class OdeEngine : public SteppedEngine
{
public:
  OdeEngine(const Scene& scene, bool best, double step);
  ~OdeEngine() override;

private:
  BallState stateNow(std::size_t ball) const override;
  struct Object
  {
    std::size_t ball = kNone;
    std::size_t body = kNone;
    const Shape* shape = nullptr;
    dBodyID rigid = nullptr;  // none: static
    dGeomID geometry = nullptr;
  };

  void stepOnce() override;
  void addBall(std::size_t index);
  void addShape(std::size_t body, const Shape& shape);
  void place(const Object& object, const Pose& pose) const;
  void moveDriven();
  void touch(dGeomID a, dGeomID b);
  Vector3d slipAt(const dContactGeom& contact) const;
  static void near(void* engine, dGeomID a, dGeomID b) { static_cast<OdeEngine*>(engine)->touch(a, b); }

  const bool best_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  std::vector<std::unique_ptr<Object>> objects_;  // balls first
};

OdeEngine::OdeEngine(const Scene& scene, bool best, double step) : SteppedEngine(scene, step), best_(best)
{
  initOde();
  world_ = dWorldCreate();
  const bool few = scene_.balls.size() + scene_.bodies.size() < kFew;
  space_ = few ? dSimpleSpaceCreate(nullptr) : dHashSpaceCreate(nullptr);
  contacts_ = dJointGroupCreate(0);
  const Vector3d g = engineGravity();
  dWorldSetGravity(world_, g.x(), g.y(), g.z());
  if (best)
  {
    dWorldSetERP(world_, 0.0);
    dWorldSetCFM(world_, 0.0);
  }
  for (std::size_t i = 0; i < scene_.balls.size(); ++i) addBall(i);
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b)
    for (const Shape& shape : scene_.bodies[b].shapes) addShape(b, shape);
}

OdeEngine::~OdeEngine()
{
  dJointGroupDestroy(contacts_);
  dSpaceDestroy(space_);
  dWorldDestroy(world_);
}

void OdeEngine::place(const Object& object, const Pose& pose) const
{
  const dQuaternion q = {pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z()};
  dGeomSetPosition(object.geometry, pose.p.x(), pose.p.y(), pose.p.z());  // moves the body along, if any
  dGeomSetQuaternion(object.geometry, q);
}

void OdeEngine::addBall(std::size_t index)
{
  const SceneBall& ball = scene_.balls[index];
  auto object = std::make_unique<Object>();
  object->ball = index;
  object->rigid = dBodyCreate(world_);
  object->geometry = dCreateSphere(space_, ball.params.radius);
  dGeomSetBody(object->geometry, object->rigid);
  dGeomSetData(object->geometry, object.get());
  dMass mass;
  const double inertia = inertiaOf(ball.params);
  dMassSetParameters(&mass, ball.params.mass, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
  dBodySetMass(object->rigid, &mass);
  place(*object, {ball.state.p_WB, ball.state.q_WB});
  dBodySetLinearVel(object->rigid, ball.state.v_WB.x(), ball.state.v_WB.y(), ball.state.v_WB.z());
  dBodySetAngularVel(object->rigid, ball.state.w_WB.x(), ball.state.w_WB.y(), ball.state.w_WB.z());
  if (best_) dBodySetFiniteRotationMode(object->rigid, 1);
  if (best_) dBodySetGyroscopicMode(object->rigid, 0);  // a sphere has none
  objects_.push_back(std::move(object));
}

void OdeEngine::addShape(std::size_t body, const Shape& shape)
{
  auto object = std::make_unique<Object>();
  object->body = body;
  object->shape = &shape;
  const Pose pose = shapePose(body, shape, 0.0);
  if (shape.kind == ShapeKind::HalfSpace)
  {
    const Vector3d n = pose.q * Vector3d::UnitZ();
    object->geometry = dCreatePlane(space_, n.x(), n.y(), n.z(), n.dot(pose.p));
  }
  else
  {
    object->geometry = dCreateBox(space_, 2 * shape.half_size.x(), 2 * shape.half_size.y(), 2 * shape.half_size.z());
    if (scene_.bodies[body].kind == BodyKind::Kinematic)
    {
      object->rigid = dBodyCreate(world_);
      dBodySetKinematic(object->rigid);
      dGeomSetBody(object->geometry, object->rigid);
    }
    place(*object, pose);
  }
  dGeomSetData(object->geometry, object.get());
  objects_.push_back(std::move(object));
}

// The reference point of a shape's body is the shape itself: its velocity is that of its own origin.
void OdeEngine::moveDriven()
{
  for (std::size_t i = scene_.balls.size(); i < objects_.size(); ++i)
  {
    const Object& object = *objects_[i];
    if (!object.rigid) continue;
    const Pose pose = shapePose(object.body, *object.shape, time());
    const Twist& twist = twistOf(object.body);
    const Vector3d v = twist.v + twist.w.cross(pose.p - poseAt(object.body, time()).p);
    place(object, pose);
    dBodySetLinearVel(object.rigid, v.x(), v.y(), v.z());
    dBodySetAngularVel(object.rigid, twist.w.x(), twist.w.y(), twist.w.z());
  }
}

void OdeEngine::stepOnce()
{
  for (std::size_t i = 0; !onlyGravity() && i < scene_.balls.size(); ++i)
  {
    const BallState state = stateNow(i);
    const Vector3d force = flightForce(i, state), torque = flightTorque(i, state);
    dBodyAddForce(objects_[i]->rigid, force.x(), force.y(), force.z());
    dBodyAddTorque(objects_[i]->rigid, torque.x(), torque.y(), torque.z());
  }
  moveDriven();
  dSpaceCollide(space_, this, near);
  if (best_)
    dWorldStep(world_, step_);
  else
    dWorldQuickStep(world_, step_);
  dJointGroupEmpty(contacts_);
}

Vector3d OdeEngine::slipAt(const dContactGeom& contact) const
{
  Vector3d slip = Vector3d::Zero();
  const dGeomID sides[] = {contact.g1, contact.g2};
  for (int i = 0; i < 2; ++i)
  {
    const dBodyID rigid = dGeomGetBody(sides[i]);
    if (!rigid) continue;
    dVector3 v;
    dBodyGetPointVel(rigid, contact.pos[0], contact.pos[1], contact.pos[2], v);
    slip += (i == 0 ? 1.0 : -1.0) * fromOde(v);
  }
  const Vector3d n = fromOde(contact.normal);
  return slip - slip.dot(n) * n;
}

void OdeEngine::touch(dGeomID a, dGeomID b)
{
  const Object& first = *static_cast<const Object*>(dGeomGetData(a));
  const Object& second = *static_cast<const Object*>(dGeomGetData(b));
  if (first.shape && second.shape) return;
  const Surface& law = first.shape    ? shapeLaw(scene_, second.ball, *first.shape)
                       : second.shape ? shapeLaw(scene_, first.ball, *second.shape)
                                      : ballLaw(scene_, first.ball, second.ball);
  dContactGeom found[kMaxContacts];
  const int count = dCollide(a, b, kMaxContacts, found, sizeof(dContactGeom));
  for (int i = 0; i < count; ++i)
  {
    dContact contact = {};
    contact.geom = found[i];
    contact.surface.mode = dContactBounce | dContactApprox1;  // approx1: mu is Coulomb's, not a force
    contact.surface.bounce = law.restitution;
    contact.surface.mu = std::isfinite(law.friction) ? law.friction : dInfinity;
    const Vector3d slip = slipAt(found[i]);
    if (best_ && law.friction > 0.0 && slip.norm() > 1e-12)
    {
      contact.surface.mode |= dContactFDir1;
      for (int k = 0; k < 3; ++k) contact.fdir1[k] = slip[k] / slip.norm();
    }
    dJointAttach(dJointCreateContact(world_, contacts_, &contact), dGeomGetBody(a), dGeomGetBody(b));
  }
}

BallState OdeEngine::stateNow(std::size_t ball) const
{
  const dBodyID rigid = objects_[ball]->rigid;
  const dReal* q = dBodyGetQuaternion(rigid);
  BallState state;
  state.p_WB = fromOde(dBodyGetPosition(rigid));
  state.q_WB = Quaterniond(q[0], q[1], q[2], q[3]);
  state.v_WB = fromOde(dBodyGetLinearVel(rigid));
  state.w_WB = fromOde(dBodyGetAngularVel(rigid));
  return state;
}

std::string refuse(const Scene& scene, const std::string&)
{
  for (const Body& body : scene.bodies)
    for (const Shape& shape : body.shapes)
      if (body.kind == BodyKind::Kinematic && shape.kind == ShapeKind::HalfSpace) return "its planes cannot move";
  return refuseForAll(scene);
}
}  // namespace

EngineKind odeKind()
{
  return {"ode", {"default", "best"}, refuse, makeEngine<OdeEngine>};
}
}  // namespace ping_pong::bench
