// DART 6.12, a free body for each ball. Settings and reasons: README.md.
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/constraint/ContactConstraint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/simulation/World.hpp>

#include "peers.h"
#include "stepped_engine.h"

namespace ping_pong::bench
{
namespace
{
namespace dd = dart::dynamics;

constexpr double kPlaneSize = 1e3;  // a half-space is a cube of this edge [m]: the exact detector knows no planes
constexpr double kDefaultErp = 0.01;
constexpr double kAlwaysGrips = 1e6;

Eigen::Isometry3d toDart(const Pose& pose)
{
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = pose.p;
  X.linear() = pose.q.toRotationMatrix();
  return X;
}

// DART multiplies restitution coefficients and takes the smaller friction: what each ball has, so that shapes can bring
// the rest.
struct BallCoefficients
{
  double restitution = 1.0;
  double friction = kAlwaysGrips;
};

BallCoefficients coefficientsOfBalls(const Scene& scene)
{
  if (scene.balls.size() < 2) return {};
  const Surface law = sharedLaws(scene).ball_ball;
  return {std::sqrt(law.restitution), std::min(law.friction, kAlwaysGrips)};
}

class DartEngine : public SteppedEngine
{
public:
  DartEngine(const Scene& scene, bool best, double step);

private:
  BallState stateNow(std::size_t ball) const override;
  void run(double duration) override;
  void stepOnce() override;
  dd::BodyNode* newBody(const Pose& pose);
  void addBall(std::size_t index);
  void addBody(std::size_t index);
  void moveDriven();
  void aimFriction(std::size_t ball);

