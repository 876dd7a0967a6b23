// An independent reference: a ball that rolls without slip over a smooth surface which may bend and move, in long double, by
// small steps of the classic Runge-Kutta method. It shares no code with the library, and no formulation: the state is place and
// spin; the velocity follows from them, and loads and friction never appear.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>

#include "ping_pong_sim/ball.h"

namespace ping_pong
{
using Real = long double;
using Vector3r = Eigen::Matrix<Real, 3, 1>;

/// Friction f acts on the rim: k ds/dt = -n x f with s = r w, and f = dv/dt - g up to a load along n. With no slip,
/// v = u + s x n, where u is the velocity of the touched point, that gives
///   (1 + k) ds/dt = n x (g - du/dt - s x dn/dt),
/// whose part along n is zero: the spin about the normal changes with n alone.
struct RollingReference
{
  struct State
  {
    Vector3r p = Vector3r::Zero(), s = Vector3r::Zero();
  };
  /// Of the surface where the ball at p touches it; the rates hold for a ball that moves with velocity v.
  struct Ground
  {
    Vector3r n, u = Vector3r::Zero();
    Vector3r dn = Vector3r::Zero(), du = Vector3r::Zero();
  };

  Real k = 2.0L / 3.0L;
  Vector3r gravity = Vector3r(0, 0, -9.81L);
  bool holds_spin =
      false;  ///< a torque about the normal keeps n.s zero, as it is at the start; for surfaces that do not turn
  std::function<Ground(Real t, const Vector3r& p, const Vector3r& v)> ground;

  Vector3r velocity(Real t, const State& at) const
  {
    const Ground here = ground(t, at.p, Vector3r::Zero());
    return here.u + at.s.cross(here.n);
  }

  /// N / m: it rolls as long as this is positive. From v = u + s x n, n.dv/dt = n.(du/dt + s x dn/dt).
  Real load(Real t, const State& at) const
  {
    const Ground here = ground(t, at.p, velocity(t, at));
    return here.n.dot(here.du + at.s.cross(here.dn) - gravity);
  }

  State rolled(State at, Real duration, int steps, Real t = 0.0L) const
  {
    const Real h = duration / steps;
    for (int i = 0; i < steps; ++i)
    {
      const Real now = t + h * i;
      const State d1 = rates(now, at), d2 = rates(now + h / 2, moved(at, d1, h / 2)),
                  d3 = rates(now + h / 2, moved(at, d2, h / 2)), d4 = rates(now + h, moved(at, d3, h));
      at.p += h / 6 * (d1.p + 2 * d2.p + 2 * d3.p + d4.p);
      at.s += h / 6 * (d1.s + 2 * d2.s + 2 * d3.s + d4.s);
    }
    return at;
  }

private:
  static State moved(const State& at, const State& rate, Real h) { return {at.p + h * rate.p, at.s + h * rate.s}; }

  State rates(Real t, const State& at) const
  {
    const Vector3r v = velocity(t, at);
    const Ground here = ground(t, at.p, v);
    State rate{v, here.n.cross(gravity - here.du - at.s.cross(here.dn)) / (1 + k)};
    if (holds_spin) rate.s -= at.s.dot(here.dn) * here.n;
    return rate;
  }
};

inline RollingReference::State rollingState(const BallState& state, double radius)
{
  return {state.p_WB.cast<Real>(), (radius * state.w_WB).cast<Real>()};
}

inline double distance(const Vector3d& a, const Vector3r& b)
{
  return static_cast<double>((a.cast<Real>() - b).norm());
}
}  // namespace ping_pong
