// Simbody 3.7, "best": an integrator with error control, and every impact an event located in time. Reasons: README.md.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ping_pong_sim/resolve.h"
#include "simbody.h"

namespace ping_pong::bench
{
namespace
{
// After an impact the gap must be positive to fall through zero again: a little more than its rounding [m].
double clearance(const Vector3d& p)
{
  return 1e-15 * (1.0 + p.norm());
}

constexpr double kLongestStep = 0.05;  // [s]
constexpr double kFallTime = 1.0;      // balls are expected to gain the speed of a fall that long [s]
constexpr double kDriveSpeed = 10.0;   // driven bodies are expected to be that fast [m/s]
constexpr int kMaxEvents = 1000000;    // in one advance(): then it gives up
constexpr double kCapture = 1e-5;   // slower than this after an impact, a ball stays on a body that stands still [m/s]
constexpr double kTouching = 1e-8;  // gap below which it does [m]
constexpr double kStick = 1e-4;     // slip at which friction on a body that carries the ball is 0.7 of mu [m/s]

// A witness that dips below zero and returns within a step is not seen: where a ball can pass through something, it may
// not move by more than its radius.
double longestStep(const Scene& scene)
{
  bool thin = scene.balls.size() > 1;
  double speed = kFallTime * scene.forces.gravity.norm();
  for (const Body& body : scene.bodies)
  {
    for (const Shape& shape : body.shapes) thin = thin || shape.kind != ShapeKind::HalfSpace;
    if (body.kind == BodyKind::Kinematic) speed = kFallTime * scene.forces.gravity.norm() + kDriveSpeed;
  }
  if (!thin) return kLongestStep;
  double longest = kLongestStep;
  for (const SceneBall& ball : scene.balls)
    longest = std::min(longest, ball.params.radius / (speed + ball.state.v_WB.norm() + 1e-3));
  return longest;
}

// The clock of this engine is the integrator's own. Its accuracy is the `step`.
class LocatedSimbody : public SteppedEngine
{
public:
  LocatedSimbody(const Scene& scene, double tolerance);

  // Gap between two surfaces [m], and what happens when it closes.
  double gap(const SimTK::State& state, std::size_t ball, std::size_t body, const Shape& shape) const;
  double gap(const SimTK::State& state, std::size_t ball1, std::size_t ball2) const;
  void hit(SimTK::State& state, std::size_t ball, std::size_t body, const Shape& shape) const;
  void hit(SimTK::State& state, std::size_t ball1, std::size_t ball2) const;
  void addForces(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& on_bodies) const;

private:
  BallState stateNow(std::size_t ball) const override;
  struct Support
  {
    std::size_t body = kNone;
    const Shape* shape = nullptr;  // nullptr: none
  };
  double time() const override { return now_; }
  void run(double duration) override;
  void stepOnce() override {}
  void count() const;
  void addWitnesses(double tolerance);
  void supportAtStart(SimTK::State& state) const;
  Proximity proximityTo(const SimTK::State& state, std::size_t ball, std::size_t body, const Shape& shape) const;
  Vector3d centre(const SimTK::State& state, std::size_t ball) const
  {
    return fromSimbody(balls_.balls[ball].getBodyOriginLocation(state));
  }

  SimbodyBalls balls_;
  std::unique_ptr<SimTK::RungeKuttaMersonIntegrator> integrator_;
  std::unique_ptr<SimTK::TimeStepper> stepper_;
  mutable std::vector<Support> supports_;  // by ball; handlers of events are const
  mutable int events_ = 0;                 // of this advance()
  double now_ = 0.0;                       // [s]
};

class AllForces : public SimTK::Force::Custom::Implementation
{
public:
  explicit AllForces(const LocatedSimbody& engine) : engine_(engine) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& on_bodies, SimTK::Vector_<SimTK::Vec3>&,
                 SimTK::Vector&) const override
  {
    engine_.addForces(state, on_bodies);
  }
  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0.0; }

private:
  const LocatedSimbody& engine_;
};

