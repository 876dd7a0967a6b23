#include "play.h"

namespace ping_pong::stability
{
namespace
{
constexpr double kSameInstant = 1e-12;  // [s]
}

Scene withMethod(Scene scene, Method method, double dt)
{
  scene.method = method;
  scene.dt = dt;
  return scene;
}

double closingOf(const Contact& contact)
{
  return -contact.n_W.dot(contact.v_before - contact.v_other);
}

Play::Play(const RandomScene& drawn, Method method, double dt)
    : commands_(drawn.commands), world_(withMethod(drawn.scene, method, dt))
{
}

StepStatus Play::advance(double duration)
{
  for (; next_ < commands_.size() && commands_[next_].time <= world_.time() + kSameInstant; ++next_)
    world_.command(commands_[next_].body, commands_[next_].command);
  return world_.advance(duration);
}
}  // namespace ping_pong::stability
