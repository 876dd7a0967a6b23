// The world: balls and bodies in time. advance() is the sentence that joins evolve, detect and resolve.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ping_pong_sim/contact.h"
#include "ping_pong_sim/scene.h"
#include "ping_pong_sim/step_status.h"

namespace ping_pong
{
/// Sums over all balls. Potential energy is zero at the world's origin.
struct Totals
{
  double kinetic = 0.0;                  ///< translation [J]
  double rotational = 0.0;               ///< spin, I = k m r^2 [J]
  double potential = 0.0;                ///< -m g.p [J]
  Vector3d momentum = Vector3d::Zero();  ///< [kg m/s]
  double energy() const { return kinetic + rotational + potential; }
};

/// Answer of calls that change the world from outside. Empty reason: done; else nothing was changed.
struct Refusal
{
  std::string reason;
  explicit operator bool() const { return !reason.empty(); }
};

class World
{
public:
  explicit World(Scene scene);
  explicit World(
      std::shared_ptr<const Scene> scene);  ///< not null. The same without a copy: balls of a scene take 160 B each
  ~World();
  /// A copy goes on with the same bits as its model, and neither feels what is done to the other. All that a world has is
  /// copied, contacts() of the last tick and keepContacts() included; the scene is shared, since it does not change. Threads
  /// are not: a copy starts as many of its own, so that who makes many copies wants a scene with one thread.
  /// Cost: 3 us for scene `rally`, 0.2 ms for a thousand balls, with the memory that advance() will not ask for later. Assigned
  /// to a world of the same scene a copy takes the memory that is there: 1 us and 0.07 ms. Copying only reads `other`: several
  /// threads may do it at a time.
  World(const World& other);
  World& operator=(const World& other);
  World(World&&) noexcept;  ///< of what was moved from, destruction and assignment are left
  World& operator=(World&&) noexcept;

  /// Moves everything on by `duration` [s]; nothing happens if it is not finite and > 0. One call is one tick: paddles follow
  /// their commands, balls fly, collide, rest. While a paddle is at work the tick is cut into equal pieces of at most 5 ms, and
  /// shorter where a paddle meets a static body. In each piece every paddle has one smooth motion (BodyMotion), at whose end it
  /// is as near to its command as its limits allow: without limits a commanded velocity is reached in the first piece, however
  /// long the tick.
  StepStatus advance(double duration);

  double time() const;                           ///< since the start or reset [s]
  const Scene& scene() const;                    ///< as loaded; reset() returns to it
  Method method() const;                         ///< in use: the scene's, or what its Auto came to
  const std::vector<Contact>& contacts() const;  ///< of the last advance(), in order of time
  /// Whether contacts() lists them; it does by default. Without, StepStatus still counts them, and a bounce costs less.
  void keepContacts(bool keep);

  std::size_t ballCount() const;
  BallId ballId(std::size_t index) const;
  std::size_t findBall(BallId id) const;  ///< index, or kNone
  const BallParams& ballParams(std::size_t index) const;
  BallState ballState(std::size_t index) const;  ///< at time()
  bool resting(std::size_t index) const;         ///< lies still on something, exactly
  double restingSince(
      std::size_t index) const;  ///< world time at which it stopped bouncing, lying or rolling [s]; NaN while it flies

  std::size_t bodyCount() const;
  std::size_t findBody(const std::string& name) const;  ///< index, or kNone
  const Body& body(std::size_t index) const;
  Pose bodyPose(std::size_t index) const;
  Twist bodyTwist(std::size_t index) const;
  const PaddleCommand& bodyCommand(std::size_t index) const;  ///< what the body obeys now; static bodies hold

  Totals totals() const;

  // Changes from outside, between ticks. All values are checked; a refusal changes nothing.
  Refusal command(std::size_t body, const PaddleCommand& command);
  Refusal spawnBall(const BallParams& params, const BallState& state, BallId* id = nullptr);
  Refusal deleteBall(BallId id);
  Refusal setBallState(BallId id, const BallState& state);
  /// A jump, not a motion: nothing is hit; balls that the body would cover are put on its surface. A paddle holds still after it.
  Refusal setBodyPose(std::size_t body, const Pose& pose);
  void reset();  ///< to the start of the scene, its motions included; commands are forgotten

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};
}  // namespace ping_pong