// The gap as Simbody's witness: it falls through zero at an impact.
template <class Gap, class Hit>
class Witness : public SimTK::TriggeredEventHandler
{
public:
  Witness(Gap gap, Hit hit, double window) : TriggeredEventHandler(SimTK::Stage::Position), gap_(gap), hit_(hit)
  {
    getTriggerInfo().setTriggerOnRisingSignTransition(false);
    getTriggerInfo().setRequiredLocalizationTimeWindow(window);
  }
  SimTK::Real getValue(const SimTK::State& state) const override { return gap_(state); }
  void handleEvent(SimTK::State& state, SimTK::Real, bool&) const override { hit_(state); }

private:
  const Gap gap_;
  const Hit hit_;
};

template <class Gap, class Hit>
SimTK::TriggeredEventHandler* newWitness(Gap gap, Hit hit, double window)
{
  return new Witness<Gap, Hit>(gap, hit, window);
}

LocatedSimbody::LocatedSimbody(const Scene& scene, double tolerance)
    : SteppedEngine(scene, tolerance), balls_(scene_), supports_(scene_.balls.size())
{
  bool driven = false;
  for (const Body& body : scene_.bodies) driven = driven || body.kind == BodyKind::Kinematic;
  SimTK::Force::Custom(balls_.forces, new AllForces(*this));
  addWitnesses(tolerance);
  SimTK::State state = balls_.system.realizeTopology();
  for (std::size_t i = 0; i < scene_.balls.size(); ++i) balls_.put(state, i, scene_.balls[i].state);
  supportAtStart(state);
  integrator_ = std::make_unique<SimTK::RungeKuttaMersonIntegrator>(balls_.system);
  integrator_->setAccuracy(tolerance);
  integrator_->setMaximumStepSize(longestStep(scene_));
  integrator_->setAllowInterpolation(!driven);  // else it may be past the instant at which a body is driven anew
  stepper_ = std::make_unique<SimTK::TimeStepper>(balls_.system, *integrator_);
  stepper_->initialize(state);
}

void LocatedSimbody::addWitnesses(double tolerance)
{
  using SimTK::State;
  const double window = tolerance;  // time window of an event, in units of 0.1 s and of the accuracy
  for (std::size_t i = 0; i < scene_.balls.size(); ++i)
  {
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b)
      for (const Shape& shape : scene_.bodies[b].shapes)
        balls_.system.addEventHandler(
            newWitness([this, i, b, &shape](const State& state) { return gap(state, i, b, shape); },
                       [this, i, b, &shape](State& state) { hit(state, i, b, shape); }, window));
    for (std::size_t j = 0; j < i; ++j)
      balls_.system.addEventHandler(newWitness([this, i, j](const State& state) { return gap(state, i, j); },
                                               [this, i, j](State& state) { hit(state, i, j); }, window));
  }
}

Proximity LocatedSimbody::proximityTo(const SimTK::State& state, std::size_t ball, std::size_t body,
                                      const Shape& shape) const
{
  const Pose X_WB = poseAt(body, state.getTime());
  Proximity near = proximity(shape, X_WB.q.conjugate() * (centre(state, ball) - X_WB.p));
  near.normal = X_WB.q * near.normal;
  return near;
}

double LocatedSimbody::gap(const SimTK::State& state, std::size_t ball, std::size_t body, const Shape& shape) const
{
  return proximityTo(state, ball, body, shape).distance - scene_.balls[ball].params.radius;
}

double LocatedSimbody::gap(const SimTK::State& state, std::size_t ball1, std::size_t ball2) const
{
  const double reach = scene_.balls[ball1].params.radius + scene_.balls[ball2].params.radius;
  return (centre(state, ball1) - centre(state, ball2)).norm() - reach;
}

