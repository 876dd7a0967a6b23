// What all peers share: the scene, the clock, the forces of flight and the motion of driven bodies.
#pragma once

#include "engines/engine.h"
#include "ping_pong_sim/motion.h"

namespace ping_pong::bench
{
/// A peer that moves on in steps of equal length.
class SteppedEngine : public Engine
{
public:
  SteppedEngine(const Scene& scene, double step);
  void drive(std::size_t body, const Twist& twist) override;
  /// An engine that gives up (throws) has no state from then on: ballState() is NaN.
  void advance(double duration) final;
  BallState ballState(std::size_t ball) const final;

protected:
  virtual BallState stateNow(std::size_t ball) const = 0;
  virtual void run(double duration);
  /// One step: balls feel flightForce() of the state that they have now; driven bodies are at poseNow().
  virtual void stepOnce() = 0;

  virtual double time() const { return static_cast<double>(ticks_) * step_; }  ///< [s]
  /// The engine's own gravity will do for every ball.
  bool onlyGravity() const;
  /// What the engine should have as its gravity; zero if flightForce() brings it [m/s^2].
  Vector3d engineGravity() const { return onlyGravity() ? scene_.forces.gravity : Vector3d::Zero(); }
  Vector3d flightForce(std::size_t ball, const BallState& state) const;   ///< gravity included [N]
  Vector3d flightTorque(std::size_t ball, const BallState& state) const;  ///< what slows the spin [N m]
  Pose poseAt(std::size_t body, double when) const { return motions_[body].poseAt(when - motions_[body].start); }
  const Twist& twistOf(std::size_t body) const { return motions_[body].twist; }
  /// Where a shape is now.
  Pose shapePose(std::size_t body, const Shape& shape, double when) const;

  const Scene scene_;
  const double step_;  ///< [s]

private:
  bool gave_up_ = false;
  std::int64_t ticks_ = 0;
  std::vector<FlightModel> flight_;  // by ball
  std::vector<BodyMotion> motions_;  // by body
};

/// Moment of inertia of a ball about its centre [kg m^2].
inline double inertiaOf(const BallParams& ball)
{
  return ball.inertia * ball.mass * ball.radius * ball.radius;
}

/// Law between two balls, or between a ball and a shape.
const Surface& ballLaw(const Scene& scene, std::size_t ball1, std::size_t ball2);
const Surface& shapeLaw(const Scene& scene, std::size_t ball, const Shape& shape);

/// One number per contact law of the scene is all that most engines know: e and mu of ball on body, and of ball on
/// ball.
struct SharedLaws
{
  bool shared = true;                            ///< all balls obey the same laws
  Surface ball_ball;                             ///< default if there is one ball only
  std::vector<std::vector<Surface>> ball_shape;  ///< by body and shape
};
SharedLaws sharedLaws(const Scene& scene);

/// Why no peer runs this scene: shapes and laws that only we have. Empty if they can.
std::string refuseForAll(const Scene& scene);

/// The "make" and "refuse" of most kinds.
template <class EngineType>
std::unique_ptr<Engine> makeEngine(const Scene& scene, const std::string& variant, double step)
{
  return std::make_unique<EngineType>(scene, variant == "best", step);
}
}  // namespace ping_pong::bench