  const bool best_;
  const BallCoefficients coefficients_;
  bool rough_ = false;  // any friction at all
  std::shared_ptr<dart::simulation::World> world_ = dart::simulation::World::create();
  std::vector<dd::BodyNode*> balls_, bodies_;
};

DartEngine::DartEngine(const Scene& scene, bool best, double step)
    : SteppedEngine(scene, step), best_(best), coefficients_(coefficientsOfBalls(scene))
{
  world_->setTimeStep(step);
  world_->setGravity(engineGravity());
  if (best) world_->getConstraintSolver()->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
  for (std::size_t i = 0; i < scene_.balls.size(); ++i) addBall(i);
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b) addBody(b);
}

dd::BodyNode* DartEngine::newBody(const Pose& pose)
{
  const dd::SkeletonPtr skeleton = dd::Skeleton::create("s" + std::to_string(balls_.size() + bodies_.size()));
  const auto pair = skeleton->createJointAndBodyNodePair<dd::FreeJoint>();
  pair.first->setTransform(toDart(pose));
  world_->addSkeleton(skeleton);  // the world keeps it alive
  return pair.second;
}

void DartEngine::addBall(std::size_t index)
{
  const SceneBall& ball = scene_.balls[index];
  dd::BodyNode* node = newBody({ball.state.p_WB, ball.state.q_WB});
  const double inertia = inertiaOf(ball.params);
  node->setInertia(dd::Inertia(ball.params.mass, Vector3d::Zero(), inertia * Matrix3d::Identity()));
  auto* shape = node->createShapeNodeWith<dd::CollisionAspect, dd::DynamicsAspect>(
      std::make_shared<dd::SphereShape>(ball.params.radius));
  shape->getDynamicsAspect()->setRestitutionCoeff(coefficients_.restitution);
  shape->getDynamicsAspect()->setFrictionCoeff(coefficients_.friction);
  auto* joint = static_cast<dd::FreeJoint*>(node->getParentJoint());
  joint->setLinearVelocity(ball.state.v_WB);
  joint->setAngularVelocity(ball.state.w_WB);
  balls_.push_back(node);
}

void DartEngine::addBody(std::size_t index)
{
  dd::BodyNode* node = newBody(scene_.bodies[index].pose);
  for (const Shape& shape : scene_.bodies[index].shapes)
  {
    const bool plane = shape.kind == ShapeKind::HalfSpace;
    const Vector3d half_size = plane ? Vector3d::Constant(0.5 * kPlaneSize) : shape.half_size;
    auto* part = node->createShapeNodeWith<dd::CollisionAspect, dd::DynamicsAspect>(
        std::make_shared<dd::BoxShape>(2.0 * half_size));
    Eigen::Isometry3d X_BS = Eigen::Isometry3d::Identity();
    X_BS.linear() = shape.R_BS;
    X_BS.translation() = shape.p_BS;
    if (plane) X_BS.translation() -= shape.R_BS.col(2) * half_size.z();
    part->setRelativeTransform(X_BS);
    const Surface law = scene_.balls.empty() ? Surface() : shapeLaw(scene_, 0, shape);
    if (law.restitution > 0.0)
      part->getDynamicsAspect()->setRestitutionCoeff(law.restitution / coefficients_.restitution);
    part->getDynamicsAspect()->setFrictionCoeff(std::min(law.friction, kAlwaysGrips));
    rough_ = rough_ || law.friction > 0.0;
  }
  node->getSkeleton()->setMobile(false);
  bodies_.push_back(node);
}

void DartEngine::moveDriven()
{
  for (std::size_t b = 0; b < bodies_.size(); ++b)
  {
    if (scene_.bodies[b].kind != BodyKind::Kinematic) continue;
    auto* joint = static_cast<dd::FreeJoint*>(bodies_[b]->getParentJoint());
    joint->setTransform(toDart(poseAt(b, time())));
    joint->setLinearVelocity(twistOf(b).v);
    joint->setAngularVelocity(twistOf(b).w);
  }
}

// DART's friction is a pyramid. With an edge along the slip it holds Coulomb's law for a ball that slides.
void DartEngine::aimFriction(std::size_t ball)
{
  const BallState state = stateNow(ball);
  const double radius = scene_.balls[ball].params.radius;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (const Shape& shape : scene_.bodies[b].shapes)
    {
      const Pose X_WB = poseAt(b, time());
      const Proximity near = proximity(shape, X_WB.q.conjugate() * (state.p_WB - X_WB.p));
      if (near.distance > radius + step_ * state.v_WB.norm()) continue;
      const Vector3d n = X_WB.q * near.normal, arm = -radius * n;
      const Vector3d v_WC = twistOf(b).v + twistOf(b).w.cross(state.p_WB + arm - X_WB.p);
      const Vector3d v = state.v_WB + state.w_WB.cross(arm) - v_WC;
      const Vector3d slip = v - v.dot(n) * n;
      if (slip.norm() < 1e-12) continue;
      dd::DynamicsAspect* aspect = balls_[ball]->getShapeNode(0)->getDynamicsAspect();
      aspect->setFirstFrictionDirectionFrame(dd::Frame::World());
      aspect->setFirstFrictionDirection(slip.normalized());
    }
}

void DartEngine::run(double duration)
{
  // Static in DART: another engine may have changed it.
  dart::constraint::ContactConstraint::setErrorReductionParameter(best_ ? 0.0 : kDefaultErp);
  SteppedEngine::run(duration);
}

void DartEngine::stepOnce()
{
  moveDriven();
  for (std::size_t i = 0; i < balls_.size(); ++i)
  {
    if (best_ && rough_) aimFriction(i);
    if (onlyGravity()) continue;
    const BallState state = stateNow(i);
    balls_[i]->addExtForce(flightForce(i, state));
    balls_[i]->addExtTorque(flightTorque(i, state));
  }
  world_->step();
}

BallState DartEngine::stateNow(std::size_t ball) const
{
  const dd::BodyNode& node = *balls_[ball];
  BallState state;
  state.p_WB = node.getTransform().translation();
  state.q_WB = Quaterniond(node.getTransform().linear());
  state.v_WB = node.getLinearVelocity();
  state.w_WB = node.getAngularVelocity();
  return state;
}

std::string refuse(const Scene& scene, const std::string&)
{
  const SharedLaws laws = sharedLaws(scene);
  if (!laws.shared) return "balls with different laws are not mapped";
  const BallCoefficients ball = coefficientsOfBalls(scene);
  for (const auto& body : laws.ball_shape)
    for (const Surface& law : body)
    {
      if (law.restitution > 0.0 && ball.restitution == 0.0)
        return "it multiplies coefficients: e = 0 between balls makes all 0";
      if (law.friction > ball.friction)
        return "it takes the smaller friction: balls cannot be smoother among themselves";
    }
  return refuseForAll(scene);
}
}  // namespace

EngineKind dartKind()
{
  return {"dart", {"default", "best"}, refuse, makeEngine<DartEngine>};
}
}  // namespace ping_pong::bench