// Simbody leaves the impact law to its user.
void LocatedSimbody::hit(SimTK::State& state, std::size_t ball, std::size_t body, const Shape& shape) const
{
  count();
  balls_.system.realize(state, SimTK::Stage::Velocity);
  const BallParams& params = scene_.balls[ball].params;
  const Proximity near = proximityTo(state, ball, body, shape);
  BallState now = balls_.get(state, ball);
  const Vector3d touched = now.p_WB - params.radius * near.normal;
  const Vector3d u_WC = twistOf(body).v + twistOf(body).w.cross(touched - poseAt(body, state.getTime()).p);
  bounce(shapeLaw(scene_, ball, shape), params, now, u_WC, near.normal);
  const double leaving = (now.v_WB - u_WC).dot(near.normal);
  if (scene_.bodies[body].kind == BodyKind::Static && leaving >= 0.0 && leaving < kCapture)
  {
    supports_[ball] = {body, &shape};
    now.v_WB -= leaving * near.normal;
  }
  now.p_WB += (params.radius + clearance(now.p_WB) - near.distance) * near.normal;
  balls_.put(state, ball, now);
}

void LocatedSimbody::hit(SimTK::State& state, std::size_t ball1, std::size_t ball2) const
{
  count();
  balls_.system.realize(state, SimTK::Stage::Velocity);
  BallState state1 = balls_.get(state, ball1), state2 = balls_.get(state, ball2);
  const Vector3d n = (state1.p_WB - state2.p_WB).normalized();
  const double closing = (state2.v_WB - state1.v_WB).dot(n);
  if (closing <= 0.0) return;
  supports_[ball1] = supports_[ball2] = {};
  const Surface& law = ballLaw(scene_, ball1, ball2);
  const double overlap = 2.0 * clearance(state1.p_WB) - gap(state, ball1, ball2);
  part(law, law.restitution * closing, scene_.balls[ball1].params, state1, scene_.balls[ball2].params, state2, n);
  state1.p_WB += 0.5 * overlap * n;
  state2.p_WB -= 0.5 * overlap * n;
  balls_.put(state, ball1, state1);
  balls_.put(state, ball2, state2);
}

// Impacts that follow each other ever faster would keep it busy for ever.
void LocatedSimbody::count() const
{
  if (++events_ > kMaxEvents) throw std::runtime_error("too many impacts");
}

void LocatedSimbody::supportAtStart(SimTK::State& state) const
{
  balls_.system.realize(state, SimTK::Stage::Velocity);
  for (std::size_t i = 0; i < scene_.balls.size(); ++i)
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b)
      for (const Shape& shape : scene_.bodies[b].shapes)
        if (gap(state, i, b, shape) < kTouching) hit(state, i, b, shape);
}

// Flight; and for a ball that a body carries, its support and Coulomb friction, smoothed at vanishing slip.
void LocatedSimbody::addForces(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& on_bodies) const
{
  for (std::size_t i = 0; i < scene_.balls.size(); ++i)
  {
    const BallState now = balls_.get(state, i);
    Vector3d force = flightForce(i, now), torque = flightTorque(i, now);
    const Support& support = supports_[i];
    const Proximity near = support.shape ? proximityTo(state, i, support.body, *support.shape) : Proximity();
    const double radius = scene_.balls[i].params.radius;
    if (support.shape && near.distance - radius < kTouching)
    {
      const double load = std::max(0.0, -force.dot(near.normal));
      const Vector3d arm = -radius * near.normal, v = now.v_WB + now.w_WB.cross(arm);
      const Vector3d slip = v - v.dot(near.normal) * near.normal;
      const double mu = shapeLaw(scene_, i, *support.shape).friction;
      const Vector3d friction = -mu * load * slip / std::hypot(slip.norm(), kStick);
      force += load * near.normal + friction;
      torque += arm.cross(friction);
    }
    on_bodies[balls_.balls[i].getMobilizedBodyIndex()] += SimTK::SpatialVec(toSimbody(torque), toSimbody(force));
  }
}

void LocatedSimbody::run(double duration)
{
  events_ = 0;
  now_ += duration;
  stepper_->stepTo(now_);
}

BallState LocatedSimbody::stateNow(std::size_t ball) const
{
  balls_.system.realize(stepper_->getState(), SimTK::Stage::Velocity);
  return balls_.get(stepper_->getState(), ball);
}
}  // namespace

std::unique_ptr<Engine> makeLocatedSimbody(const Scene& scene, double tolerance)
{
  return std::make_unique<LocatedSimbody>(scene, tolerance);
}
}  // namespace ping_pong::bench
