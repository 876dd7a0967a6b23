#include "stepped_engine.h"

#include <cmath>
#include <exception>
#include <limits>

namespace ping_pong::bench
{
namespace
{
bool sameLaw(const Surface& a, const Surface& b)
{
  return a.restitution == b.restitution && a.friction == b.friction;
}

std::string refuseLaw(const Surface& law)
{
  if (law.restitution_slope != 0.0) return "its restitution does not depend on speed";
  if (law.tangential_restitution != 0.0) return "it has no tangential restitution";
  if (law.rolling_resistance != 0.0 || law.spin_friction != 0.0) return "rolling resistance is not mapped";
  return "";
}
}  // namespace

SteppedEngine::SteppedEngine(const Scene& scene, double step) : scene_(scene), step_(step)
{
  for (const SceneBall& ball : scene_.balls) flight_.emplace_back(scene_.forces, ball.params);
  for (const Body& body : scene_.bodies)
  {
    BodyMotion still;
    still.pose = body.pose;
    motions_.push_back(still);
  }
}

void SteppedEngine::drive(std::size_t body, const Twist& twist)
{
  const Pose now = poseAt(body, time());
  motions_[body] = BodyMotion();
  motions_[body].start = time();
  motions_[body].pose = now;
  motions_[body].twist = twist;
}

void SteppedEngine::advance(double duration)
{
  if (gave_up_) return;
  try
  {
    run(duration);
  }
  catch (const std::exception&)
  {
    gave_up_ = true;
  }
}

BallState SteppedEngine::ballState(std::size_t ball) const
{
  if (!gave_up_) return stateNow(ball);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BallState none;
  none.p_WB = none.v_WB = none.w_WB = Vector3d::Constant(nan);
  none.q_WB.coeffs().setConstant(nan);
  return none;
}

void SteppedEngine::run(double duration)
{
  const std::int64_t end = ticks_ + std::llround(duration / step_);
  for (; ticks_ < end; ++ticks_) stepOnce();
}

bool SteppedEngine::onlyGravity() const
{
  const Forces& forces = scene_.forces;
  return !forces.dependOnVelocity() && !forces.buoyancy && !forces.added_mass && forces.spin_decay == 0.0;
}

Vector3d SteppedEngine::flightForce(std::size_t ball, const BallState& state) const
{
  return scene_.balls[ball].params.mass * flight_[ball].acceleration(state.v_WB, state.w_WB);
}

Vector3d SteppedEngine::flightTorque(std::size_t ball, const BallState& state) const
{
  return -scene_.forces.spin_decay * inertiaOf(scene_.balls[ball].params) * state.w_WB;
}

Pose SteppedEngine::shapePose(std::size_t body, const Shape& shape, double when) const
{
  const Pose X_WB = poseAt(body, when);
  return {X_WB.p + X_WB.q * shape.p_BS, (X_WB.q * Quaterniond(shape.R_BS)).normalized()};
}

const Surface& ballLaw(const Scene& scene, std::size_t ball1, std::size_t ball2)
{
  return scene.surfaces.at(scene.balls[ball1].params.material, scene.balls[ball2].params.material);
}

const Surface& shapeLaw(const Scene& scene, std::size_t ball, const Shape& shape)
{
  return scene.surfaces.at(scene.balls[ball].params.material, shape.material);
}

SharedLaws sharedLaws(const Scene& scene)
{
  SharedLaws laws;
  if (scene.balls.size() > 1) laws.ball_ball = ballLaw(scene, 0, 1);
  for (std::size_t i = 1; i < scene.balls.size(); ++i)
    laws.shared = laws.shared && sameLaw(ballLaw(scene, 0, i), laws.ball_ball);
  for (const Body& body : scene.bodies)
  {
    laws.ball_shape.emplace_back();
    for (const Shape& shape : body.shapes)
    {
      laws.ball_shape.back().push_back(scene.balls.empty() ? Surface() : shapeLaw(scene, 0, shape));
      for (std::size_t i = 1; i < scene.balls.size(); ++i)
        laws.shared = laws.shared && sameLaw(shapeLaw(scene, i, shape), laws.ball_shape.back().back());
    }
  }
  return laws;
}

std::string refuseForAll(const Scene& scene)
{
  for (std::size_t i = 0; i < scene.balls.size(); ++i)
  {
    for (const Body& body : scene.bodies)
      for (const Shape& shape : body.shapes)
      {
        if (shape.kind != ShapeKind::Box && shape.kind != ShapeKind::HalfSpace)
          return "only boxes and planes are mapped";
        const std::string why = refuseLaw(shapeLaw(scene, i, shape));
        if (!why.empty()) return why;
      }
    if (scene.balls.size() > 1)
    {
      const std::string why = refuseLaw(ballLaw(scene, i, i == 0 ? 1 : 0));
      if (!why.empty()) return why;
    }
  }
  return "";
}
}  // namespace ping_pong::bench
