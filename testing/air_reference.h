// An independent reference: flight through air and bounces in long double, by extrapolation of Gragg's midpoint rule (Hairer,
// Norsett, Wanner, "Solving ODEs I", II.9). It shares no code with the library: forces and bounces are written out again.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "ping_pong_sim/scene.h"

namespace ping_pong
{
using Real = long double;
using Vector3r = Eigen::Matrix<Real, 3, 1>;

struct AirReference
{
  struct State
  {
    Vector3r p = Vector3r::Zero(), v = Vector3r::Zero(), w = Vector3r::Zero();
  };

  Real radius = 0.02L, mass = 2.7e-3L, density = 1.2041L, decay = 0.0L;
  Vector3r gravity = Vector3r::Zero(), wind = Vector3r::Zero();
  bool buoyancy = false, added_mass = false;
  std::function<Real(Real)> C_D = [](Real) { return 0.0L; };  // of the spin ratio
  std::function<Real(Real)> C_L = [](Real) { return 0.0L; };

  Vector3r acceleration(const Vector3r& v, const Vector3r& w) const
  {
    const Real pi = std::acos(-1.0L);
    const Real area = pi * radius * radius, volume = 4.0L / 3.0L * pi * radius * radius * radius;
    Vector3r force = (mass - (buoyancy ? density * volume : 0.0L)) * gravity;
    const Vector3r u = v - wind;
    const Real speed = u.norm(), turn = w.norm();
    if (speed > 0.0L) force -= 0.5L * density * area * C_D(radius * turn / speed) * speed * u;
    if (speed > 0.0L && turn > 0.0L)
      force += 0.5L * density * area * C_L(radius * turn / speed) * speed / turn * w.cross(u);
    return force / (mass + (added_mass ? 0.5L * density * volume : 0.0L));
  }

  State flown(State from, Real T, Real h = 4e-3L) const
  {
    const int steps = static_cast<int>(std::ceil(T / h));
    for (int i = 0; i < steps; ++i) from = step(from, T / steps);
    return from;
  }

  /// Time until the centre sinks below `height`; the state then is in `from`.
  Real fallTo(Real height, State& from, Real h = 4e-3L) const
  {
    Real time = 0.0L;
    for (State next = step(from, h); next.p.z() > height || next.v.z() > 0.0L; next = step(from, h))
    {
      from = next;
      time += h;
    }
    Real part = h;  // Newton from the far side of the root
    for (int i = 0; i < 12; ++i)
    {
      const State at = step(from, part);
      part -= (at.p.z() - height) / at.v.z();
    }
    from = step(from, part);
    return time + part;
  }

  /// On a horizontal surface at rest; k = I/(m r^2).
  void bounce(State& s, Real e, Real mu, Real e_t, Real k) const
  {
    const Real impulse = -(1.0L + e) * s.v.z();  // per mass
    Vector3r slip(s.v.x() - radius * s.w.y(), s.v.y() + radius * s.w.x(), 0.0L);
    Vector3r rub = -(1.0L + e_t) * k / (1.0L + k) * slip;
    if (rub.norm() > mu * impulse) rub *= mu * impulse / rub.norm();
    s.v += rub + Vector3r(0, 0, impulse);
    s.w += Vector3r(rub.y(), -rub.x(), 0.0L) / (k * radius);
  }

  /// Flight and bounces on the floor z = 0 until `end`, for a thin shell.
  State rally(State from, const Surface& law, Real end, int* bounces = nullptr) const
  {
    for (Real time = 0.0L;;)
    {
      State landed = from;
      const Real flight = fallTo(radius, landed);
      if (time + flight > end) return flown(from, end - time);
      time += flight;
      from = landed;
      bounce(from, law.restitution, law.friction, law.tangential_restitution, 2.0L / 3.0L);
      if (bounces) ++*bounces;
    }
  }

  State step(const State& from, Real h) const
  {
    constexpr int kColumns = 8;  // order 16
    State table[kColumns];
    for (int row = 0; row < kColumns; ++row)
    {
      State last = midpoint(from, h, 2 * (row + 1));
      for (int column = 1; column <= row; ++column)
      {
        const Real ratio = static_cast<Real>(row + 1) / static_cast<Real>(row + 1 - column);
        const State above = table[column - 1];
        table[column - 1] = last;
        last = mix(last, above, 1.0L / (ratio * ratio - 1.0L));
      }
      table[row] = last;
    }
    return table[kColumns - 1];
  }

private:
  static State mix(const State& a, const State& b, Real part)
  {
    return {a.p + part * (a.p - b.p), a.v + part * (a.v - b.v), a.w + part * (a.w - b.w)};
  }

  State moved(const State& s, const State& at, Real h) const
  {
    return {s.p + h * at.v, s.v + h * acceleration(at.v, at.w), s.w - h * decay * at.w};
  }

  State midpoint(const State& from, Real h, int n) const
  {
    const Real part = h / n;
    State before = from, now = moved(from, from, part);
    for (int i = 1; i < n; ++i)
    {
      const State next = moved(before, now, 2.0L * part);
      before = now;
      now = next;
    }
    return now;  // n even: an expansion in h^2 without smoothing
  }
};

inline AirReference::State stateOf(const BallState& state)
{
  return {state.p_WB.cast<Real>(), state.v_WB.cast<Real>(), state.w_WB.cast<Real>()};
}

inline double distance(const Vector3d& a, const Vector3r& b)
{
  return static_cast<double>((a.cast<Real>() - b).norm());
}
}  // namespace ping_pong
