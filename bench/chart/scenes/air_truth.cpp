#include "air_truth.h"

#include "testing/air_reference.h"

namespace ping_pong::bench
{
namespace
{
constexpr Real kStep = 16e-3L;  // [s]
constexpr int kLooks = 32;      // at the way of one step, for forbidden places

AirReference airOf(const Scene& scene)
{
  const Forces& forces = scene.forces;
  AirReference air;
  air.radius = scene.balls[0].params.radius;
  air.mass = scene.balls[0].params.mass;
  air.density = forces.air_density;
  air.gravity = forces.gravity.cast<Real>();
  const DragLaw law = forces.drag ? forces.drag_law : DragLaw::constant(0.0);
  const Real low = law.without_spin, high = law.with_spin, half = law.half_at;
  air.C_D = [=](Real S) { return low + (high - low) * S * S / (S * S + half * half); };
  const Real slope = forces.magnus ? forces.lift_law.slope : 0.0, saturation = forces.lift_law.saturation;
  air.C_L = [=](Real S) { return slope * S / (1.0L + saturation * S); };
  return air;
}

class Flight
{
public:
  explicit Flight(const AirTask& task)
      : task_(task),
        air_(airOf(*task.scene)),
        law_(task.scene->surfaces.at(0, 1)),
        inertia_(task.scene->balls[0].params.inertia),
        state_(stateOf(task.scene->balls[0].state))
  {
    path_.bounces = 0;
  }

  std::optional<TruePath> run()
  {
    const long count = std::lround(task_.duration / task_.sample_period);
    for (long i = 1; i <= count; ++i)
    {
      if (!flyUntil(static_cast<Real>(i) * task_.sample_period)) return std::nullopt;
      path_.samples.push_back({state_.p, state_.v, state_.w});
    }
    return path_;
  }

private:
  bool flyUntil(Real end)
  {
    while (time_ < end)
    {
      const Real left = end - time_;
      Real h = kStep / task_.refinement;
      if (h > left * (1.0L - 1e-12L)) h = left;
      const AirReference::State next = stepped(h);
      if (meetsForbidden(state_.p, next.p)) return false;
      if (land(next, h)) continue;
      state_ = next;
      time_ = h == left ? end : time_ + h;
    }
    return true;
  }

  // Without air a step is a formula.
  AirReference::State stepped(Real h) const
  {
    if (task_.scene->forces.dependOnVelocity()) return air_.step(state_, h);
    const Vector3r& g = air_.gravity;
    return {state_.p + h * state_.v + 0.5L * h * h * g, state_.v + h * g, state_.w};
  }

  bool meetsForbidden(const Vector3r& from, const Vector3r& to) const
  {
    for (int i = 1; task_.forbidden && i <= kLooks; ++i)
      if (task_.forbidden(from + static_cast<Real>(i) / kLooks * (to - from))) return true;
    return false;
  }

  // If the step of length h ends below ground: goes to the bounce instead.
  bool land(const AirReference::State& next, Real h)
  {
    for (const Ground& ground : task_.grounds)
    {
      const Real height = ground.height + air_.radius;
      if (next.v.z() >= 0.0L || next.p.z() > height || state_.p.z() < height) continue;
      Real part = h;  // Newton from the far side of the root
      for (int i = 0; i < 12; ++i)
      {
        const AirReference::State at = stepped(part);
        part -= (at.p.z() - height) / at.v.z();
      }
      AirReference::State at = stepped(part);
      if (std::abs(at.p.x()) > ground.half_x || std::abs(at.p.y()) > ground.half_y) continue;
      at.p.z() = height;  // the rest is rounding; above it the bounce would not be found twice
      air_.bounce(at, law_.restitution, law_.friction, law_.tangential_restitution, inertia_);
      state_ = at;
      time_ += part;
      path_.events.push_back(time_);
      ++path_.bounces;
      return true;
    }
    return false;
  }

  const AirTask& task_;
  AirReference air_;
  const Surface& law_;
  Real inertia_;
  AirReference::State state_;
  Real time_ = 0.0L;
  TruePath path_;
};
}  // namespace

std::optional<TruePath> airTruth(const AirTask& task)
{
  return Flight(task).run();
}
}  // namespace ping_pong::bench
