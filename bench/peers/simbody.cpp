// Simbody 3.7, "default": its time stepper for rigid contacts. Settings and reasons: README.md.
#include "simbody.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

#include "peers.h"

namespace ping_pong::bench
{
using SimTK::Vec3;

SimbodyBalls::SimbodyBalls(const Scene& scene) : matter(system), forces(system)
{
  for (const SceneBall& ball : scene.balls)
  {
    const SimTK::MassProperties mass(ball.params.mass, Vec3(0), SimTK::Inertia(inertiaOf(ball.params)));
    balls.emplace_back(matter.Ground(), SimTK::Transform(), SimTK::Body::Rigid(mass), SimTK::Transform());
  }
  system.setUseUniformBackground(true);
}

void SimbodyBalls::put(SimTK::State& state, std::size_t ball, const BallState& now) const
{
  const Quaterniond& q = now.q_WB;
  const SimTK::Rotation turn(SimTK::Quaternion(q.w(), q.x(), q.y(), q.z()));
  balls[ball].setQToFitTransform(state, SimTK::Transform(turn, toSimbody(now.p_WB)));
  balls[ball].setUToFitVelocity(state, SimTK::SpatialVec(toSimbody(now.w_WB), toSimbody(now.v_WB)));
}

BallState SimbodyBalls::get(const SimTK::State& state, std::size_t ball) const
{
  const SimTK::Quaternion q = balls[ball].getBodyRotation(state).convertRotationToQuaternion();
  BallState now;
  now.p_WB = fromSimbody(balls[ball].getBodyOriginLocation(state));
  now.q_WB = Quaterniond(q[0], q[1], q[2], q[3]);
  now.v_WB = fromSimbody(balls[ball].getBodyOriginVelocity(state));
  now.w_WB = fromSimbody(balls[ball].getBodyAngularVelocity(state));
  return now;
}

SimbodyFlight::SimbodyFlight(const Scene& scene, const SimbodyBalls& balls) : scene_(scene), balls_(balls)
{
  for (const SceneBall& ball : scene.balls) flight_.emplace_back(scene.forces, ball.params);
}

void SimbodyFlight::calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& on_bodies,
                              SimTK::Vector_<Vec3>&, SimTK::Vector&) const
{
  for (std::size_t i = 0; i < flight_.size(); ++i)
  {
    const BallParams& ball = scene_.balls[i].params;
    const BallState now = balls_.get(state, i);
    const Vector3d force = ball.mass * flight_[i].acceleration(now.v_WB, now.w_WB);
    const Vector3d torque = -scene_.forces.spin_decay * inertiaOf(ball) * now.w_WB;
    on_bodies[balls_.balls[i].getMobilizedBodyIndex()] += SimTK::SpatialVec(toSimbody(torque), toSimbody(force));
  }
}

namespace
{
constexpr double kAlwaysGrips = 1e6;

class SimbodyStepper : public SteppedEngine
{
public:
  SimbodyStepper(const Scene& scene, double step);

private:
  BallState stateNow(std::size_t ball) const override;
  void run(double duration) override;
  void stepOnce() override { stepper_->stepTo(time() + step_); }
  void addPlane(const Body& body, const Shape& shape);
  void addPairs();

  SimbodyBalls balls_;
  std::unique_ptr<SimTK::SemiExplicitEulerTimeStepper> stepper_;
};

SimbodyStepper::SimbodyStepper(const Scene& scene, double step) : SteppedEngine(scene, step), balls_(scene_)
{
  if (onlyGravity())
    SimTK::Force::UniformGravity(balls_.forces, balls_.matter, toSimbody(engineGravity()));
  else
    SimTK::Force::Custom(balls_.forces, new SimbodyFlight(scene_, balls_));
  for (const Body& body : scene_.bodies)
    for (const Shape& shape : body.shapes) addPlane(body, shape);
  addPairs();
  SimTK::State state = balls_.system.realizeTopology();
  for (std::size_t i = 0; i < scene_.balls.size(); ++i) balls_.put(state, i, scene_.balls[i].state);
  stepper_ = std::make_unique<SimTK::SemiExplicitEulerTimeStepper>(balls_.system);
  stepper_->initialize(state);
}

// Debian's build of this stepper tells on std::cout and stdout all that it does. With both closed, that costs least.
class Silence
{
public:
  Silence() : cout_(std::cout.rdstate())
  {
    std::cout.setstate(std::ios::failbit);
    std::fflush(stdout);
    stdout_ = dup(STDOUT_FILENO);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    close(nowhere);
  }
  ~Silence()
  {
    std::fflush(stdout);
    dup2(stdout_, STDOUT_FILENO);
    close(stdout_);
    std::cout.clear(cout_);
  }

private:
  const std::ios::iostate cout_;
  int stdout_;
};

void SimbodyStepper::run(double duration)
{
  const Silence silence;
  SteppedEngine::run(duration);
}

void SimbodyStepper::addPlane(const Body& body, const Shape& shape)
{
  const Vector3d n = body.pose.q * shape.R_BS.col(2);
  const double height = n.dot(body.pose.p + body.pose.q * shape.p_BS);
  for (std::size_t i = 0; i < balls_.balls.size(); ++i)
  {
    const Surface& law = shapeLaw(scene_, i, shape);
    const double mu = std::min(law.friction, kAlwaysGrips);
    balls_.matter.adoptUnilateralContact(
        new SimTK::SpherePlaneContact(balls_.matter.updGround(), SimTK::UnitVec3(toSimbody(n)), height, balls_.balls[i],
                                      Vec3(0), scene_.balls[i].params.radius, law.restitution, mu, mu, 0.0));
  }
}

void SimbodyStepper::addPairs()
{
  for (std::size_t i = 0; i < balls_.balls.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
    {
      const Surface& law = ballLaw(scene_, i, j);
      const double mu = std::min(law.friction, kAlwaysGrips);
      balls_.matter.adoptUnilateralContact(
          new SimTK::SphereSphereContact(balls_.balls[i], Vec3(0), scene_.balls[i].params.radius, balls_.balls[j],
                                         Vec3(0), scene_.balls[j].params.radius, law.restitution, mu, mu, 0.0));
    }
}

BallState SimbodyStepper::stateNow(std::size_t ball) const
{
  balls_.system.realize(stepper_->getState(), SimTK::Stage::Velocity);
  return balls_.get(stepper_->getState(), ball);
}

std::string refuse(const Scene& scene, const std::string& variant)
{
  if (scene.balls.size() > 64) return "it wants a contact or a witness for each pair";
  if (variant == "default")
    for (const Body& body : scene.bodies)
      for (const Shape& shape : body.shapes)
        if (shape.kind != ShapeKind::HalfSpace || body.kind != BodyKind::Static)
          return "its rigid contacts of spheres are with planes and spheres";
  return refuseForAll(scene);
}

std::unique_ptr<Engine> make(const Scene& scene, const std::string& variant, double step)
{
  if (variant == "best") return makeLocatedSimbody(scene, step);
  return std::make_unique<SimbodyStepper>(scene, step);
}
}  // namespace

EngineKind simbodyKind()
{
  return {"simbody", {"default", "best"}, refuse, make};
}
}  // namespace ping_pong::bench
