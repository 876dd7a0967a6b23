// What the methods share: every ball, every body, and the records of the tick.
#pragma once

#include <vector>

#include "ping_pong_sim/contact.h"
#include "ping_pong_sim/detect.h"
#include "ping_pong_sim/scene.h"
#include "ping_pong_sim/segment.h"
#include "ping_pong_sim/support.h"
#include "ping_pong_sim/world.h"

namespace ping_pong
{
/// The next thing that happens to a ball.
struct Event
{
  enum class Kind
  {
    None,
    LookAgain,   ///< the search ended here without an answer
    LeaveFace,   ///< the path on the supporting surfaces ends
    HitBody,
    HitBall
  };
  Kind kind = Kind::None;
  double time = kNever;       ///< world time [s]
  std::size_t other = kNone;  ///< index of body or ball
  std::size_t shape = kNone;
  unsigned version = 0;       ///< of the other when this was foreseen: another one makes it void
};

/// A shape whose contacts are not looked for on this path: it continues a face that the ball slides over.
struct Passing
{
  std::size_t body = kNone;
  std::size_t shape = kNone;
  double until = 0.0;  ///< [s]
};

struct BallRecord
{
  BallId id = 0;
  BallParams params;
  Segment path;
  Supports supports;
  bool squeezed = false;
  double step = 0.0;  ///< length of the next piece of flight through air, 0: unknown [s]
  bool overflows = false;  ///< a step of fixed length from here has no finite end: the path goes straight on
  Event next;         ///< with still bodies and balls; holds until the path changes
  Event next_moving;  ///< with moving bodies; holds for this window
  unsigned version = 0;
  int streak = 0;                ///< contacts in quick succession, see exact_method.cpp
  int crush = 0;                 ///< contacts in even quicker succession
  double last_contact = -1e300;  ///< [s]
  Passing passing;

  BallState stateAt(double time) const { return path.state(time - path.start); }
};

struct BodyRecord
{
  Body body;
  BodyMotion motion;      ///< from its start on; still bodies have none
  PaddleCommand command;
  bool moving = false;
  bool moved = false;     ///< in the window before
  unsigned version = 0;
  std::vector<Shape> placed;  ///< the shapes in the world frame, for still bodies

  const std::vector<Shape>& shapes() const { return moving ? body.shapes : placed; }
  const BodyMotion& frame() const { return moving ? motion : kWorldFrame; }

  static const BodyMotion kWorldFrame;
};

struct WorldState
{
  Scene scene;
  double time = 0.0;  ///< [s]
  std::vector<BallRecord> balls;
  std::vector<BodyRecord> bodies;
  std::vector<FlightModel> models;  ///< of the sampled methods, one per ball
  std::vector<Contact> contacts;
  StepStatus status;

  const Surface& surface(const BallRecord& ball, const Shape& shape) const
  {
    return scene.surfaces.at(ball.params.material, shape.material);
  }
  const Surface& surface(const BallRecord& a, const BallRecord& b) const
  {
    return scene.surfaces.at(a.params.material, b.params.material);
  }
};

/// Puts a still body at a pose and flattens its shapes into the world frame.
void placeBody(BodyRecord& body, Pose pose);
}  // namespace ping_pong
